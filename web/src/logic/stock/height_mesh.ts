/**
 * Triangles of a tile of a height field. Between the middles of four neighbouring columns lies a square: smooth where no wall
 * crosses it, else cut by the wall into a part above and one below with the upright wall between them. Flat squares of one
 * height are joined to rectangles. At the border of the part its sides go down to the bottom, and the bottom closes it, so
 * that the tiles of a part together are a closed body, which a section can be laid through.
 */
import { APRON, type HeightField, VOID } from './height_field';
import { MeshArrays, type TileMesh } from './mesh_arrays';
import { TILE_CELLS } from './stock_frame';
import { edges_of, Walls, WINDOW } from './walls';

export type { TileMesh };

/** Joined rectangles lap over their neighbours by this share of a cell: corners of those that lie on their sides leave no gap. */
export const LAP = 0.06;
/** Of the cell: walls of less have no line at their edges. */
const LEAST_LINE = 1.6;

type Corner = 0 | 1 | 2 | 3;
const CORNERS: readonly Corner[] = [0, 1, 2, 3];
/** From the first corner of a square to each, as columns of the window. */
const STEP = [0, 1, WINDOW + 1, WINDOW];

export class HeightMesher {
  private readonly walls = new Walls();
  private readonly out = new MeshArrays();
  private readonly shared = new Int32Array(WINDOW * WINDOW);
  private readonly flat = new Float32Array(TILE_CELLS * TILE_CELLS);
  private readonly covered = new Uint8Array(TILE_CELLS * TILE_CELLS);
  private field!: HeightField;
  private i0 = 0;
  private j0 = 0;
  /** Squares of the tile. */
  private width = 0;
  private height = 0;

  constructor(private readonly lap = LAP) {}

  mesh(field: HeightField, tile_x: number, tile_y: number): TileMesh {
    this.field = field;
    const { nx, ny } = field.grid;
    this.i0 = tile_x * TILE_CELLS;
    this.j0 = tile_y * TILE_CELLS;
    this.width = Math.min(TILE_CELLS, nx - 1 - this.i0);
    this.height = Math.min(TILE_CELLS, ny - 1 - this.j0);
    this.walls.find(field, this.i0, this.j0);
    this.shared.fill(-1);
    this.out.clear();
    this.squares();
    this.rectangles(this.flat, (x0, y0, x1, y1, height) => this.flat_top(x0, y0, x1, y1, height));
    this.bottom();
    this.sides();
    return this.out.made();
  }

  // The top

  private squares(): void {
    this.flat.fill(NaN);
    for (let j = 0; j < this.height; j++) {
      for (let i = 0; i < this.width; i++) {
        const k = (j + APRON) * WINDOW + i + APRON;
        if (this.walls.any && this.is_crossed(k)) this.crossed_square(k);
        else this.smooth_square(k, j * TILE_CELLS + i);
      }
    }
  }

  private is_crossed(k: number): boolean {
    const { is_wall } = this.walls;
    return !!(
      is_wall[2 * k] |
      is_wall[2 * (k + 1) + 1] |
      is_wall[2 * (k + WINDOW)] |
      is_wall[2 * k + 1]
    );
  }

  private smooth_square(k: number, place: number): void {
    const { heights: h } = this.walls;
    if (h[k] === VOID) return;
    const is_flat = STEP.every((step) => h[k + step] === h[k]);
    if (is_flat) this.flat[place] = h[k];
    else this.slope_square(k);
  }

  /** Cut along the diagonal that bends less. */
  private slope_square(k: number): void {
    const { heights: h } = this.walls;
    const [a, b, c, d] = STEP.map((step) => this.column_vertex(k + step));
    const bends = (first: number, second: number): number => Math.abs(h[k + first] - h[k + second]);
    if (bends(0, WINDOW + 1) <= bends(1, WINDOW)) this.out.two(a, b, c, d);
    else this.out.two(b, c, d, a);
  }

  /** A wall goes through it: what lies on each side of it, and the wall. */
  private crossed_square(k: number): void {
    const crossed = CORNERS.filter((side) => this.walls.is_wall[edges_of(k)[side]]);
    if (crossed.length === 1) return this.end_of_wall(k, crossed[0]);
    const ring: number[] = [];
    crossed.forEach((side, n) => {
      const last = crossed[(n + 1) % crossed.length];
      const first = ((side + 1) % 4) as Corner;
      this.beside_wall(k, side, first, last);
      ring.push(this.crossing(k, side, side), this.crossing(k, side, first));
    });
    if (crossed.length === 2) this.wall(k, crossed[0], crossed[1], ring);
    else this.fan(ring, this.middle(k));
  }

