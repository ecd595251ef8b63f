/**
 * What a tool looks like, from the keys of its `[[tool]]` table (docs/tools.md): half the outline of a rotating tool, radius and
 * height over the tip, in parts from below to above; of a turning tool the outline of insert and holder in Z and radius, from
 * its imaginary tip. For pictures only: what cuts is decided by the server.
 */
export type ToolTable = { number: number } & Record<string, unknown>;
export type PartKind = 'cutting' | 'neck' | 'shank' | 'holder';
export type Point2 = [number, number];

export interface ToolPart {
  kind: PartKind;
  /** Rotating: [radius, height] upwards. Turning: a closed outline [z, radius]. */
  outline: Point2[];
}

export interface ToolShape {
  turning: boolean;
  parts: ToolPart[];
}

export const MILL_TYPES = [
  'flat', 'ball', 'bull', 'drill', 'chamfer', 'spot', 'tap', 'reamer', 'face', 'centre-drill',
  'countersink', 'v', 'engrave', 'taper', 'slot', 't-slot', 'saw', 'dovetail', 'lollipop',
  'thread-mill', 'boring', 'form', 'probe',
] as const; // prettier-ignore
export const LATHE_TYPES = [
  'turning', 'boring-bar', 'grooving', 'parting', 'face-grooving', 'threading',
] as const; // prettier-ignore
export type ToolType = (typeof MILL_TYPES)[number] | (typeof LATHE_TYPES)[number];

const ARC_STEPS = 14;
const rad = (deg: number): number => (deg * Math.PI) / 180;

function number_of(tool: ToolTable, key: string, otherwise: number): number {
  const value = tool[key];
  return typeof value === 'number' && Number.isFinite(value) ? value : otherwise;
}

export function type_of(tool: ToolTable): ToolType {
  const type = tool.type as ToolType | undefined;
  if (type && ([...MILL_TYPES, ...LATHE_TYPES] as string[]).includes(type)) return type;
  return tool.insert || tool.nose_radius !== undefined || tool.tip !== undefined
    ? 'turning'
    : 'flat';
}

export const is_turning = (type: ToolType): boolean =>
  (LATHE_TYPES as readonly string[]).includes(type);

/** Null: it says too little to be drawn. */
export function tool_shape(
  tool: ToolTable,
  holders: readonly { name: string; segments: unknown }[] = [],
): ToolShape | null {
  const type = type_of(tool);
  if (is_turning(type)) return { turning: true, parts: turning_parts(tool, type) };
  const diameter = number_of(tool, 'diameter', type === 'form' ? 2 * widest(tool) : 0);
  if (!(diameter > 0)) return null;
  const cutting = cutting_outline(tool, type, diameter / 2);
  const top = cutting[cutting.length - 1];
  const flutes = number_of(tool, 'flute_length', top[1] + (is_headed(type) ? 0 : 2.5 * diameter));
  const parts: ToolPart[] = [];
  if (is_headed(type)) {
    parts.push({ kind: 'cutting', outline: cutting });
    const neck = number_of(tool, 'neck_diameter', 0.6 * diameter) / 2;
    const up = Math.max(top[1] + 0.5 * diameter, number_of(tool, 'flute_length', 0));
    parts.push({
      kind: 'neck',
      outline: stack([
        [neck, top[1]],
        [neck, up],
      ]),
    });
    return { turning: false, parts: with_holder(tool, parts, up, neck, holders) };
  }
  const height = Math.max(flutes, top[1]);
  parts.push({
    kind: 'cutting',
    outline: height > top[1] ? [...cutting, [top[0], height]] : cutting,
  });
  return { turning: false, parts: with_holder(tool, parts, height, top[0], holders) };
}

const is_headed = (type: ToolType): boolean =>
  ['t-slot', 'saw', 'dovetail', 'lollipop', 'thread-mill', 'probe'].includes(type);

