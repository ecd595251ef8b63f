/**
 * Where a height field has walls. Between two neighbouring columns lies either a slope or a wall: a wall where the step stands
 * out from those before and behind it, so that a steep cone stays smooth and the side of a pocket is upright. A wall crosses
 * the line between both columns somewhere; those places are drawn together along the wall, so that a wall across the grid is
 * no staircase, and they get the normal of their neighbourhood, so that a round wall shines like one.
 *
 * All of it is found anew for a window of the field. A place in it depends on columns at most APRON away, so two tiles that
 * share a border agree on it.
 */
import { APRON, type HeightField, VOID } from './height_field';
import { TILE_CELLS } from './stock_frame';

/** Of the cell: smaller steps are slopes. */
const LEAST_STEP = 0.7;
/** So much higher than its neighbours is a step that is a wall. */
const STANDS_OUT = 2.5;
const SMOOTHING_ROUNDS = 3;
const NORMAL_ROUNDS = 2;
/** Normals of walls that turn by more than this, as a cosine, are those of a corner. */
const CORNER = 0.5;
const NEAREST_TO_COLUMN = 0.04;

export const WINDOW = TILE_CELLS + 1 + 2 * APRON;

/** `before` and `behind` are the steps on both sides of this one. */
export function is_wall(before: number, step: number, behind: number, cell: number): boolean {
  const size = Math.abs(step);
  if (size === Infinity) return true;
  if (!(size > LEAST_STEP * cell)) return false; // also between two columns of nothing
  const along = (other: number) =>
    Math.sign(other) === Math.sign(step) && Number.isFinite(other) ? Math.abs(other) : 0;
  return size > STANDS_OUT * Math.max(along(before), along(behind));
}

/** Edge 2k leads from column k of the window to the next in x, edge 2k + 1 to the next in y. */
export class Walls {
  readonly heights = new Float32Array(WINDOW * WINDOW);
  readonly is_wall = new Uint8Array(2 * WINDOW * WINDOW);
  /** Where the wall crosses the edge, 0 to 1. */
  readonly share = new Float32Array(2 * WINDOW * WINDOW);
  /** Of the wall where it crosses the edge, towards the lower side; two an edge. */
  readonly normal = new Float32Array(4 * WINDOW * WINDOW);
  any = false;
  any_void = false;
  private readonly sums = new Float32Array(4 * WINDOW * WINDOW);
  private readonly counts = new Uint8Array(2 * WINDOW * WINDOW);
  /** Pairs of edges that a wall crosses one behind the other. */
  private pairs: number[] = [];
  private walls: number[] = [];

  /** Looks at the window whose column APRON, APRON is column i0, j0 of the field. */
  find(field: HeightField, i0: number, j0: number): void {
    this.take_heights(field, i0, j0);
    this.walls = [];
    this.is_wall.fill(0);
    this.find_steps(field, i0, j0);
    this.any = this.walls.length > 0;
    if (!this.any) return;
    this.find_pairs();
    for (let round = 0; round < SMOOTHING_ROUNDS; round++) this.smooth();
    this.find_normals();
    for (let round = 0; round < NORMAL_ROUNDS; round++) this.smooth_normals();
  }

  private take_heights(field: HeightField, i0: number, j0: number): void {
    const { nx, ny } = field.grid;
    this.any_void = false;
    for (let j = 0; j < WINDOW; j++) {
      const row = Math.min(ny - 1, Math.max(0, j0 + j - APRON)) * nx;
      for (let i = 0; i < WINDOW; i++) {
        const column = Math.min(nx - 1, Math.max(0, i0 + i - APRON));
        const height = field.heights[row + column];
        this.heights[j * WINDOW + i] = height;
        if (height === VOID) this.any_void = true;
      }
    }
  }

  /** Columns beside the part are copies of its border, so no step lies there. */
  private find_steps(field: HeightField, i0: number, j0: number): void {
    const { nx, ny, cell } = field.grid;
    for (let k = 0; k < WINDOW * WINDOW; k++) {
      if (column(k) + 1 < WINDOW && this.is_step(k, 1, i0 + column(k) - APRON, nx, cell[0]))
        this.add_wall(2 * k);
      if (row(k) + 1 < WINDOW && this.is_step(k, WINDOW, j0 + row(k) - APRON, ny, cell[1]))
        this.add_wall(2 * k + 1);
    }
  }

  /** From column k of the window to the one `by` behind it; `at` of `count` is its place in the field. */
  private is_step(k: number, by: number, at: number, count: number, cell: number): boolean {
    const { heights } = this;
    if (heights[k] === heights[k + by]) return false;
    const h = (i: number): number => heights[Math.min(heights.length - 1, Math.max(0, i))];
    const before = at > 0 ? h(k) - h(k - by) : 0;
    const behind = at + 2 < count ? h(k + 2 * by) - h(k + by) : 0;
    return is_wall(before, h(k + by) - h(k), behind, cell);
  }

