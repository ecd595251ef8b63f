/** Insert and holder of a turning tool in Z and radius, from its imaginary tip. T3 is drawn, the others are its mirror images. */
import { arc } from './cutting_outline';
import {
  number_of,
  type Point2,
  rad,
  type ToolPart,
  type ToolTable,
  type ToolType,
} from './tool_table';

interface Insert {
  shape: string;
  ic: number;
  nose: number;
}

const TIP_ANGLES: Record<string, number> = {
  A: 85, B: 82, C: 80, D: 55, E: 75, K: 55, M: 86, V: 35, T: 60, S: 90, W: 80, R: 0, H: 120, O: 135, P: 108, L: 90,
}; // prettier-ignore
const KAPR: Record<string, number> = { C: 95, W: 95, D: 93, V: 93, K: 93, T: 91, S: 75 };
const IC: Record<string, number> = {
  C06: 6.35, D07: 6.35, V11: 6.35, T11: 6.35, W04: 6.35, C09: 9.525, D11: 9.525, V16: 9.525, T16: 9.525, W06: 9.525,
  S09: 9.525, K16: 9.525, C12: 12.7, D15: 12.7, V22: 12.7, T22: 12.7, W08: 12.7, S12: 12.7, C16: 15.875, T27: 15.875,
  S15: 15.875, C19: 19.05, S19: 19.05,
}; // prettier-ignore

const BLADES: readonly ToolType[] = ['grooving', 'parting', 'face-grooving'];
const ROUND_STEPS = 40;
/** Directions of the tip that lie in the middle of a blade. */
const CENTRED: readonly number[] = [5, 6, 7, 8];

/** By ISO 1832; keys of the tool count more. */
export function insert_of(tool: ToolTable): Insert {
  const code = String(tool.insert ?? '').toUpperCase();
  const digits = /^[A-Z]{4}(\d\d)(\d\d)(\d\d)/.exec(code);
  const shape = TIP_ANGLES[code[0]] !== undefined ? code[0] : 'C';
  const is_thread = tool.type === 'threading';
  const ic = (digits && ic_of(shape, digits[1])) ?? (is_thread ? 9.525 : 12.7);
  const nose = digits ? Number(digits[3]) / 10 : is_thread ? 0 : 0.4;
  return {
    shape,
    ic: number_of(tool, 'ic', ic),
    nose: number_of(tool, 'nose_radius', nose),
  };
}

/** Of a round insert the length of its edge is that of its diameter. */
const ic_of = (shape: string, edge: string): number | undefined =>
  shape === 'R' ? Number(edge) : IC[shape + edge];

export function turning_parts(tool: ToolTable, type: ToolType): ToolPart[] {
  const tip = number_of(tool, 'tip', type === 'boring-bar' ? 2 : type === 'threading' ? 8 : 3);
  // T4 is T3 mirrored in Z, T2 in X, T1 in both; the symmetric ones are drawn as they come.
  const z = tip === 4 || tip === 1 ? -1 : 1;
  const r = tip === 2 || tip === 1 ? -1 : 1;
  return drawn(tool, type).map(({ kind, outline }) => ({
    kind,
    outline: outline.map(([a, b]) => [z * a, r * b] as Point2),
  }));
}

function drawn(tool: ToolTable, type: ToolType): ToolPart[] {
  if (BLADES.includes(type)) return blade(tool, type);
  return type === 'threading' ? thread_insert(tool) : sharp_or_round(tool);
}

/** An insert of two edges with a nose between them, or a round one. */
function sharp_or_round(tool: ToolTable): ToolPart[] {
  const { shape, ic } = insert_of(tool);
  if (shape === 'R') return [holder_behind([1, 1], ic), { kind: 'cutting', outline: round(ic) }];
  const corner = corner_of(tool);
  return [holder_behind(corner.inwards, ic), { kind: 'cutting', outline: cornered(corner) }];
}

/** It touches both lines through its imaginary tip. */
function round(ic: number): Point2[] {
  return Array.from({ length: ROUND_STEPS }, (_, i): Point2 => {
    const angle = (2 * Math.PI * i) / ROUND_STEPS;
    return [(ic / 2) * (1 + Math.cos(angle)), (ic / 2) * (1 + Math.sin(angle))];
  });
}