function with_holder(
  tool: ToolTable,
  parts: ToolPart[],
  from: number,
  radius: number,
  holders: readonly { name: string; segments: unknown }[],
): ToolPart[] {
  const shank = segments_of(tool.shank);
  const named = holders.find(({ name }) => name === tool.holder_name)?.segments;
  const holder = segments_of(tool.holder ?? named);
  const stickout = number_of(tool, 'stickout', 0);
  const above = shank.length ? segment_outline(shank, from) : null;
  const reach = above ? above[above.length - 1][1] : from;
  if (above) parts.push({ kind: 'shank', outline: above });
  const wide = above ? above[above.length - 1][0] : radius;
  // What is between is as wide as what is below it.
  if (stickout > reach)
    parts.push({
      kind: 'shank',
      outline: [
        [wide, reach],
        [wide, stickout],
      ],
    });
  if (holder.length)
    parts.push({ kind: 'holder', outline: segment_outline(holder, Math.max(stickout, from)) });
  return parts;
}

interface Segment {
  height: number;
  lower: number;
  upper: number;
}

export function segments_of(value: unknown): Segment[] {
  if (!Array.isArray(value)) return [];
  return value.flatMap((raw) => {
    const table = raw as ToolTable;
    const diameter = number_of(table, 'diameter', 0);
    const segment = {
      height: number_of(table, 'height', 0),
      lower: number_of(table, 'lower', diameter),
      upper: number_of(table, 'upper', diameter),
    };
    return segment.height > 0 && segment.lower + segment.upper > 0 ? [segment] : [];
  });
}

function segment_outline(segments: readonly Segment[], from: number): Point2[] {
  const outline: Point2[] = [];
  let height = from;
  for (const { height: by, lower, upper } of segments) {
    outline.push([lower / 2, height], [upper / 2, height + by]);
    height += by;
  }
  return outline;
}

const stack = (outline: Point2[]): Point2[] => outline;

/** The outline of a quarter of a circle or less about a centre, from angle a to b. */
function arc(r: number, z: number, radius: number, a: number, b: number): Point2[] {
  return Array.from({ length: ARC_STEPS + 1 }, (_, i) => {
    const angle = a + ((b - a) * i) / ARC_STEPS;
    return [r + radius * Math.cos(angle), z + radius * Math.sin(angle)] as Point2;
  });
}

