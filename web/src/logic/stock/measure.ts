/** What is measured on the part, from places that were clicked. Millimetres. */
export type Place = [number, number, number];
type Pair = [number, number];
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

/** In the two coordinates that count; the third one is that of the first place. */
function circle([a, b, c]: readonly Place[], axis: 0 | 1 | 2): Measure | null {
  const [u, v] = [0, 1, 2].filter((i) => i !== axis);
  const middle = middle_of([b[u] - a[u], b[v] - a[v]], [c[u] - a[u], c[v] - a[v]]);
  if (!middle) return null;
  const moved = (du: number, dv: number): Place => {
    const place: Place = [...a];
    place[u] += du;
    place[v] += dv;
    return place;
  };
  const radius = Math.hypot(...middle);
  const line = Array.from({ length: CHORDS + 1 }, (_, i) => {
    const angle = (2 * Math.PI * i) / CHORDS;
    return moved(middle[0] + radius * Math.cos(angle), middle[1] + radius * Math.sin(angle));
  });
  return { kind: 'diameter', value: 2 * radius, centre: moved(...middle), line };
}

/** Of the circle through the origin and two places; null: all three lie on one line. */
function middle_of([bu, bv]: Pair, [cu, cv]: Pair): Pair | null {
  const area = 2 * (bu * cv - bv * cu);
  const size = Math.max(Math.hypot(bu, bv), Math.hypot(cu, cv));
  if (Math.abs(area) <= 1e-6 * size * size) return null;
  const b2 = bu * bu + bv * bv;
  const c2 = cu * cu + cv * cv;
  return [(cv * b2 - bv * c2) / area, (bu * c2 - cu * b2) / area];
}
