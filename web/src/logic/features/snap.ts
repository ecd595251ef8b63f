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
import {
  edge_lengths,
  type Follower,
  radii,
  same_lengths,
  type Side,
  square_lengths,
  tangents,
} from './snap_relations';

export type SnapKind =
  'grid' | 'end' | 'middle' | 'centre' | 'angle' | 'tangent' | 'length' | 'original';
export const SNAP_KINDS: readonly SnapKind[] = [
  'grid',
  'end',
  'middle',
  'centre',
  'angle',
  'tangent',
  'length',
  'original',
];

/** `Value`: a place, how far an edge moves, or a radius. */
export interface Snap<Value> {
  at: Value;
  /** Null: nothing is near. */
  kind: SnapKind | null;
  /** To what it is tangent, or as what it is as long. */
  of?: Element;
}
export type Snapped = Snap<Point>;

export interface SnapScene {
  /** What does not move with the place. */
  still: readonly Element[];
  /** As the program has it. */
  original: readonly Element[];
  /** From which horizontal, vertical and 45° are counted: the other ends of what moves. */
  anchors: readonly Point[];
  /** Sides that end in the place; those beside an edge; what an arc meets. */
  sides?: readonly Side[];
  followers?: readonly Follower[];
  meets?: { before: Element | null; after: Element | null };
  /** All of the contour: what they may be as long as. */
  whole?: readonly Element[];
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
  const near =
    nearest(place, points_of(scene, kinds), reach) ??
    nearest(place, places_on_lines(place, scene, kinds), reach);
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

function points_of(
  { still, original, sides = [], whole = [] }: SnapScene,
  kinds: ReadonlySet<SnapKind>,
): Snapped[] {
  const points: Snapped[] = kinds.has('length') ? [...square_lengths(sides, whole)] : [];
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

/** Where it is in its nearest place of a kind, without the grid: for who has no hand that drags. */
export const all_places = (
  place: Point,
  scene: SnapScene,
  kinds: ReadonlySet<SnapKind>,
): Snapped[] => [...points_of(scene, kinds), ...places_on_lines(place, scene, kinds)];

function nearest(place: Point, points: Snapped[], reach: number): Snapped | null {
  let best: Snapped | null = null;
  for (const point of points) {
    const far = distance(point.at, place);
    if (far <= reach && (!best || far < distance(best.at, place))) best = point;
  }
  return best;
}

/** The nearest place of each line and circle on which a relation holds. */
function places_on_lines(
  place: Point,
  { anchors, sides = [], whole = [] }: SnapScene,
  kinds: ReadonlySet<SnapKind>,
): Snapped[] {
  const feet = anchors.flatMap((anchor) =>
    DIAGONALS.map((way): Snapped => {
      const off = dot(minus(place, anchor), left_of(way));
      return { at: plus(place, left_of(way), -off), kind: 'angle' };
    }),
  );
  return [
    ...(kinds.has('angle') ? feet : []),
    ...(kinds.has('tangent') ? tangents(place, sides) : []),
    ...(kinds.has('length') ? same_lengths(place, sides, whole) : []),
  ];
}

/** How far an edge moves that is dragged by so much: to where it is in one line with what is near, or to a round number. */
export function snapped_edge(
  element: Element,
  by: number,
  scene: SnapScene,
  kinds: ReadonlySet<SnapKind>,
  reach: number,
): { by: number; kind: SnapKind | null; of?: Element } {
  const near = nearest_value(by, all_edges(element, scene, kinds), reach);
  if (near) return { by: near.at, kind: near.kind, ...(near.of ? { of: near.of } : {}) };
  if (!kinds.has('grid')) return { by, kind: null };
  const normal = left_of(unit(minus(element.to, element.from)));
  const zero = dot(minus([0, 0], element.from), normal);
  const is_upright = normal.some((value) => Math.abs(value) < 1e-9);
  const from_zero = is_upright ? zero : 0;
  return { by: on_grid(by - from_zero, scene.grid_mm) + from_zero, kind: 'grid' };
}

export function all_edges(
  element: Element,
  scene: SnapScene,
  kinds: ReadonlySet<SnapKind>,
): Snap<number>[] {
  const normal = left_of(unit(minus(element.to, element.from)));
  const in_line = points_of({ ...scene, sides: [] }, kinds).map(({ at, kind }) => ({
    at: dot(minus(at, element.from), normal),
    kind,
  }));
  const lengths = kinds.has('length') ? edge_lengths(scene.followers ?? [], scene.whole ?? []) : [];
  return [...in_line, ...lengths];
}

export const all_radii = (
  arc: Element,
  { meets, whole = [] }: SnapScene,
  kinds: ReadonlySet<SnapKind>,
): Snap<number>[] =>
  radii(arc, meets ?? { before: null, after: null }, whole).filter(({ kind }) => kinds.has(kind));

export function snapped_radius(
  arc: Element,
  r: number,
  scene: SnapScene,
  kinds: ReadonlySet<SnapKind>,
  reach: number,
): Snap<number> {
  const near = nearest_value(r, all_radii(arc, scene, kinds), reach);
  if (near) return near;
  return kinds.has('grid')
    ? { at: on_grid(r, scene.grid_mm), kind: 'grid' }
    : { at: r, kind: null };
}

const nearest_value = (
  value: number,
  list: readonly Snap<number>[],
  reach: number,
): Snap<number> | undefined =>
  list
    .filter(({ at }) => Math.abs(at - value) <= reach)
    .sort((a, b) => Math.abs(a.at - value) - Math.abs(b.at - value))[0];
