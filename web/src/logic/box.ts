/** An axis-parallel box, mm. An empty one has min above max. */
export interface Box {
  min: [number, number, number];
  max: [number, number, number];
}

export const empty_box = (): Box => ({
  min: [Infinity, Infinity, Infinity],
  max: [-Infinity, -Infinity, -Infinity],
});

export const is_empty = (box: Box): boolean => box.min[0] > box.max[0];

export function grow(box: Box, x: number, y: number, z: number): void {
  if (x < box.min[0]) box.min[0] = x;
  if (y < box.min[1]) box.min[1] = y;
  if (z < box.min[2]) box.min[2] = z;
  if (x > box.max[0]) box.max[0] = x;
  if (y > box.max[1]) box.max[1] = y;
  if (z > box.max[2]) box.max[2] = z;
}

export function join(box: Box, other: Box): void {
  if (is_empty(other)) return;
  grow(box, ...other.min);
  grow(box, ...other.max);
}

export const size = (box: Box): [number, number, number] => [
  box.max[0] - box.min[0],
  box.max[1] - box.min[1],
  box.max[2] - box.min[2],
];

export const diagonal = (box: Box): number => (is_empty(box) ? 0 : Math.hypot(...size(box)));
