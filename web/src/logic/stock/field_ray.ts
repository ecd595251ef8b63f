/** Where a line of sight first meets a height field, column by column. */
import { far_corner, type HeightField, VOID } from './height_field';
import { NO_DEVIATION } from './stock_frame';

type Vec = [number, number, number];

export interface FieldHit {
  at: Vec;
  /** Out of the material. */
  normal: Vec;
  owner: number;
  /** As deviations_of() has it. */
  deviation: number;
}

type Meeting = Pick<FieldHit, 'at' | 'normal'>;

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
  const span = span_in_box(from, way, field.grid.corner, far_corner(field.grid), plane);
  return span && new Walk(field, from, way, span).first_hit();
}

/** Along a line from column to column, as long as it is within the part. */
class Walk {
  private readonly column: [number, number];
  private readonly step: readonly [number, number];
  /** Where along the line the column begins, and the side of it through which the line comes. */
  private begin: number;
  private normal: Vec;
  private readonly end: number;

  constructor(
    private readonly field: HeightField,
    private readonly from: Vec,
    private readonly way: Vec,
    span: Span,
  ) {
    this.begin = span.begin;
    this.end = span.end;
    this.normal = span.normal;
    this.step = [Math.sign(way[0]), Math.sign(way[1])];
    this.column = [this.index_at(0), this.index_at(1)];
  }

  first_hit(): FieldHit | null {
    const { nx, ny } = this.field.grid;
    for (let rounds = nx + ny + 2; rounds > 0 && this.begin <= this.end; rounds--) {
      const found = this.hit_in_column();
      if (found) return found;
      if (!this.go_on()) break;
    }
    return null;
  }

  private hit_in_column(): FieldHit | null {
    const [i, j] = this.column;
    const k = j * this.field.grid.nx + i;
    const height = this.field.heights[k];
    const found = height === VOID ? null : this.meets(height);
    const deviation = this.field.deviation?.[k] ?? NO_DEVIATION;
    return found && { ...found, owner: this.field.owners[k], deviation };
  }

  /** The side of a column of this height, or its top, or its bottom. */
  private meets(height: number): Meeting | null {
    const { way, begin, normal } = this;
    const bottom = this.field.grid.corner[2];
    const z = this.from[2] + begin * way[2];
    if (z <= height && z >= bottom) return { at: this.at(begin), normal };
    if (way[2] < 0) return this.meets_level(height, [0, 0, 1]);
    return way[2] > 0 ? this.meets_level(bottom, [0, 0, -1]) : null;
  }

  private meets_level(z: number, normal: Vec): Meeting | null {
    const t = (z - this.from[2]) / this.way[2];
    return t >= this.begin && t <= this.leave() ? { at: this.at(t), normal } : null;
  }

  /** Into the next column; false: it is none of the part, or beyond the end. */
  private go_on(): boolean {
    const { nx, ny } = this.field.grid;
    const axis = this.border(0) <= this.border(1) ? 0 : 1;
    this.begin = this.leave();
    if (this.begin >= this.end) return false;
    this.column[axis] += this.step[axis];
    this.normal = [0, 0, 0];
    this.normal[axis] = -this.step[axis];
    const [i, j] = this.column;
    return i >= 0 && j >= 0 && i < nx && j < ny;
  }

  private leave(): number {
    return Math.min(this.border(0), this.border(1), this.end);
  }
  /** Where along the line the column ends in this axis. */
  private border(axis: 0 | 1): number {
    if (!this.step[axis]) return Infinity;
    const { corner, cell } = this.field.grid;
    const side = corner[axis] + (this.column[axis] + (this.step[axis] > 0 ? 1 : 0)) * cell[axis];
    return (side - this.from[axis]) / this.way[axis];
  }
  private at(t: number): Vec {
    return this.from.map((value, i) => value + t * this.way[i]) as Vec;
  }
  /** The first column in this axis: a little inside of where the line comes in. */
  private index_at(axis: 0 | 1): number {
    const { nx, ny, corner, cell } = this.field.grid;
    const place = this.at(this.begin)[axis] + 1e-9 * this.way[axis];
    const index = Math.floor((place - corner[axis]) / cell[axis]);
    return Math.min((axis ? ny : nx) - 1, Math.max(0, index));
  }
}

/** Where the line is within the box and not beyond the plane, and through which face it comes. */
interface Span {
  begin: number;
  end: number;
  normal: Vec;
}

function span_in_box(from: Vec, way: Vec, low: Vec, high: Vec, plane: Plane | null): Span | null {
  const span: Span = { begin: -FAR_MM, end: FAR_MM, normal: [0, 0, 1] };
  for (const axis of [0, 1, 2] as const) {
    if (way[axis] !== 0)
      narrow(span, axis, way[axis], low[axis] - from[axis], high[axis] - from[axis]);
    else if (from[axis] < low[axis] || from[axis] > high[axis]) return null;
  }
  return plane ? before_plane(span, from, way, plane) : whole(span);
}

/** To what lies between two sides of the box, which are so far from the line's first point. */
function narrow(span: Span, axis: 0 | 1 | 2, way: number, low: number, high: number): void {
  const begin = Math.min(low / way, high / way);
  span.end = Math.min(span.end, Math.max(low / way, high / way));
  if (begin <= span.begin) return;
  span.begin = begin;
  span.normal = [0, 0, 0];
  span.normal[axis] = -Math.sign(way);
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
