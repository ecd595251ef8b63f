/** Where a place that is dragged is drawn to: each kind can be off. Of several the nearest holds; ends and middles before lines, the grid last. */
import {
  type Element,
  centre,
  distance,
  dot,
  is_arc,
  left_of,
  midpoint,
  plus,
  type Point,
  minus,
  unit,
} from './elements';

export type SnapKind = 'grid' | 'end' | 'middle' | 'centre' | 'angle' | 'original';
export const SNAP_KINDS: readonly SnapKind[] = [
  'grid',
  'end',
  'middle',
  'centre',
  'angle',
  'original',
];

export interface Snapped {
  at: Point;
  /** Null: nothing is near. */
  kind: SnapKind | null;
}

export interface SnapScene {
  /** What does not move with the place. */
  still: readonly Element[];
  /** As the program has it. */
  original: readonly Element[];
  /** From which horizontal, vertical and 45° are counted: the other ends of what moves. */
  anchors: readonly Point[];
  grid_mm: number;
}

const DIAGONALS: readonly Point[] = [
  [1, 0],
  [0, 1],
  [Math.SQRT1_2, Math.SQRT1_2],
  [Math.SQRT1_2, -Math.SQRT1_2],
];

/** `reach`: how near is near, in mm. */
export function snapped(
  place: Point,
  scene: SnapScene,
  kinds: ReadonlySet<SnapKind>,
  reach: number,
): Snapped {
  const points = points_of(scene, kinds);
  const near = nearest(place, points, reach) ?? (kinds.has('angle') && on_ray(place, scene, reach));
  if (near) return near;
  const at = place.map((value) => on_grid(value, scene.grid_mm)) as Point;
  return kinds.has('grid') ? { at, kind: 'grid' } : { at: place, kind: null };
}

export const on_grid = (value: number, grid_mm: number): number =>
  Math.round(value / grid_mm) * grid_mm;

/** A round number that is some ten pixels on the screen. */
export function grid_of(mm_per_pixel: number): number {
  const wanted = 8 * mm_per_pixel;
  const decade = 10 ** Math.floor(Math.log10(wanted));
  const step = [1, 2, 5, 10].find((times) => times * decade >= wanted) ?? 10;
  return Math.max(0.001, step * decade);
}

function points_of({ still, original }: SnapScene, kinds: ReadonlySet<SnapKind>): Snapped[] {
  const points: Snapped[] = [];
  const add = (kind: SnapKind, list: Point[]): void => {
    if (kinds.has(kind)) points.push(...list.map((at) => ({ at, kind })));
  };
  add(
    'end',
    still.flatMap(({ from, to }) => [from, to]),
  );
  add('middle', still.map(midpoint));
  add('centre', still.filter(is_arc).map(centre));
  add(
    'original',
    original.flatMap(({ from, to }) => [from, to]),
  );
  return points;
}

function nearest(place: Point, points: Snapped[], reach: number): Snapped | null {
  let best: Snapped | null = null;
  for (const point of points) {
    const far = distance(point.at, place);
    if (far <= reach && (!best || far < distance(best.at, place))) best = point;
  }
  return best;
}

function on_ray(place: Point, { anchors }: SnapScene, reach: number): Snapped | null {
  const feet = anchors.flatMap((anchor) =>
    DIAGONALS.map((way): Snapped => {
      const off = dot(minus(place, anchor), left_of(way));
      return { at: plus(place, left_of(way), -off), kind: 'angle' };
    }),
  );
  return nearest(place, feet, reach);
}

/** How far an edge moves that is dragged by so much: to where it is in one line with what is near, or to a round number. */
export function snapped_edge(
  element: Element,
  by: number,
  scene: SnapScene,
  kinds: ReadonlySet<SnapKind>,
  reach: number,
): { by: number; kind: SnapKind | null } {
  const normal = left_of(unit(minus(element.to, element.from)));
  const beside = (place: Point): number => dot(minus(place, element.from), normal);
  const near = points_of(scene, kinds)
    .map(({ at, kind }) => ({ by: beside(at), kind }))
    .filter((each) => Math.abs(each.by - by) <= reach)
    .sort((a, b) => Math.abs(a.by - by) - Math.abs(b.by - by))[0];
  if (near) return near;
  if (!kinds.has('grid')) return { by, kind: null };
  const zero = beside([0, 0]);
  const is_upright = normal.some((value) => Math.abs(value) < 1e-9);
  const from_zero = is_upright ? zero : 0;
  return { by: on_grid(by - from_zero, scene.grid_mm) + from_zero, kind: 'grid' };
}