/** The corner that cuts: where its edges would meet without a nose, and their ways from there. */
interface Corner {
  at: Point2;
  main: Point2;
  minor: Point2;
  inwards: Point2;
  /** Of both edges. */
  long: number;
  nose: number;
  /** Between the edges. */
  angle: number;
  has_three_sides: boolean;
}

function corner_of(tool: ToolTable): Corner {
  const { shape, ic, nose } = insert_of(tool);
  const angle = rad(number_of(tool, 'tip_angle', TIP_ANGLES[shape] || 80));
  const kapr = rad(number_of(tool, 'kapr', KAPR[shape] ?? 90));
  const inwards = edge_way(kapr + angle / 2);
  // Both edges touch the circle about (r, r).
  const off = nose / Math.sin(angle / 2);
  return {
    at: [nose - inwards[0] * off, nose - inwards[1] * off],
    ...{ main: edge_way(kapr), minor: edge_way(kapr + angle), inwards },
    long: shape === 'T' ? ic * Math.sqrt(3) : ic / Math.sin(angle),
    ...{ nose, angle, has_three_sides: shape === 'T' },
  };
}

/** Of an edge that stands so to the feed. */
const edge_way = (kapr: number): Point2 => [-Math.cos(kapr), Math.sin(kapr)];

function cornered(corner: Corner): Point2[] {
  const { at, main, minor, long, nose, angle } = corner;
  const cut = nose / Math.tan(angle / 2);
  const far = along(at, main, long);
  return [
    along(at, minor, cut),
    ...nose_arc(corner),
    along(at, main, cut),
    far,
    ...(corner.has_three_sides ? [] : [along(far, minor, long)]),
    along(at, minor, long),
  ];
}

/** From the minor edge round to the main one. */
function nose_arc({ main, minor, nose }: Corner): Point2[] {
  if (!(nose > 0)) return [];
  const from = Math.atan2(-minor[0], minor[1]);
  const to = Math.atan2(main[0], -main[1]);
  return arc(nose, nose, nose, from, nearest(to, from));
}

const along = (from: Point2, way: Point2, by: number): Point2 => [
  from[0] + by * way[0],
  from[1] + by * way[1],
];
const nearest = (angle: number, to: number): number =>
  angle + 2 * Math.PI * Math.round((to - angle) / (2 * Math.PI));

function holder_behind([x, y]: Point2, ic: number): ToolPart {
  const length = Math.hypot(x, y);
  const [a, b] = [x / length, y / length];
  const at = (along: number, across: number): Point2 => [
    ic * (along * a - across * b),
    ic * (along * b + across * a),
  ];
  return { kind: 'holder', outline: [at(0.75, -0.5), at(3.2, -0.5), at(3.2, 0.5), at(0.75, 0.5)] };
}

/** Straight sides: what cuts, and the blade that holds it. */
function blade(tool: ToolTable, type: ToolType): ToolPart[] {
  const width = number_of(tool, 'width', 3);
  const from = CENTRED.includes(number_of(tool, 'tip', 3)) ? -width / 2 : 0;
  const long = number_of(tool, 'flute_length', 5 * width);
  const turned = (points: Point2[]): Point2[] =>
    type === 'face-grooving' ? points.map(([z, r]) => [r, z]) : points;
  const behind = upright(from + 0.1 * width, from + 0.9 * width, long, 2.2 * long);
  return [
    { kind: 'holder', outline: turned(behind) },
    { kind: 'cutting', outline: turned(upright(from, from + width, 0, long)) },
  ];
}

const upright = (z0: number, z1: number, r0: number, r1: number): Point2[] => [
  [z0, r0],
  [z1, r0],
  [z1, r1],
  [z0, r1],
];

function thread_insert(tool: ToolTable): ToolPart[] {
  const { ic } = insert_of(tool);
  const pitch = number_of(tool, 'pitch', 1.5);
  const half = Math.tan(rad(number_of(tool, 'profile_angle', 60)) / 2);
  const outline = tooth(pitch / 2, pitch / 2 / half, ic);
  return [holder_behind([0, 1], ic), { kind: 'cutting', outline }];
}

/** One tooth, so wide on each side and so deep, on an insert. */
const tooth = (wide: number, depth: number, ic: number): Point2[] => [
  [0, 0],
  [wide, depth],
  [ic / 2, depth],
  [ic / 2, ic],
  [-ic / 2, ic],
  [-ic / 2, depth],
  [-wide, depth],
];
