/** Where what is dragged becomes tangent to what it meets, or as long or as round as another element. */
import {
  chord,
  cross,
  direction,
  distance,
  dot,
  type Element,
  is_arc,
  left_of,
  length,
  minus,
  plus,
  type Point,
  radius,
  unit,
} from './elements';

/** A side that ends in the place that is dragged. */
export interface Side {
  id: number;
  /** Its other end, which stays. */
  anchor: Point;
  /** What it meets there. */
  meets: Element | null;
}

/** A side that becomes longer when an edge is dragged: where it ends in it, and how that end moves when the edge moves by 1. */
export interface Follower {
  id: number;
  anchor: Point;
  end: Point;
  way: Point;
}

export type Relation = 'tangent' | 'length';
export interface Related<Value> {
  at: Value;
  kind: Relation;
  of: Element;
}

const ALONG: readonly Point[] = [
  [1, 0],
  [0, 1],
];
const FLAT = 1e-9;

const lines_beside = (others: readonly Element[], ids: readonly number[]): Element[] =>
  others.filter((other) => !is_arc(other) && !ids.includes(other.id));

/** The nearest places at which a side is tangent to the arc that it begins in. */
export function tangents(place: Point, sides: readonly Side[]): Related<Point>[] {
  return sides.flatMap(({ anchor, meets }) => {
    if (!meets || !is_arc(meets)) return [];
    const is_its_end = distance(meets.to, anchor) < distance(meets.from, anchor);
    const way = direction(meets, is_its_end);
    const at = plus(anchor, way, dot(minus(place, anchor), way));
    return [{ at, kind: 'tangent', of: meets } as const];
  });
}

/** The nearest places at which a side is as long as another line. */
export function same_lengths(
  place: Point,
  sides: readonly Side[],
  others: readonly Element[],
): Related<Point>[] {
  const ids = sides.map(({ id }) => id);
  return sides.flatMap(({ anchor }) =>
    lines_beside(others, ids).map((of) => {
      const at = plus(anchor, unit(minus(place, anchor)), length(of));
      return { at, kind: 'length', of } as const;
    }),
  );
}

/** As long as another line, and along an axis. */
export function square_lengths(
  sides: readonly Side[],
  others: readonly Element[],
): Related<Point>[] {
  const ids = sides.map(({ id }) => id);
  return sides.flatMap(({ anchor }) =>
    lines_beside(others, ids).flatMap((of) =>
      ALONG.flatMap((way) =>
        [1, -1].map((sense) => ({
          at: plus(anchor, way, sense * length(of)),
          kind: 'length' as const,
          of,
        })),
      ),
    ),
  );
}

/** By how much an edge moves for a side beside it to be as long as another line. */
export function edge_lengths(
  followers: readonly Follower[],
  others: readonly Element[],
): Related<number>[] {
  const ids = followers.map(({ id }) => id);
  return followers.flatMap(({ anchor, end, way }) => {
    const longer = dot(way, unit(minus(end, anchor)));
    if (Math.abs(longer) < FLAT) return [];
    return lines_beside(others, ids).map((of) => {
      const by = (length(of) - distance(end, anchor)) / longer;
      return { at: by, kind: 'length', of } as const;
    });
  });
}

/** Radii of an arc whose ends stay: tangent to what it meets, and those of other arcs. */
export function radii(
  arc: Element,
  { before, after }: { before: Element | null; after: Element | null },
  others: readonly Element[],
): Related<number>[] {
  const tangent = [
    before && { of: before, r: tangent_radius(arc, direction(before, true), false) },
    after && { of: after, r: tangent_radius(arc, direction(after, false), true) },
  ];
  const found = tangent.flatMap((each) =>
    each?.r ? [{ at: each.r, kind: 'tangent' as const, of: each.of }] : [],
  );
  const round = others.filter((other) => is_arc(other) && other.id !== arc.id);
  return [...found, ...round.map((of) => ({ at: radius(of), kind: 'length' as const, of }))];
}

/** Null: an arc in that sense is not tangent there. */
function tangent_radius(arc: Element, way: Point, at_end: boolean): number | null {
  const along = unit(minus(arc.to, arc.from));
  const turn = (at_end ? -1 : 1) * Math.atan2(cross(way, along), dot(way, along));
  if (Math.abs(turn) < FLAT || Math.sign(turn) !== Math.sign(arc.bulge)) return null;
  // A radius alone does not say which of two arcs is meant: it stays the larger or the smaller one.
  if (Math.abs(turn) > Math.PI / 2 !== Math.abs(arc.bulge) > 1) return null;
  const sine = Math.abs(dot(left_of(along), way));
  return sine < FLAT ? null : chord(arc) / (2 * sine);
}
