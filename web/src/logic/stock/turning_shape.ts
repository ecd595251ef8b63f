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

/** By ISO 1832; keys of the tool count more. */
export function insert_of(tool: ToolTable): Insert {
  const code = String(tool.insert ?? '').toUpperCase();
  const digits = /^[A-Z]{4}(\d\d)(\d\d)(\d\d)/.exec(code);
  const shape = TIP_ANGLES[code[0]] !== undefined ? code[0] : 'C';
  const edge = digits ? shape + digits[1] : '';
  const known = shape === 'R' && digits ? Number(digits[1]) : IC[edge];
  return {
    shape,
    ic: number_of(tool, 'ic', known ?? (tool.type === 'threading' ? 9.525 : 12.7)),
    nose: number_of(
      tool,
      'nose_radius',
      digits ? Number(digits[3]) / 10 : tool.type === 'threading' ? 0 : 0.4,
    ),
  };
}

export function turning_parts(tool: ToolTable, type: ToolType): ToolPart[] {
  const tip = number_of(tool, 'tip', type === 'boring-bar' ? 2 : type === 'threading' ? 8 : 3);
  const drawn = ['grooving', 'parting', 'face-grooving'].includes(type)
    ? blade(tool, type)
    : type === 'threading'
      ? thread_insert(tool)
      : rhombic(tool);
  // T4 is T3 mirrored in Z, T2 in X, T1 in both; the symmetric ones are drawn as they come.
  const z = tip === 4 || tip === 1 ? -1 : 1;
  const r = tip === 2 || tip === 1 ? -1 : 1;
  return drawn.map(({ kind, outline }) => ({
    kind,
    outline: outline.map(([a, b]) => [z * a, r * b] as Point2),
  }));
}

function rhombic(tool: ToolTable): ToolPart[] {
  const { shape, ic, nose } = insert_of(tool);
  const eps = rad(number_of(tool, 'tip_angle', TIP_ANGLES[shape] || 80));
  const kapr = rad(number_of(tool, 'kapr', KAPR[shape] ?? 90));
  if (shape === 'R') {
    const round = Array.from({ length: 40 }, (_, i): Point2 => {
      const angle = (2 * Math.PI * i) / 40;
      return [(ic / 2) * (1 + Math.cos(angle)), (ic / 2) * (1 + Math.sin(angle))];
    });
    return [holder_behind([1, 1], ic), { kind: 'cutting', outline: round }];
  }
  const main: Point2 = [-Math.cos(kapr), Math.sin(kapr)];
  const minor: Point2 = [-Math.cos(kapr + eps), Math.sin(kapr + eps)];
  const edge = shape === 'T' ? ic * Math.sqrt(3) : ic / Math.sin(eps);
  // The corner without its nose: both edges touch the circle about (r, r).
  const half = eps / 2;
  const bisector: Point2 = [Math.cos(kapr + half) * -1, Math.sin(kapr + half)];
  const corner: Point2 = [nose, nose].map(
    (v, i) => v - (bisector[i] * nose) / Math.sin(half),
  ) as Point2;
  const along = (from: Point2, way: Point2, by: number): Point2 => [
    from[0] + by * way[0],
    from[1] + by * way[1],
  ];
  const cut = nose / Math.tan(half);
  const a = Math.atan2(...swap(normal_of(minor, -1)));
  const b = Math.atan2(...swap(normal_of(main, 1)));
  const outline: Point2[] = [
    along(corner, minor, cut),
    ...(nose > 0 ? arc(nose, nose, nose, a, nearest(b, a)) : []),
    along(corner, main, cut),
    along(corner, main, edge),
  ];
  if (shape !== 'T') outline.push(along(along(corner, main, edge), minor, edge));
  outline.push(along(corner, minor, edge));
  return [holder_behind(bisector, ic), { kind: 'cutting', outline }];
}
const swap = ([x, y]: Point2): Point2 => [y, x];
/** Out of the insert, on the left (1) or right of an edge that leads away from the nose. */
const normal_of = ([x, y]: Point2, side: number): Point2 => [-y * side, x * side];
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

function blade(tool: ToolTable, type: ToolType): ToolPart[] {
  const width = number_of(tool, 'width', 3);
  const tip = number_of(tool, 'tip', 3);
  const from = tip === 8 || tip === 7 || tip === 6 || tip === 5 ? -width / 2 : 0;
  const long = number_of(tool, 'flute_length', 5 * width);
  const turned = (points: Point2[]): Point2[] =>
    type === 'face-grooving' ? points.map(([z, r]) => [r, z]) : points;
  return [
    {
      kind: 'holder',
      outline: turned([
        [from + 0.1 * width, long],
        [from + 0.9 * width, long],
        [from + 0.9 * width, 2.2 * long],
        [from + 0.1 * width, 2.2 * long],
      ]),
    },
    {
      kind: 'cutting',
      outline: turned([
        [from, 0],
        [from + width, 0],
        [from + width, long],
        [from, long],
      ]),
    },
  ];
}

function thread_insert(tool: ToolTable): ToolPart[] {
  const { ic } = insert_of(tool);
  const pitch = number_of(tool, 'pitch', 1.5);
  const half = Math.tan(rad(number_of(tool, 'profile_angle', 60)) / 2);
  const depth = pitch / 2 / half;
  return [
    holder_behind([0, 1], ic),
    {
      kind: 'cutting',
      outline: [
        [0, 0],
        [pitch / 2, depth],
        [ic / 2, depth],
        [ic / 2, ic],
        [-ic / 2, ic],
        [-ic / 2, depth],
        [-pitch / 2, depth],
      ],
    },
  ];
}
