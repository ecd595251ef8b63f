/** Tool offsets of lathes: what the machine tells of one number, mm, X as a diameter; and what its tip looks like. */

export const TURNING_PARTS = [
  'geometry_x',
  'geometry_z',
  'geometry_y',
  'geometry_radius',
  'wear_x',
  'wear_z',
  'wear_y',
  'wear_radius',
  'tip',
] as const;
export type TurningPart = (typeof TURNING_PARTS)[number];
export type TurningOffset = { number: number } & Record<TurningPart, number>;

/** Parts that a machine with these axes has, in the order of the table. */
export const parts_of = (axes: readonly string[]): TurningPart[] =>
  TURNING_PARTS.filter((part) => axes.includes('Y') || !part.endsWith('_y'));

export function empty_offset(number: number): TurningOffset {
  const parts = Object.fromEntries(TURNING_PARTS.map((part) => [part, 0]));
  return { number, ...(parts as Record<TurningPart, number>) };
}

export interface Nose {
  /** Of the imaginary tip, 0 to 9. */
  tip: number;
  radius_mm: number;
}

/** Geometry and wear together are in force. */
export const nose_of = (offset: TurningOffset | undefined): Nose => ({
  tip: offset?.tip ?? 0,
  radius_mm: Math.abs((offset?.geometry_radius ?? 0) + (offset?.wear_radius ?? 0)),
});

/** From the centre of the nose to the imaginary tip along Z and X, in radii of the nose, by the direction of the tip. */
const TIPS: readonly (readonly [z: number, x: number])[] = [
  [0, 0],
  [1, 1],
  [-1, 1],
  [-1, -1],
  [1, -1],
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
  [0, 0],
];

export const tip_way = (tip: number): readonly [z: number, x: number] => TIPS[tip] ?? TIPS[0];

export type Flat = [z: number, x: number];

/** An insert as it is drawn in Z and X about its imaginary tip: an outline, and the centre of its nose. */
export interface InsertShape {
  outline: Flat[];
  centre: Flat;
  radius_mm: number;
  /** The way from the nose into the insert, of length 1; [0, 1] of a round one. */
  inwards: Flat;
}

const NOSE_CHORDS = 12;
const CORNER_DEG = { across: 80, along: 55 };

/**
 * The insert of this nose with edges of `edge_mm`: a rhomb whose corner is the nose and points where the tip does; with the
 * directions 0 and 9, whose tip is the centre of the nose, a round one.
 */
export function insert_shape({ tip, radius_mm }: Nose, edge_mm: number): InsertShape {
  const way = tip_way(tip);
  const [z, x] = way;
  const centre: Flat = [-z * radius_mm || 0, -x * radius_mm || 0];
  if (z === 0 && x === 0) {
    const outline = circle(centre, radius_mm || edge_mm / 2, 0, 2 * Math.PI);
    return { outline, centre, radius_mm, inwards: [0, 1] };
  }
  const inwards: Flat = [-z / Math.hypot(z, x) || 0, -x / Math.hypot(z, x) || 0];
  const heading = Math.atan2(inwards[1], inwards[0]);
  const outline = rhomb(centre, radius_mm, heading, half_corner(way), edge_mm);
  return { outline, centre, radius_mm, inwards };
}

const half_corner = ([z, x]: readonly [number, number]): number =>
  ((z !== 0 && x !== 0 ? CORNER_DEG.across : CORNER_DEG.along) * Math.PI) / 360;

/** The nose goes from the one edge round the corner to the other. */
function rhomb(centre: Flat, radius: number, heading: number, half: number, edge: number): Flat[] {
  const nose = circle(centre, radius, heading + half + Math.PI / 2, Math.PI - 2 * half);
  const far = ([z, x]: Flat, angle: number): Flat => [
    z + edge * Math.cos(angle),
    x + edge * Math.sin(angle),
  ];
  const right = far(nose[nose.length - 1], heading - half);
  return [...nose, right, far(right, heading + half), far(nose[0], heading + half)];
}

function circle(centre: Flat, radius: number, from: number, angle: number): Flat[] {
  const chords = Math.max(2, Math.ceil((NOSE_CHORDS * angle) / Math.PI));
  return Array.from({ length: chords + 1 }, (_, i) => {
    const at = from + (angle * i) / chords;
    return [centre[0] + radius * Math.cos(at), centre[1] + radius * Math.sin(at)];
  });
}