  private add_wall(edge: number): void {
    this.is_wall[edge] = 1;
    this.share[edge] = 0.5;
    this.walls.push(edge);
  }

  private find_pairs(): void {
    this.pairs = [];
    const seen = new Uint8Array(WINDOW * WINDOW);
    for (const edge of this.walls)
      for (const square of squares_beside(edge)) {
        if (square < 0 || seen[square]) continue;
        seen[square] = 1;
        if (is_whole(square)) this.add_pair(square);
      }
  }
  private add_pair(square: number): void {
    const crossed = edges_of(square).filter((side) => this.is_wall[side]);
    if (crossed.length === 2) this.pairs.push(crossed[0], crossed[1]);
  }

  private smooth(): void {
    const { share, sums, counts } = this;
    for (const edge of this.walls) sums[edge] = counts[edge] = 0;
    for (let i = 0; i < this.pairs.length; i += 2) {
      this.draw_together(this.pairs[i], this.pairs[i + 1]);
      this.draw_together(this.pairs[i + 1], this.pairs[i]);
    }
    for (const edge of this.walls) {
      if (counts[edge] !== 2) continue;
      const wish = 0.5 * share[edge] + 0.25 * sums[edge];
      share[edge] = Math.min(1 - NEAREST_TO_COLUMN, Math.max(NEAREST_TO_COLUMN, wish));
    }
  }
  private draw_together(edge: number, other: number): void {
    const along = edge & 1;
    const own = along ? row(edge >> 1) : column(edge >> 1);
    this.sums[edge] += this.place(other, along) - own;
    this.counts[edge]++;
  }
  /** Of the crossing, in columns of the window: along x (0) or y (1). */
  private place(edge: number, along: number): number {
    const k = edge >> 1;
    return (along ? row(k) : column(k)) + ((edge & 1) === along ? this.share[edge] : 0);
  }

  private find_normals(): void {
    const { normal } = this;
    for (const edge of this.walls) normal[2 * edge] = normal[2 * edge + 1] = 0;
    for (let i = 0; i < this.pairs.length; i += 2) {
      const [a, b] = [this.pairs[i], this.pairs[i + 1]];
      const [x, y] = this.across(a, b);
      for (const edge of [a, b]) {
        normal[2 * edge] += x;
        normal[2 * edge + 1] += y;
      }
    }
    this.make_unit();
  }
  /** The line between two crossings, and towards the lower side. */
  private across(a: number, b: number): [x: number, y: number] {
    const x = this.place(b, 1) - this.place(a, 1);
    const y = this.place(a, 0) - this.place(b, 0);
    const k = a >> 1;
    const falls = this.heights[k] > this.heights[k + (a & 1 ? WINDOW : 1)] ? 1 : -1;
    return (a & 1 ? y : x) * falls < 0 ? [-x, -y] : [x, y];
  }

  private smooth_normals(): void {
    const { normal, sums } = this;
    this.copy_normals(normal, sums);
    for (let i = 0; i < this.pairs.length; i += 2) {
      const [a, b] = [this.pairs[i], this.pairs[i + 1]];
      const turn = normal[2 * a] * normal[2 * b] + normal[2 * a + 1] * normal[2 * b + 1];
      if (turn < CORNER) continue;
      this.add_normal(a, b);
      this.add_normal(b, a);
    }
    this.copy_normals(sums, normal);
    this.make_unit();
  }
  private copy_normals(from: Float32Array, to: Float32Array): void {
    for (const edge of this.walls) {
      to[2 * edge] = from[2 * edge];
      to[2 * edge + 1] = from[2 * edge + 1];
    }
  }
  private add_normal(edge: number, other: number): void {
    this.sums[2 * edge] += this.normal[2 * other];
    this.sums[2 * edge + 1] += this.normal[2 * other + 1];
  }

  private make_unit(): void {
    const { normal } = this;
    for (const edge of this.walls) {
      const length = Math.hypot(normal[2 * edge], normal[2 * edge + 1]);
      if (!length) continue;
      normal[2 * edge] /= length;
      normal[2 * edge + 1] /= length;
    }
  }
}

const column = (k: number): number => k % WINDOW;
const row = (k: number): number => Math.floor(k / WINDOW);

/** Those on both sides of an edge. */
function squares_beside(edge: number): [number, number] {
  const k = edge >> 1;
  return [k, edge & 1 ? k - 1 : k - WINDOW];
}
/** All its sides are in the window. */
function is_whole(square: number): boolean {
  return column(square) < WINDOW - 1 && square < WINDOW * (WINDOW - 1);
}

/** The sides of the square from column k on: below, right, above, left. */
export const edges_of = (k: number): [number, number, number, number] => [
  2 * k,
  2 * (k + 1) + 1,
  2 * (k + WINDOW),
  2 * k + 1,
];
