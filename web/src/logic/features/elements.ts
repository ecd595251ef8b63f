/** Elements of a contour, in the plane in which it is drawn: lines, and arcs by their bulge (the tangent of a quarter of the angle, + counterclockwise). */
import type { ToldVertex } from './document';

export type Point = [number, number];

export interface Element {
  /** As an edits file counts it: it stays while others come and go. */
  id: number;
  from: Point;
  to: Point;
  bulge: number;
}

/** Points that are nearer to each other are one. */
export const SAME_MM = 1e-3;

export const distance = (a: Point, b: Point): number => Math.hypot(b[0] - a[0], b[1] - a[1]);
export const middle = (a: Point, b: Point): Point => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
export const plus = (a: Point, b: Point, times = 1): Point => [
  a[0] + times * b[0],
  a[1] + times * b[1],
];
export const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1]];
export const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1];
export const cross = (a: Point, b: Point): number => a[0] * b[1] - a[1] * b[0];
/** To the left of the way. */
export const left_of = ([x, y]: Point): Point => [-y, x];

export function unit(way: Point): Point {
  const length = Math.hypot(...way);
  return length > 0 ? [way[0] / length, way[1] / length] : [1, 0];
}

export const is_arc = ({ bulge }: Element): boolean => bulge !== 0;
export const chord = ({ from, to }: Element): number => distance(from, to);
/** Of the arc, + counterclockwise, in radians. */
export const sweep = ({ bulge }: Element): number => 4 * Math.atan(bulge);

export function radius(element: Element): number {
  const b = Math.abs(element.bulge);
  return b === 0 ? Infinity : (chord(element) * (1 + b * b)) / (4 * b);
}

export function centre(element: Element): Point {
  const { from, to, bulge } = element;
  const off = (1 - bulge * bulge) / (4 * bulge);
  return plus(middle(from, to), left_of(minus(to, from)), off);
}

/** The point of an element half of its way. */
export function midpoint({ from, to, bulge }: Element): Point {
  return plus(middle(from, to), left_of(minus(to, from)), -bulge / 2);
}

export const length = (element: Element): number =>
  is_arc(element) ? radius(element) * Math.abs(sweep(element)) : chord(element);

/** Of a line, in degrees from 0 to below 360. */
export function angle_deg({ from, to }: Element): number {
  const degrees = (Math.atan2(to[1] - from[1], to[0] - from[0]) * 180) / Math.PI;
  return (degrees + 360) % 360;
}

/** Where it leads at its beginning or its end. */
export function direction(element: Element, at_end: boolean): Point {
  const along = unit(minus(element.to, element.from));
  const half = ((at_end ? 1 : -1) * sweep(element)) / 2;
  return [
    along[0] * Math.cos(half) - along[1] * Math.sin(half),
    along[0] * Math.sin(half) + along[1] * Math.cos(half),
  ];
}

/** An arc with the same ends and sense; null: its radius is too small for them. */
export function with_radius(element: Element, r: number): Element | null {
  const half = chord(element) / 2;
  if (r < half - SAME_MM / 2) return null;
  const high = Math.sqrt(Math.max(0, r * r - half * half));
  const short = half / (Math.max(r, half) + high);
  const size = Math.abs(element.bulge) > 1 ? 1 / short : short;
  return { ...element, bulge: Math.sign(element.bulge) * size };
}

/** Bulge of the arc from one point through another to a third; 0: they lie on a line. */
export function bulge_through(first: Point, second: Point, third: Point): number {
  const [into, out] = [minus(second, first), minus(third, second)];
  const whole = Math.hypot(...into) * Math.hypot(...out) + dot(into, out);
  const bulge = cross(into, out) / whole;
  return Number.isFinite(bulge) && Math.abs(bulge) > 1e-9 ? bulge : 0;
}

/** The elements of a contour as it is told; an open one has one fewer than vertices. */
export function elements_of(
  told: readonly ToldVertex[],
  is_closed: boolean,
  turned = false,
): Element[] {
  const at = ([x, y]: ToldVertex): Point => (turned ? [x, y / 2] : [x, y]);
  const count = is_closed ? told.length : told.length - 1;
  return Array.from({ length: Math.max(0, count) }, (_, i) => ({
    id: i,
    from: at(told[i]),
    to: at(told[(i + 1) % told.length]),
    bulge: told[i][2],
  }));
}

/** The other element that begins or ends where this one does. */
export function neighbour(
  elements: readonly Element[],
  { id, from, to }: Element,
  at_end: boolean,
): Element | null {
  const place = at_end ? to : from;
  const meets = (other: Element): boolean =>
    other.id !== id && distance(at_end ? other.from : other.to, place) <= SAME_MM;
  return elements.find(meets) ?? null;
}

export const by_id = (elements: readonly Element[], id: number): Element | undefined =>
  elements.find((element) => element.id === id);

/** To a micrometre's thousandth: what an edits file says. */
export const rounded = (value: number): number => {
  const whole = Math.round(value * 1e6) / 1e6;
  return Object.is(whole, -0) ? 0 : whole;
};
export const rounded_point = ([x, y]: Point): Point => [rounded(x), rounded(y)];
