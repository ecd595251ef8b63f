/**
 * The cutting profile of each type of rotating tool, from the axis at the tip up to where the tool has its diameter or its cutting
 * part ends: radius and height (docs/tools.md).
 */
import { number_of, type Point2, rad, type ToolTable, type ToolType } from './tool_table';

const ARC_STEPS = 14;

/** One tool, as its profile is made of it. */
class Keys {
  constructor(
    readonly tool: ToolTable,
    readonly R: number,
  ) {}

  get(key: string, otherwise: number): number {
    return number_of(this.tool, key, otherwise);
  }
  /** At most the radius. */
  within(key: string, otherwise: number): number {
    return Math.min(this.R, this.get(key, otherwise));
  }
  cone(tip: number, angle: number): Point2[] {
    const up = (this.R - tip) / Math.tan(rad(Math.min(179, angle)) / 2);
    return [
      [0, 0],
      [tip, 0],
      [this.R, up],
    ];
  }
}

/** The outline of a part of a circle about a centre, from angle a to b. */
export function arc(r: number, z: number, radius: number, a: number, b: number): Point2[] {
  return Array.from({ length: ARC_STEPS + 1 }, (_, i) => {
    const angle = a + ((b - a) * i) / ARC_STEPS;
    return [r + radius * Math.cos(angle), z + radius * Math.sin(angle)] as Point2;
  });
}

export function cutting_outline(tool: ToolTable, type: ToolType, R: number): Point2[] {
  return (PROFILES[type] ?? form)(new Keys(tool, R));
}

function cylinder(keys: Keys): Point2[] {
  const { R } = keys;
  const c = keys.within('corner_radius', keys.tool.type === 'bull' ? R / 4 : 0);
  return c > 0
    ? [[0, 0], ...arc(R - c, c, c, -Math.PI / 2, 0)]
    : [
        [0, 0],
        [R, 0],
      ];
}

function ball({ R }: Keys): Point2[] {
  return arc(0, R, R, -Math.PI / 2, 0);
}

function cone(keys: Keys): Point2[] {
  return keys.cone(keys.get('tip_diameter', 0) / 2, keys.get('angle', 90));
}

function ball_cone(keys: Keys): Point2[] {
  const t = keys.get('tip_radius', 0);
  if (!(t > 0)) return cone(keys);
  const half = rad(keys.get('angle', 90)) / 2;
  const [r, z] = [t * Math.cos(half), t * (1 - Math.sin(half))];
  const up = z + Math.max(0, keys.R - r) / Math.tan(half);
  return [...arc(0, t, t, -Math.PI / 2, -half), [Math.max(keys.R, r), up]];
}

function drill(keys: Keys): Point2[] {
  return keys.cone(0, keys.get('angle', 118)).slice(1);
}

function centre_drill(keys: Keys): Point2[] {
  const { R } = keys;
  const pilot = Math.min(R, keys.get('pilot_diameter', R / 2) / 2);
  const point = pilot / Math.tan(rad(59));
  const length = Math.max(point, keys.get('pilot_length', R));
  const up = length + (R - pilot) / Math.tan(rad(keys.get('angle', 60)) / 2);
  return [
    [0, 0],
    [pilot, point],
    [pilot, length],
    [R, up],
  ];
}

function reamer(keys: Keys): Point2[] {
  const lead = keys.within('lead', 0.5);
  return [
    [0, 0],
    [keys.R - lead, 0],
    [keys.R, lead],
  ];
}

function tap(keys: Keys): Point2[] {
  const pitch = keys.get('pitch', 0.2 * keys.R);
  const depth = Math.min(keys.R, 0.541 * pitch);
  return [[0, 0], [keys.R - depth, 0], ...teeth(keys.R, depth, pitch, 2 * pitch, 12)];
}

function face(keys: Keys): Point2[] {
  const { R } = keys;
  const up = keys.get('ap_max', 5);
  const wide = R + up / Math.tan(rad(keys.get('entering_angle', 90)));
  const body = keys.get('body_diameter', 2 * wide) / 2;
  return [
    [0, 0],
    [R, 0],
    [wide, up],
    [body, up],
    [body, up + 0.6 * R],
  ];
}

function disc(keys: Keys): Point2[] {
  const width = keys.get('width', keys.R / 2);
  return [
    [0, 0],
    [keys.R, 0],
    [keys.R, width],
    [0, width],
  ];
}

function dovetail(keys: Keys): Point2[] {
  const height = keys.get('height', keys.R / 2);
  const upper = Math.max(0, keys.R - height / Math.tan(rad(keys.get('angle', 60))));
  return [
    [0, 0],
    [keys.R, 0],
    [upper, height],
    [0, height],
  ];
}

function sphere(keys: Keys): Point2[] {
  const { R } = keys;
  const neck = Math.min(R, keys.get('neck_diameter', 1.2 * R) / 2);
  return arc(0, R, R, -Math.PI / 2, Math.PI / 2 - Math.asin(neck / R));
}

function thread_mill(keys: Keys): Point2[] {
  const pitch = keys.get('pitch', keys.R / 4);
  const neck = keys.get('neck_diameter', 0) / 2;
  const depth = neck > 0 ? keys.R - neck : 0.6134 * pitch;
  const count = Math.max(1, Math.round(keys.get('teeth', 1)));
  return [
    [0, 0],
    [keys.R - depth, 0],
    ...teeth(keys.R, depth, pitch, 0, count),
    [0, count * pitch],
  ];
}

function boring(keys: Keys): Point2[] {
  const inner = Math.max(0, keys.R - keys.get('width', 1));
  return [
    [inner, 0],
    [keys.R, 0],
    [keys.R, keys.R / 2],
  ];
}

function form({ tool, R }: Keys): Point2[] {
  return (
    profile_of(tool) ?? [
      [0, 0],
      [R, 0],
    ]
  );
}

const PROFILES: Partial<Record<ToolType, (keys: Keys) => Point2[]>> = {
  flat: cylinder,
  slot: cylinder,
  bull: cylinder,
  ball,
  chamfer: cone,
  v: cone,
  countersink: cone,
  spot: cone,
  engrave: ball_cone,
  taper: ball_cone,
  drill,
  'centre-drill': centre_drill,
  reamer,
  tap,
  face,
  't-slot': disc,
  saw: disc,
  dovetail,
  lollipop: sphere,
  probe: sphere,
  'thread-mill': thread_mill,
  boring,
};

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
export const widest = (tool: ToolTable): number =>
  Math.max(0, ...(profile_of(tool) ?? []).map(([r]) => r));