/** From the axis at the tip up to where the tool has its diameter, or its cutting part ends. */
export function cutting_outline(tool: ToolTable, type: ToolType, R: number): Point2[] {
  const get = (key: string, otherwise: number): number => number_of(tool, key, otherwise);
  const cone = (tip: number, angle: number): Point2[] => [
    [tip, 0],
    [R, (R - tip) / Math.tan(rad(Math.min(179, angle)) / 2)],
  ];
  switch (type) {
    case 'ball':
      return arc(0, R, R, -Math.PI / 2, 0);
    case 'flat':
    case 'slot':
    case 'bull': {
      const c = Math.min(R, get('corner_radius', type === 'bull' ? R / 4 : 0));
      return c > 0
        ? [[0, 0], ...arc(R - c, c, c, -Math.PI / 2, 0)]
        : [
            [0, 0],
            [R, 0],
          ];
    }
    case 'chamfer':
    case 'v':
    case 'countersink':
    case 'spot':
      return [[0, 0], ...cone(get('tip_diameter', 0) / 2, get('angle', 90))];
    case 'engrave':
    case 'taper': {
      const ball = get('tip_radius', 0);
      const half = rad(get('angle', 90)) / 2;
      if (!(ball > 0)) return [[0, 0], ...cone(get('tip_diameter', 0) / 2, get('angle', 90))];
      const [r, z] = [ball * Math.cos(half), ball * (1 - Math.sin(half))];
      return [
        ...arc(0, ball, ball, -Math.PI / 2, -half),
        [Math.max(R, r), z + Math.max(0, R - r) / Math.tan(half)],
      ];
    }
    case 'drill':
      return [[0, 0], ...cone(0, get('angle', 118)).slice(1)];
    case 'centre-drill': {
      const pilot = Math.min(R, get('pilot_diameter', R / 2) / 2);
      const point = pilot / Math.tan(rad(59));
      const length = Math.max(point, get('pilot_length', R));
      return [
        [0, 0],
        [pilot, point],
        [pilot, length],
        [R, length + (R - pilot) / Math.tan(rad(get('angle', 60)) / 2)],
      ];
    }
    case 'reamer': {
      const lead = Math.min(R, get('lead', 0.5));
      return [
        [0, 0],
        [R - lead, 0],
        [R, lead],
      ];
    }
    case 'tap': {
      const pitch = get('pitch', 0.2 * R);
      const depth = Math.min(R, 0.541 * pitch);
      return [[0, 0], [R - depth, 0], ...teeth(R, depth, pitch, 2 * pitch, 12)];
    }
    case 'face': {
      const up = get('ap_max', 5);
      const wide = R + up / Math.tan(rad(get('entering_angle', 90)));
      const body = get('body_diameter', 2 * wide) / 2;
      return [
        [0, 0],
        [R, 0],
        [wide, up],
        [body, up],
        [body, up + 0.6 * R],
      ];
    }
    case 't-slot':
    case 'saw': {
      const width = get('width', R / 2);
      return [
        [0, 0],
        [R, 0],
        [R, width],
        [0, width],
      ];
    }
    case 'dovetail': {
      const height = get('height', R / 2);
      const upper = Math.max(0, R - height / Math.tan(rad(get('angle', 60))));
      return [
        [0, 0],
        [R, 0],
        [upper, height],
        [0, height],
      ];
    }
    case 'probe':
    case 'lollipop': {
      const neck = Math.min(R, get('neck_diameter', 0.6 * 2 * R) / 2);
      return arc(0, R, R, -Math.PI / 2, Math.PI / 2 - Math.asin(neck / R));
    }
    case 'thread-mill': {
      const pitch = get('pitch', R / 4);
      const neck = get('neck_diameter', 0) / 2;
      const depth = neck > 0 ? R - neck : 0.6134 * pitch;
      const count = Math.max(1, Math.round(get('teeth', 1)));
      return [[0, 0], [R - depth, 0], ...teeth(R, depth, pitch, 0, count), [0, count * pitch]];
    }
    case 'boring': {
      const width = get('width', 1);
      return [
        [Math.max(0, R - width), 0],
        [R, 0],
        [R, R / 2],
      ];
    }
    default:
      return (
        profile_of(tool) ?? [
          [0, 0],
          [R, 0],
        ]
      );
  }
}

/** Teeth along the axis; the first ones are lower up to `taper`. */
function teeth(R: number, depth: number, pitch: number, taper: number, count: number): Point2[] {
  const outline: Point2[] = [];
  for (let i = 0; i < count; i++) {
    const at = i * pitch;
    const high = taper > 0 ? Math.min(1, (at + pitch / 2) / taper) : 1;
    outline.push([R - depth, at], [R - depth * (1 - high), at + pitch / 2]);
  }
  outline.push([R - depth, count * pitch]);
  return outline;
}

function profile_of(tool: ToolTable): Point2[] | null {
  const profile = tool.profile;
  if (!Array.isArray(profile) || profile.length < 2) return null;
  const points = profile.map((point) => (point as number[]).slice(0, 2) as Point2);
  return points.every((p) => p.every(Number.isFinite)) ? points : null;
}
const widest = (tool: ToolTable): number =>
  Math.max(0, ...(profile_of(tool) ?? []).map(([r]) => r));

// Turning tools: T3 is drawn, the others are its mirror images

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

function turning_parts(tool: ToolTable, type: ToolType): ToolPart[] {
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