  /** From the wall on side `from` over corners `first` to `last` to the wall on side `last`. */
  private beside_wall(k: number, from: Corner, first: Corner, last: Corner): void {
    if (this.corner_height(k, first) === VOID) return;
    const loop = [this.crossing(k, from, first)];
    for (let corner = first; ; corner = ((corner + 1) % 4) as Corner) {
      loop.push(this.column_vertex(k + STEP[corner]));
      if (corner === last) break;
    }
    loop.push(this.crossing(k, last, last));
    for (let i = 2; i < loop.length; i++) this.out.triangle(loop[0], loop[i - 1], loop[i]);
    this.out.line_if(loop[0], loop[loop.length - 1], this.drop(k, from) > LEAST_LINE);
    if (CORNERS.some((corner) => this.corner_height(k, corner) === VOID)) this.below(loop);
  }

  /** The same polygon of the bottom, seen from below. */
  private below(loop: number[]): void {
    const bottom = this.field.grid.corner[2];
    const copy = loop.map((vertex) => this.out.copy(vertex, bottom, 0, 0, -1));
    for (let i = 2; i < copy.length; i++) this.out.triangle(copy[0], copy[i], copy[i - 1]);
    this.out.line_if(copy[0], copy[copy.length - 1], true);
  }

  private wall(k: number, side_a: Corner, side_b: Corner, ring: number[]): void {
    const { normal } = this.walls;
    const [a, b] = [edges_of(k)[side_a], edges_of(k)[side_b]];
    const quad = ring.map((vertex, i) => this.upright(vertex, i < 2 ? a : b));
    const x = normal[2 * a] + normal[2 * b];
    const y = normal[2 * a + 1] + normal[2 * b + 1];
    const faces = (v: number, w: number): boolean =>
      this.out.faces(quad[0], quad[v], quad[w], x, y);
    if (faces(1, 2) || faces(2, 3)) this.out.two(quad[0], quad[1], quad[2], quad[3]);
    else this.out.two(quad[3], quad[2], quad[1], quad[0]);
  }
  /** At the same place, with the normal of the wall across an edge. */
  private upright(vertex: number, edge: number): number {
    const { normal } = this.walls;
    return this.out.copy(vertex, null, normal[2 * edge], normal[2 * edge + 1], 0);
  }

  /** A wall that becomes a slope within this square. */
  private end_of_wall(k: number, side: Corner): void {
    const ring = [this.crossing(k, side, side), this.crossing(k, side, ((side + 1) % 4) as Corner)];
    for (let i = 1; i <= 4; i++) ring.push(this.column_vertex(k + STEP[(side + i) % 4]));
    this.fan(ring, this.middle(k));
  }

  private fan(ring: number[], middle: number): void {
    for (let i = 0; i < ring.length; i++)
      this.out.triangle(middle, ring[i], ring[(i + 1) % ring.length]);
  }

  private middle(k: number): number {
    const { corner } = this.field.grid;
    const z = CORNERS.map((c) => Math.max(corner[2], this.corner_height(k, c)));
    const low = Math.min(...z);
    return this.out.vertex(
      (this.x_of(k) + this.x_of(k + 1)) / 2,
      (this.y_of(k) + this.y_of(k + WINDOW)) / 2,
      (z[0] + z[1] + z[2] + z[3] + low) / 5,
      0,
      0,
      1,
    );
  }

  /** Where the wall crosses a side of the square, at the height of the corner before or behind it. */
  private crossing(k: number, side: Corner, corner: Corner): number {
    const edge = edges_of(k)[side];
    const at = edge >> 1;
    const share = this.walls.share[edge];
    const to = at + (edge & 1 ? WINDOW : 1);
    const x = this.x_of(at) + share * (this.x_of(to) - this.x_of(at));
    const y = this.y_of(at) + share * (this.y_of(to) - this.y_of(at));
    const height = this.corner_height(k, corner);
    if (height === VOID) return this.out.vertex(x, y, this.field.grid.corner[2], 0, 0, 1);
    const [nx, ny, nz] = this.normal_of(k + STEP[corner]);
    return this.out.vertex(x, y, height, nx, ny, nz);
  }

