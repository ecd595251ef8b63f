/** Where a line of sight first meets a height field, column by column. */
import { type HeightField, VOID } from './height_field';

type Vec = [number, number, number];

export interface FieldHit {
  at: Vec;
  /** Out of the material. */
  normal: Vec;
  owner: number;
}

/** What lies beyond the plane is not there. */
export interface Plane {
  normal: Vec;
  at: number;
}

const FAR_MM = 1e7;

/** `way` is a unit vector. Null: it passes by. */
export function hit_of_field(
  field: HeightField,
  from: Vec,
  way: Vec,
  plane: Plane | null = null,
): FieldHit | null {
  const { nx, ny, cell, corner, top } = field.grid;
  const high: Vec = [corner[0] + nx * cell[0], corner[1] + ny * cell[1], top];
  const span = span_in_box(from, way, corner, high, plane);
  if (!span) return null;
  let { begin, normal } = span;
  const at = (t: number): Vec => [from[0] + t * way[0], from[1] + t * way[1], from[2] + t * way[2]];
  const entry = at(begin);
  const index = (value: number, i: number, count: number): number =>
    Math.min(count - 1, Math.max(0, Math.floor((value - corner[i]) / cell[i])));
  let [i, j] = [index(entry[0] + 1e-9 * way[0], 0, nx), index(entry[1] + 1e-9 * way[1], 1, ny)];
  const step = [Math.sign(way[0]), Math.sign(way[1])];
  const border = (k: number, axis: 0 | 1): number => {
    if (!step[axis]) return Infinity;
    const side = corner[axis] + (k + (step[axis] > 0 ? 1 : 0)) * cell[axis];
    return (side - from[axis]) / way[axis];
  };
  for (let rounds = nx + ny + 2; rounds > 0 && begin <= span.end; rounds--) {
    const height = field.heights[j * nx + i];
    const leave = Math.min(border(i, 0), border(j, 1), span.end);
    const z = from[2] + begin * way[2];
    const owner = field.owners[j * nx + i];
    if (height !== VOID) {
      if (z <= height && z >= corner[2]) return { at: at(begin), normal, owner };
      const t = (height - from[2]) / way[2];
      if (way[2] < 0 && t >= begin && t <= leave) return { at: at(t), normal: [0, 0, 1], owner };
      const low = (corner[2] - from[2]) / way[2];
      if (way[2] > 0 && low >= begin && low <= leave)
        return { at: at(low), normal: [0, 0, -1], owner };
    }
    const axis = border(i, 0) <= border(j, 1) ? 0 : 1;
    begin = leave;
    if (leave >= span.end) break;
    if (axis === 0) i += step[0];
    else j += step[1];
    if (i < 0 || j < 0 || i >= nx || j >= ny) break;
    normal = axis === 0 ? [-step[0], 0, 0] : [0, -step[1], 0];
  }
  return null;
}

/** Where the line is within the box and not beyond the plane, and through which face it comes. */
interface Span {
  begin: number;
  end: number;
  normal: Vec;
}

function span_in_box(from: Vec, way: Vec, low: Vec, high: Vec, plane: Plane | null): Span | null {
  let begin = -FAR_MM;
  let end = FAR_MM;
  let normal: Vec = [0, 0, 1];
  for (const axis of [0, 1, 2] as const) {
    if (way[axis] === 0) {
      if (from[axis] < low[axis] || from[axis] > high[axis]) return null;
      continue;
    }
    const a = (low[axis] - from[axis]) / way[axis];
    const b = (high[axis] - from[axis]) / way[axis];
    if (Math.min(a, b) > begin) {
      begin = Math.min(a, b);
      normal = [0, 0, 0];
      normal[axis] = -Math.sign(way[axis]);
    }
    end = Math.min(end, Math.max(a, b));
  }
  const span = { begin, end, normal };
  return plane ? before_plane(span, from, way, plane) : whole(span);
}

const whole = (span: Span): Span | null => (span.begin <= span.end ? span : null);

function before_plane(span: Span, from: Vec, way: Vec, plane: Plane): Span | null {
  const along = dot(plane.normal, way);
  const over = plane.at - dot(plane.normal, from);
  if (along === 0 && over < 0) return null;
  if (along < 0 && over / along > span.begin)
    return whole({ ...span, begin: over / along, normal: [...plane.normal] });
  return whole(along > 0 ? { ...span, end: Math.min(span.end, over / along) } : span);
}

const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
