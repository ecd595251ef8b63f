/** What an element becomes that a hand pulls, or that a key takes to what is near: the gesture, and what it snaps to. */
import { type Part } from './dimensions';
import {
  by_id,
  distance,
  type Element,
  is_arc,
  midpoint,
  neighbour,
  type Point,
  radius,
  SAME_MM,
} from './elements';
import { applied, drag_of, edits_of, followers_of, type Gesture, radius_through } from './gestures';
import {
  all_edges,
  all_places,
  all_radii,
  grid_of,
  type Snap,
  snapped,
  snapped_edge,
  snapped_radius,
  type SnapKind,
  type SnapScene,
} from './snap';

export interface Grip {
  element: Element;
  part: Part;
  /** All elements as they were before. */
  before: readonly Element[];
}

/** What it has snapped to, and where that is drawn. */
export interface Mark {
  kind: SnapKind;
  at: Point;
  of?: Element;
}

export interface Pull {
  gesture: Gesture;
  mark: Mark | null;
}

export interface Snapping {
  scene: SnapScene;
  kinds: ReadonlySet<SnapKind>;
  reach: number;
}

const is_at = (a: Point, b: Point): boolean => a[0] === b[0] && a[1] === b[1];

export function scene_of(
  { element, part, before }: Grip,
  original: readonly Element[],
  mm_per_pixel: number,
): SnapScene {
  const moving = part === 'end' ? element.to : element.from;
  const moved = before.filter(({ from, to }) => is_at(from, moving) || is_at(to, moving));
  const sides = moved.map((each) => side_of(each, moving, before));
  return {
    still: before.filter((each) => each.id !== element.id && !moved.includes(each)),
    original,
    anchors: sides.map(({ anchor }) => anchor),
    sides: sides.filter(({ id }) => !is_arc(by_id(before, id)!)),
    followers: followers_of(before, element),
    meets: {
      before: neighbour(before, element, false),
      after: neighbour(before, element, true),
    },
    whole: before,
    grid_mm: grid_of(mm_per_pixel),
  };
}

function side_of(each: Element, moving: Point, before: readonly Element[]) {
  const begins_here = is_at(each.from, moving);
  const anchor = begins_here ? each.to : each.from;
  return { id: each.id, anchor, meets: neighbour(before, each, begins_here) };
}

/** `from`: where the hand has come down. */
export function pulled(grip: Grip, from: Point, place: Point, snapping: Snapping): Pull | null {
  const { element, part, before } = grip;
  const { scene, kinds, reach } = snapping;
  if (part !== 'element') return of_corner(grip, snapped(place, scene, kinds, reach));
  if (!is_arc(element)) {
    const { by, kind, of } = snapped_edge(
      element,
      drag_of(element, from, place),
      scene,
      kinds,
      reach,
    );
    return of_edge(grip, { at: by, kind, of });
  }
  const r = radius_at(element, before, place);
  return r === null ? null : of_arc(grip, snapped_radius(element, r, scene, kinds, reach));
}

/** Whatever it could snap to, the nearest first, without where it is. */
export function pulls_of(grip: Grip, { scene, kinds }: Snapping): Pull[] {
  const { element, part } = grip;
  if (part !== 'element') {
    const place = part === 'end' ? element.to : element.from;
    const far = ({ at }: Snap<Point>): number => distance(at, place);
    return in_turn(all_places(place, scene, kinds), far, (snap) => of_corner(grip, snap));
  }
  const [list, now] = is_arc(element)
    ? [all_radii(element, scene, kinds), radius(element)]
    : [all_edges(element, scene, kinds), 0];
  const pull = is_arc(element) ? of_arc : of_edge;
  return in_turn(
    list,
    ({ at }) => Math.abs(at - now),
    (snap) => pull(grip, snap),
  );
}

/** The relation that holds where it is: what the keys have come to. */
export function held_by(grip: Grip, { scene, kinds }: Snapping): Mark | null {
  const { element, part } = grip;
  const near = { scene, kinds: without_grid(kinds), reach: SAME_MM };
  if (part !== 'element') {
    const place = part === 'end' ? element.to : element.from;
    return of_corner(grip, snapped(place, scene, near.kinds, near.reach)).mark;
  }
  if (is_arc(element))
    return of_arc(grip, snapped_radius(element, radius(element), scene, near.kinds, near.reach))
      .mark;
  const { by, kind, of } = snapped_edge(element, 0, scene, near.kinds, near.reach);
  return of_edge(grip, { at: by, kind, of }).mark;
}

export const without_grid = (kinds: ReadonlySet<SnapKind>): ReadonlySet<SnapKind> =>
  new Set([...kinds].filter((kind) => kind !== 'grid'));

function in_turn<Value>(
  list: readonly Snap<Value>[],
  far: (snap: Snap<Value>) => number,
  pull: (snap: Snap<Value>) => Pull,
): Pull[] {
  const away = list.filter((snap) => far(snap) > SAME_MM).sort((a, b) => far(a) - far(b));
  const different = away.filter((snap, i) => i === 0 || far(snap) - far(away[i - 1]) > SAME_MM);
  return different.map(pull);
}

const mark_at = <Value>({ kind, of }: Snap<Value>, at: Point): Mark | null =>
  kind === null ? null : { kind, at, ...(of ? { of } : {}) };

function of_corner({ element, part }: Grip, snap: Snap<Point>): Pull {
  const to = snap.at;
  const gesture = { kind: 'corner', element: element.id, at_end: part === 'end', to } as const;
  return { gesture, mark: mark_at(snap, to) };
}
function of_edge({ element, before }: Grip, snap: Snap<number>): Pull {
  const gesture = { kind: 'edge', element: element.id, by: snap.at } as const;
  return { gesture, mark: mark_at(snap, middle_behind(element, before, gesture)) };
}
function of_arc({ element, before }: Grip, snap: Snap<number>): Pull {
  const gesture = { kind: 'arc', element: element.id, radius: snap.at } as const;
  return { gesture, mark: mark_at(snap, middle_behind(element, before, gesture)) };
}

function middle_behind(element: Element, before: readonly Element[], gesture: Gesture): Point {
  const made = applied(before, edits_of(before, gesture));
  return midpoint((made && by_id(made, element.id)) ?? element);
}

/** A circle of two halves follows the pointer from its middle. */
function radius_at(element: Element, before: readonly Element[], place: Point): number | null {
  const is_round = before.length === 2 && before.every((e) => Math.abs(e.bulge) === 1);
  if (!is_round) return radius_through(element, place);
  const [a, b] = before.map(midpoint);
  return distance(place, [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]);
}
