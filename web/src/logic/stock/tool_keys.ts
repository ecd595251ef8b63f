/** Which keys of a tool the form asks for, by its type, as docs/tools.md has them. */
import { is_turning, type ToolType } from './tool_shape';

const COMMON = ['flute_length', 'stickout', 'length', 'flutes'];
const OF_TYPE: Partial<Record<ToolType, readonly string[]>> = {
  flat: ['diameter', 'corner_radius'],
  slot: ['diameter', 'corner_radius'],
  ball: ['diameter'],
  bull: ['diameter', 'corner_radius'],
  chamfer: ['diameter', 'angle', 'tip_diameter'],
  v: ['diameter', 'angle', 'tip_diameter'],
  countersink: ['diameter', 'angle', 'tip_diameter'],
  spot: ['diameter', 'angle', 'tip_diameter'],
  engrave: ['diameter', 'angle', 'tip_diameter', 'tip_radius'],
  taper: ['diameter', 'angle', 'tip_diameter', 'tip_radius'],
  drill: ['diameter', 'angle'],
  'centre-drill': ['diameter', 'pilot_diameter', 'pilot_length', 'angle'],
  reamer: ['diameter', 'lead'],
  tap: ['diameter', 'pitch'],
  face: ['diameter', 'entering_angle', 'ap_max', 'body_diameter'],
  't-slot': ['diameter', 'width', 'neck_diameter'],
  saw: ['diameter', 'width', 'neck_diameter'],
  dovetail: ['diameter', 'angle', 'height', 'neck_diameter'],
  lollipop: ['diameter', 'neck_diameter'],
  'thread-mill': ['diameter', 'pitch', 'profile_angle', 'teeth', 'neck_diameter'],
  boring: ['diameter', 'width'],
  form: ['diameter'],
  probe: ['diameter', 'neck_diameter'],
  turning: ['insert', 'nose_radius', 'tip_angle', 'ic', 'kapr', 'tip'],
  'boring-bar': ['insert', 'nose_radius', 'tip_angle', 'ic', 'kapr', 'tip', 'minimum_bore', 'overhang'],
  grooving: ['width', 'corner_radius', 'tip'],
  parting: ['width', 'corner_radius', 'tip'],
  'face-grooving': ['width', 'corner_radius', 'tip'],
  threading: ['profile_angle', 'pitch', 'nose_radius', 'ic', 'tip'],
}; // prettier-ignore

export const keys_of_tool = (type: ToolType): readonly string[] => [
  ...(OF_TYPE[type] ?? []),
  ...(is_turning(type) ? ['flute_length'] : COMMON),
];

/** What the checks hold a tool against. */
export const LIMIT_KEYS = ['fz', 'ap', 'ae', 'vc', 'ramp_deg'] as const;

export const needs_number = (key: string): boolean => key !== 'insert';

/** `12x60, 16x30`: diameter by height from below, cones as `30/40x25`; null: it is no such list. */
export function read_segments(text: string): Record<string, number>[] | null {
  const parts = text.split(',').map((one) => one.trim());
  const list = parts.filter(Boolean).map(read_segment);
  return list.every((one) => one !== null) ? list : null;
}

function read_segment(text: string): Record<string, number> | null {
  const found = /^(\d*\.?\d+)(?:\s*\/\s*(\d*\.?\d+))?\s*[x×*]\s*(\d*\.?\d+)$/i.exec(text);
  if (!found) return null;
  const [lower, upper, height] = found.slice(1).map(Number);
  return found[2] === undefined ? { height, diameter: lower } : { height, lower, upper };
}

export function written_segments(value: unknown): string {
  if (!Array.isArray(value)) return '';
  return value
    .map((raw) => {
      const { height, diameter, lower, upper } = raw as Record<string, number>;
      return diameter === undefined ? `${lower}/${upper}x${height}` : `${diameter}x${height}`;
    })
    .join(', ');
}
