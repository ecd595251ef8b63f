/** What is measured on the part, from places that were clicked. Millimetres. */
export type Place = [number, number, number];
export type MeasureKind = 'distance' | 'diameter' | 'depth';

export interface Measure {
  kind: MeasureKind;
  /** Distance, diameter or depth. */
  value: number;
  /** Of a distance and a depth: along the axes. */
  along?: Place;
  /** Of a diameter: the middle of the circle. */
  centre?: Place;
  /** What is drawn: the line, or the circle as a closed line. */
  line: Place[];
}

export const PLACES_NEEDED: Record<MeasureKind, number> = { distance: 2, diameter: 3, depth: 2 };
const CHORDS = 64;

/** Null: not enough places yet, or they tell nothing: three on a line have no circle. */
export function measure(
  kind: MeasureKind,
  places: readonly Place[],
  /** Of the axis of the circle: the coordinate that does not count. */
  axis: 0 | 1 | 2 = 2,
): Measure | null {
  if (places.length < PLACES_NEEDED[kind]) return null;
  if (kind === 'diameter') return circle(places, axis);
  const [a, b] = places;
  const along = [0, 1, 2].map((i) => b[i] - a[i]) as Place;
  if (kind === 'distance') return { kind, value: Math.hypot(...along), along, line: [a, b] };
  // Down from the first, then across to the second.
  const foot: Place = [...a];
  foot[axis] = b[axis];
  return { kind, value: Math.abs(along[axis]), along, line: [a, foot, b] };
}

function circle([a, b, c]: readonly Place[], axis: 0 | 1 | 2): Measure | null {
  const [u, v] = [0, 1, 2].filter((i) => i !== axis);
  const [bu, bv, cu, cv] = [b[u] - a[u], b[v] - a[v], c[u] - a[u], c[v] - a[v]];
  const area = 2 * (bu * cv - bv * cu);
  const size = Math.max(Math.hypot(bu, bv), Math.hypot(cu, cv));
  if (Math.abs(area) <= 1e-6 * size * size) return null;
  const mu = (cv * (bu * bu + bv * bv) - bv * (cu * cu + cv * cv)) / area;
  const mv = (bu * (cu * cu + cv * cv) - cu * (bu * bu + bv * bv)) / area;
  const radius = Math.hypot(mu, mv);
  const at = (angle: number): Place => {
    const place: Place = [...a];
    place[u] += mu + radius * Math.cos(angle);
    place[v] += mv + radius * Math.sin(angle);
    return place;
  };
  const centre: Place = [...a];
  centre[u] += mu;
  centre[v] += mv;
  const line = Array.from({ length: CHORDS + 1 }, (_, i) => at((2 * Math.PI * i) / CHORDS));
  return { kind: 'diameter', value: 2 * radius, centre, line };
}