  private drop(k: number, side: Corner): number {
    const [a, b] = [side, ((side + 1) % 4) as Corner].map((c) => this.corner_height(k, c));
    return Math.abs(a - b) / Math.min(...this.field.grid.cell);
  }
  private corner_height = (k: number, corner: Corner): number =>
    this.walls.heights[k + STEP[corner]];

  private column_vertex(k: number): number {
    if (this.shared[k] >= 0) return this.shared[k];
    const [nx, ny, nz] = this.normal_of(k);
    return (this.shared[k] = this.out.vertex(
      this.x_of(k),
      this.y_of(k),
      this.walls.heights[k],
      nx,
      ny,
      nz,
    ));
  }

  /** Of the slopes around the column; walls are none. */
  private normal_of(k: number): [number, number, number] {
    const { cell } = this.field.grid;
    const x = -this.slope(k, 0) / cell[0];
    const y = -this.slope(k, 1) / cell[1];
    const length = Math.hypot(x, y, 1);
    return [x / length, y / length, 1 / length];
  }
  private slope(k: number, way: 0 | 1): number {
    const { heights, is_wall } = this.walls;
    const by = way ? WINDOW : 1;
    let sum = 0;
    let count = 0;
    for (const at of [k - by, k]) {
      const step = heights[at + by] - heights[at];
      if (is_wall[2 * at + way] || !Number.isFinite(step)) continue;
      sum += step;
      count++;
    }
    return count ? sum / count : 0;
  }

  // Rectangles

  /** Joins squares of one value to rectangles; NaN is none. */
  private rectangles(values: Float32Array, take: TakeRectangle): void {
    this.covered.fill(0);
    for (let j = 0; j < this.height; j++)
      for (let i = 0; i < this.width; i++) {
        const at = j * TILE_CELLS + i;
        if (values[at] === values[at] && !this.covered[at]) this.rectangle(values, i, j, take);
      }
  }

  /** From its first square as far along x as it goes, then along y. */
  private rectangle(values: Float32Array, i: number, j: number, take: TakeRectangle): void {
    const value = values[j * TILE_CELLS + i];
    const fits = (x: number, y: number): boolean =>
      values[y * TILE_CELLS + x] === value && !this.covered[y * TILE_CELLS + x];
    let x1 = i + 1;
    while (x1 < this.width && fits(x1, j)) x1++;
    let y1 = j + 1;
    while (y1 < this.height && this.row_fits(fits, i, x1, y1)) y1++;
    for (let y = j; y < y1; y++) this.covered.fill(1, y * TILE_CELLS + i, y * TILE_CELLS + x1);
    take(i, j, x1, y1, value);
  }
  private row_fits(fits: (x: number, y: number) => boolean, x0: number, x1: number, y: number) {
    for (let x = x0; x < x1; x++) if (!fits(x, y)) return false;
    return true;
  }

  private flat_top(x0: number, y0: number, x1: number, y1: number, height: number): void {
    this.out.plate(...this.plate_box(x0, y0, x1, y1), height, 1);
  }

  private plate_box(
    x0: number,
    y0: number,
    x1: number,
    y1: number,
  ): [number, number, number, number] {
    const at = (i: number, j: number): number => (j + APRON) * WINDOW + i + APRON;
    const [dx, dy] = this.field.grid.cell.map((size) => size * this.lap);
    return [
      this.x_of(at(x0, 0)) - dx,
      this.y_of(at(0, y0)) - dy,
      this.x_of(at(x1, 0)) + dx,
      this.y_of(at(0, y1)) + dy,
    ];
  }

  // Bottom and sides

  private bottom(): void {
    const bottom = this.field.grid.corner[2];
    const plate: TakeRectangle = (x0, y0, x1, y1) =>
      this.out.plate(...this.plate_box(x0, y0, x1, y1), bottom, -1);
    if (this.walls.any_void) this.rectangles(this.full_squares(), plate);
    else plate(0, 0, this.width, this.height, 1);
  }

  /** 1 where all corners have material below them; in the place of the flat tops, which are done. */
  private full_squares(): Float32Array {
    const full = this.flat.fill(NaN);
    for (let j = 0; j < this.height; j++)
      for (let i = 0; i < this.width; i++) {
        const k = (j + APRON) * WINDOW + i + APRON;
        const is_full = CORNERS.every((corner) => this.corner_height(k, corner) !== VOID);
        if (is_full) full[j * TILE_CELLS + i] = 1;
      }
    return full;
  }

