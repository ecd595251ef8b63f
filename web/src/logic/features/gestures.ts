/**
 * What a hand does to an element, as edits of the file: an end is moved, an edge beside itself, an arc by its middle. What
 * the edits make of the contour is known here at once, as `kerf edit` makes it: the page draws it before the server has answered.
 */
import type { ToldVertex } from './document';
import type { Edit } from './edits';
import type { Follower } from './snap_relations';
import {
  bulge_through,
  by_id,
  centre,
  cross,
  direction,
  distance,
  dot,
  type Element,
  elements_of,
  is_arc,
  left_of,
  midpoint,
  minus,
  neighbour,
  plus,
  type Point,
  radius,
  rounded,
  rounded_point,
  SAME_MM,
  unit,
  with_radius,
} from './elements';

/** Sine of the angle below which an arc goes on from a line. */
const TANGENT = 1e-4;
/** Sine of the angle below which two lines do not meet anywhere near. */
const PARALLEL = 1e-6;

export type Gesture =
  | { kind: 'corner'; element: number; at_end: boolean; to: Point }
  | { kind: 'edge'; element: number; by: number }
  | { kind: 'arc'; element: number; radius: number }
  | { kind: 'length'; element: number; length: number };

/** The edits of a gesture; none: it cannot be made. */
export function edits_of(elements: readonly Element[], gesture: Gesture): Edit[] {
  const element = by_id(elements, gesture.element);
  if (!element) return [];
  if (gesture.kind === 'corner') return move_corner(elements, element, gesture);
  if (gesture.kind === 'edge') return move_edge(elements, element, gesture.by);
  if (gesture.kind === 'length') return set_length(elements, element, gesture.length);
  return is_arc(element) ? set_radius(elements, element, rounded(gesture.radius)) : [];
}

function set_radius(elements: readonly Element[], element: Element, radius: number): Edit[] {
  if (!(radius > 0)) return [];
  if (is_circle(elements)) return [{ op: 'replace', contour: circle(centre(element), radius) }];
  const arc = with_radius(element, radius);
  return arc ? [{ op: 'modify-arc', element: arc.id, radius }] : [];
}

/** Two halves about one middle: neither can be larger than the other. */
export function is_circle(elements: readonly Element[]): boolean {
  const [a, b] = elements;
  return elements.length === 2 && is_arc(a) && is_arc(b) && is_same_place(centre(a), centre(b));
}

export const circle = ([x, y]: Point, r: number): ToldVertex[] =>
  [-r, r].map((off) => [rounded(x + off), rounded(y), 1]);

/**
 * The side that follows moves beside itself until this one is so long, as a dimension of a drawing means it: a corner alone
 * would make the side beside it slanted.
 */
function set_length(elements: readonly Element[], element: Element, wanted: number): Edit[] {
  if (is_arc(element) || !(wanted > 0)) return [];
  const way = minus(element.to, element.from);
  const more = plus([0, 0], unit(way), wanted - Math.hypot(...way));
  const next = neighbour(elements, element, true);
  const side = next && is_arc(next) ? line_behind(elements, element, next, true) : next;
  const normal = side && left_of(unit(minus(side.to, side.from)));
  if (!side || !normal || Math.abs(dot(unit(way), normal)) < PARALLEL)
    return [{ op: 'modify-line', element: element.id, length: rounded(wanted) }];
  return move_edge(elements, side, dot(more, normal));
}

function move_corner(
  elements: readonly Element[],
  element: Element,
  { at_end, to }: { at_end: boolean; to: Point },
): Edit[] {
  const place = rounded_point(to);
  const other = neighbour(elements, element, at_end);
  if (!is_arc(element)) return [line_to(element, at_end, place)];
  if (other && !is_arc(other)) return [line_to(other, !at_end, place)];
  const ends: [Point, Point] = at_end ? [element.from, place] : [place, element.to];
  return [through(element, ends)];
}

const line_to = ({ id }: Element, at_end: boolean, place: Point): Edit => ({
  op: 'modify-line',
  element: id,
  ...(at_end ? { to: place } : { from: place }),
});

/** With other ends, as round as it was. */
function through(element: Element, [from, to]: [Point, Point]): Edit {
  const points = [from, midpoint({ ...element, from, to }), to].map(rounded_point);
  return { op: 'modify-arc', element: element.id, through: points };
}

/** To the left of its way by so much; lines beside it become longer or shorter, fillets go with it. */
function move_edge(elements: readonly Element[], element: Element, by: number): Edit[] {
  if (is_arc(element)) return [];
  const normal = left_of(unit(minus(element.to, element.from)));
  const [before, after] = [false, true].map((at_end) => beside(elements, element, at_end, normal));
  const edits = [before, after].flatMap(({ fillet, way }) =>
    fillet ? [moved_arc(fillet, way, by)] : [],
  );
  const line: Edit = {
    op: 'modify-line',
    element: element.id,
    from: rounded_point(plus(element.from, before.way, by)),
    to: rounded_point(plus(element.to, after.way, by)),
  };
  return [...edits, line];
}

const moved_arc = (arc: Element, way: Point, by: number): Edit => ({
  op: 'modify-arc',
  element: arc.id,
  center: rounded_point(plus(centre(arc), way, by)),
});

