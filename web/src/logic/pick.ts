/** Which segment of the path lies under the pointer: the nearest one within reach on the screen, in front of others. */
import type { Box } from './box';
import type { Block, PathStore } from './path_store';
import { Kind } from './chunk';

/** Column-major 4 x 4, from machine coordinates to the square -1 … 1 of the screen (without perspective). */
export type Matrix = ArrayLike<number>;

export interface Aim {
  matrix: Matrix;
  width: number;
  height: number;
  x: number;
  y: number;
  reach_px: number;
}

export interface Hit {
  chunk: number;
  /** The segment that ends here. */
  vertex: number;
  distance_px: number;
}

const SAME_PLACE_PX = 1.5;

export function pick(store: PathStore, aim: Aim): Hit | null {
  let best: (Hit & { depth: number }) | null = null;
  for (const block of store.blocks) {
    if (!may_touch(block.box, aim)) continue;
    best = nearest_of(block, store, aim, best);
  }
  return best && { chunk: best.chunk, vertex: best.vertex, distance_px: best.distance_px };
}

type Found = Hit & { depth: number };

function nearest_of(block: Block, store: PathStore, aim: Aim, best: Found | null): Found | null {
  const { chunk } = block;
  const index = store.chunks.indexOf(chunk);
  let from = to_screen(chunk.xyz, 3 * block.first, aim);
  for (let i = block.first + 1; i <= block.last; i++) {
    const to = to_screen(chunk.xyz, 3 * i, aim);
    if (chunk.kind[i] !== Kind.none) {
      const { distance, depth } = point_to_segment(aim, from, to);
      const found = { chunk: index, vertex: i, distance_px: distance, depth };
      if (distance <= aim.reach_px && is_better(found, best)) best = found;
    }
    from = to;
  }
  return best;
}

function is_better(found: Found, best: Found | null): boolean {
  if (!best) return true;
  const nearer = best.distance_px - found.distance_px;
  return nearer > SAME_PLACE_PX || (nearer > -SAME_PLACE_PX && found.depth < best.depth);
}

type Spot = [number, number, number];

function to_screen(xyz: ArrayLike<number>, at: number, aim: Aim): Spot {
  const m = aim.matrix;
  const x = xyz[at];
  const y = xyz[at + 1];
  const z = xyz[at + 2];
  return [
    (0.5 + 0.5 * (m[0] * x + m[4] * y + m[8] * z + m[12])) * aim.width,
    (0.5 - 0.5 * (m[1] * x + m[5] * y + m[9] * z + m[13])) * aim.height,
    m[2] * x + m[6] * y + m[10] * z + m[14],
  ];
}

function point_to_segment(aim: Aim, a: Spot, b: Spot): { distance: number; depth: number } {
  const dx = b[0] - a[0];
  const dy = b[1] - a[1];
  const length2 = dx * dx + dy * dy;
  const t = length2 > 0 ? ((aim.x - a[0]) * dx + (aim.y - a[1]) * dy) / length2 : 0;
  const s = Math.min(1, Math.max(0, t));
  return {
    distance: Math.hypot(aim.x - a[0] - s * dx, aim.y - a[1] - s * dy),
    depth: a[2] + s * (b[2] - a[2]),
  };
}

function may_touch(box: Box, aim: Aim): boolean {
  const spots = corners_of(box).map((corner) => to_screen(corner, 0, aim));
  const reaches = (i: 0 | 1, at: number): boolean =>
    at >= Math.min(...spots.map((spot) => spot[i])) - aim.reach_px &&
    at <= Math.max(...spots.map((spot) => spot[i])) + aim.reach_px;
  return reaches(0, aim.x) && reaches(1, aim.y);
}

function corners_of({ min, max }: Box): number[][] {
  return Array.from({ length: 8 }, (_, corner) =>
    [0, 1, 2].map((i) => ((corner >> i) & 1 ? max[i] : min[i])),
  );
}
