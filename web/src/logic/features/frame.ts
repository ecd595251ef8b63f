/** The plan view's window: where on the screen a place lies, in pixels, with up upwards. */
import type { Element, Point } from './elements';
import { midpoint } from './elements';

export interface Frame {
  /** Pixels a mm. */
  scale: number;
  /** Of the zero of the part, in pixels from the upper left. */
  origin: Point;
}

export interface Extents {
  low: Point;
  high: Point;
}

const MARGIN = 0.12;
const MOST_SCALE = 5000;
const LEAST_SCALE = 0.01;

export const on_screen = ({ scale, origin }: Frame, [x, y]: Point): Point => [
  origin[0] + scale * x,
  origin[1] - scale * y,
];
export const in_plane = ({ scale, origin }: Frame, [x, y]: Point): Point => [
  (x - origin[0]) / scale,
  (origin[1] - y) / scale,
];

/** All points that say how large elements are. */
export function extents_of(elements: readonly Element[]): Extents | null {
  return extents_of_points(elements.flatMap((e) => [e.from, e.to, midpoint(e)]));
}

export function extents_of_points(points: readonly Point[]): Extents | null {
  if (!points.length) return null;
  const along = (i: 0 | 1): number[] => points.map((point) => point[i]);
  const each = (pick: (a: number, b: number) => number): Point => [
    along(0).reduce(pick),
    along(1).reduce(pick),
  ];
  return { low: each((a, b) => Math.min(a, b)), high: each((a, b) => Math.max(a, b)) };
}

/** So that all of it is seen, in the middle. */
export function fitted({ low, high }: Extents, width: number, height: number): Frame {
  const size = [0, 1].map((i) => Math.max(high[i] - low[i], 0.1));
  const scale = (1 - 2 * MARGIN) * Math.min(width / size[0], height / size[1]);
  const middle: Point = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
  return { scale, origin: [width / 2 - scale * middle[0], height / 2 + scale * middle[1]] };
}

/** Larger about a place of the screen. */
export function zoomed(frame: Frame, about: Point, factor: number): Frame {
  const scale = Math.min(MOST_SCALE, Math.max(LEAST_SCALE, frame.scale * factor));
  const share = scale / frame.scale;
  const origin = about.map((value, i) => value - share * (value - frame.origin[i])) as Point;
  return { scale, origin };
}

export const panned = ({ scale, origin }: Frame, [dx, dy]: Point): Frame => ({
  scale,
  origin: [origin[0] + dx, origin[1] + dy],
});

/** Two fingers were at the first two places and are at the second two. */
export function pinched(frame: Frame, before: [Point, Point], now: [Point, Point]): Frame {
  const middle = ([a, b]: [Point, Point]): Point => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  const apart = ([a, b]: [Point, Point]): number => Math.hypot(a[0] - b[0], a[1] - b[1]);
  const [from, to] = [middle(before), middle(now)];
  const moved = panned(frame, [to[0] - from[0], to[1] - from[1]]);
  return zoomed(moved, to, apart(now) / Math.max(1, apart(before)));
}