/** The lines beside an edge that become longer or shorter when it moves; fillets between them have no length of their own. */
export function followers_of(elements: readonly Element[], edge: Element): Follower[] {
  const normal = left_of(unit(minus(edge.to, edge.from)));
  return [false, true].flatMap((at_end) => {
    const other = neighbour(elements, edge, at_end);
    if (!other || is_arc(other)) return [];
    const { way } = beside(elements, edge, at_end, normal);
    const [anchor, end] = at_end ? [other.to, other.from] : [other.from, other.to];
    return [{ id: other.id, anchor, end, way }];
  });
}

/** How an end of an edge moves when the edge moves by 1: along the line beside it, or along the one behind a fillet. */
function beside(
  elements: readonly Element[],
  element: Element,
  at_end: boolean,
  normal: Point,
): { way: Point; fillet: Element | null } {
  const other = neighbour(elements, element, at_end);
  if (!other) return { way: normal, fillet: null };
  const fillet = is_arc(other) ? other : null;
  const line = fillet ? line_behind(elements, element, fillet, at_end) : other;
  const along = line ? unit(minus(line.to, line.from)) : normal;
  const share = dot(normal, along);
  if (!line || Math.abs(share) < PARALLEL) return { way: normal, fillet: null };
  return { way: [along[0] / share, along[1] / share], fillet };
}

/** Behind an arc that is tangent to both. */
function line_behind(
  elements: readonly Element[],
  element: Element,
  fillet: Element,
  at_end: boolean,
): Element | null {
  const far = neighbour(elements, fillet, at_end);
  if (!far || is_arc(far) || far.id === element.id) return null;
  const turns = [
    cross(direction(element, at_end), direction(fillet, !at_end)),
    cross(direction(fillet, at_end), direction(far, !at_end)),
  ];
  return turns.every((turn) => Math.abs(turn) < TANGENT) ? far : null;
}

/** What `modify-line` and `modify-arc` make of the elements; null: another edit, or one that is not known here. */
export function applied(elements: readonly Element[], edits: readonly Edit[]): Element[] | null {
  let now = [...elements];
  for (const edit of edits) {
    if (edit.op === 'replace' && edit.contour) {
      now = elements_of(edit.contour, true);
      continue;
    }
    const old = edit.element === undefined ? undefined : by_id(now, edit.element);
    const made = old && modified(old, edit);
    if (!made) return null;
    now = with_element(now, old, made);
  }
  return now;
}

function modified(old: Element, edit: Edit): Element | null {
  if (edit.op === 'modify-line') return modified_line(old, edit);
  if (edit.op !== 'modify-arc') return null;
  if (edit.through) {
    const [from, by, to] = edit.through;
    return { ...old, from, to, bulge: bulge_through(from, by, to) };
  }
  if (edit.center) {
    const way = minus(edit.center, centre(old));
    return { ...old, from: plus(old.from, way), to: plus(old.to, way) };
  }
  return edit.radius === undefined ? null : with_radius(old, edit.radius);
}

function modified_line(old: Element, edit: Edit): Element {
  const line = { ...old, from: edit.from ?? old.from, to: edit.to ?? old.to };
  if (edit.length === undefined && edit.angle_deg === undefined) return line;
  const way = minus(old.to, old.from);
  const angle =
    edit.angle_deg === undefined ? Math.atan2(way[1], way[0]) : (edit.angle_deg * Math.PI) / 180;
  const length = edit.length ?? Math.hypot(...way);
  return { ...line, to: plus(line.from, [Math.cos(angle), Math.sin(angle)], length) };
}

/** What was joined to its ends follows them. */
function with_element(elements: Element[], old: Element, made: Element): Element[] {
  const before = neighbour(elements, old, false);
  const after = neighbour(elements, old, true);
  return elements.map((each) => {
    let now = each.id === made.id ? made : each;
    if (each.id === before?.id) now = { ...now, to: made.from };
    if (each.id === after?.id) now = { ...now, from: made.to };
    return now;
  });
}

/** How far to the left of an edge a place is; of an arc, by how much its radius would grow to pass there. */
export function drag_of(element: Element, grip: Point, place: Point): number {
  const normal = left_of(unit(minus(element.to, element.from)));
  return dot(minus(place, grip), normal);
}

/** Of an arc with its ends where they are, through a place; null: that is none. */
export function radius_through({ from, to, bulge }: Element, place: Point): number | null {
  const through_it = bulge_through(from, place, to);
  if (through_it === 0 || Math.sign(through_it) !== Math.sign(bulge)) return null;
  const b = Math.abs(through_it);
  return (distance(from, to) * (1 + b * b)) / (4 * b);
}

export const is_same_place = (a: Point, b: Point): boolean => distance(a, b) <= SAME_MM;

/** A step of a key: along the axes for a corner, beside itself for an edge, of an arc its radius. */
export function nudge(
  elements: readonly Element[],
  id: number,
  part: 'element' | 'start' | 'end',
  way: Point,
): Gesture | null {
  const element = by_id(elements, id);
  if (!element) return null;
  if (part !== 'element') {
    const at_end = part === 'end';
    const to = plus(at_end ? element.to : element.from, way);
    return { kind: 'corner', element: id, at_end, to };
  }
  if (is_arc(element))
    return { kind: 'arc', element: id, radius: radius(element) + way[0] + way[1] };
  const by = dot(way, left_of(unit(minus(element.to, element.from))));
  return Math.abs(by) < PARALLEL ? null : { kind: 'edge', element: id, by };
}