  private sides(): void {
    const { nx, ny } = this.field.grid;
    const [x1, y1] = [this.width, this.height];
    if (this.j0 === 0) this.side([0, 0], [1, 0], x1, [0, -1]);
    if (this.j0 + y1 === ny - 1) this.side([x1, y1], [-1, 0], x1, [0, 1]);
    if (this.i0 === 0) this.side([0, y1], [0, -1], y1, [-1, 0]);
    if (this.i0 + x1 === nx - 1) this.side([x1, 0], [0, 1], y1, [1, 0]);
  }

  /** The side of the part from a column on, `count` squares in a way; outside is on the right. */
  private side(from: Flat, way: Flat, count: number, normal: Flat): void {
    let run = this.side_point(from);
    const outline: SidePoint[] = [run];
    for (let n = 1; n <= count; n++) {
      const next = this.side_point([from[0] + way[0] * n, from[1] + way[1] * n]);
      outline.push(...this.side_step(run, next, way[0] ? 0 : 1), next);
      run = next;
    }
    this.side_faces(outline, normal);
  }

  /** Where a wall crosses the side between two columns: a point at the height of each. */
  private side_step(run: SidePoint, next: SidePoint, axis: 0 | 1): SidePoint[] {
    const place = Math.min(run.k, next.k);
    const edge = 2 * place + axis;
    if (!this.walls.is_wall[edge]) return [];
    const share = this.walls.share[edge];
    const along = run.k === place ? share : 1 - share;
    const x = run.x + along * (next.x - run.x);
    const y = run.y + along * (next.y - run.y);
    return [
      { ...run, x, y },
      { ...next, x, y },
    ];
  }

  private side_point([i, j]: Flat): SidePoint {
    const k = (j + APRON) * WINDOW + i + APRON;
    return { k, x: this.x_of(k), y: this.y_of(k), z: this.walls.heights[k] };
  }

  private side_faces(outline: SidePoint[], normal: Flat): void {
    let begin = outline[0];
    outline.forEach((point, n) => {
      const behind = outline[n + 1];
      const goes_on = behind && behind.z === point.z && point.z === begin.z;
      if (n === 0 || goes_on) return;
      if (begin.z !== VOID && point.z !== VOID) this.side_face(begin, point, normal);
      begin = point;
    });
  }

  /** From the top of two points down to the bottom. */
  private side_face(begin: SidePoint, end: SidePoint, [nx, ny]: Flat): void {
    const { out } = this;
    const bottom = this.field.grid.corner[2];
    const a = out.vertex(begin.x, begin.y, begin.z, nx, ny, 0);
    const b = out.vertex(begin.x, begin.y, bottom, nx, ny, 0);
    const c = out.vertex(end.x, end.y, bottom, nx, ny, 0);
    const d = out.vertex(end.x, end.y, end.z, nx, ny, 0);
    out.two(a, b, c, d);
    out.line_if(a, d, true);
    out.line_if(b, c, true);
    out.line_if(a, b, this.is_corner(begin));
  }
  private is_corner({ k }: SidePoint): boolean {
    const { nx, ny } = this.field.grid;
    const i = this.column_of(k);
    const j = this.row_of(k);
    return (i === 0 || i === nx - 1) && (j === 0 || j === ny - 1);
  }

  // Places: the outermost columns stand at the border of the part

  private column_of = (k: number): number => this.i0 + (k % WINDOW) - APRON;
  private row_of = (k: number): number => this.j0 + Math.floor(k / WINDOW) - APRON;
  private x_of(k: number): number {
    return this.along(this.column_of(k), this.field.grid.nx, 0);
  }
  private y_of(k: number): number {
    return this.along(this.row_of(k), this.field.grid.ny, 1);
  }
  private along(index: number, count: number, way: 0 | 1): number {
    const { cell, corner } = this.field.grid;
    const place = index <= 0 ? 0 : index >= count - 1 ? count : index + 0.5;
    return corner[way] + place * cell[way];
  }
}

type Flat = [number, number];
type TakeRectangle = (x0: number, y0: number, x1: number, y1: number, value: number) => void;
interface SidePoint {
  k: number;
  x: number;
  y: number;
  z: number;
}
