/**
 * The part as heights over its zero, put together from the tiles that have come. Column i, j stands in the middle of its cell;
 * cells fill the box of the stock exactly.
 */
import { type HeightTile, NO_DEVIATION, NOTHING_LEFT, TILE_CELLS } from './stock_frame';

/** The height of a column where nothing is left. */
export const VOID = -Infinity;

export interface Grid {
  nx: number;
  ny: number;
  /** mm. */
  cell: [number, number];
  /** The corner with the lowest coordinates: x, y and the bottom, from the zero of the stock. */
  corner: [number, number, number];
  /** Of the stock before anything was cut. */
  top: number;
}

/** The corner of the stock opposite to `corner`. */
export const far_corner = ({ nx, ny, cell, corner, top }: Grid): [number, number, number] => [
  corner[0] + nx * cell[0],
  corner[1] + ny * cell[1],
  top,
];

/** How far beside a tile its triangles look: a change there changes them as well. */
export const APRON = 8;

export class HeightField {
  readonly heights: Float32Array;
  readonly owners: Uint16Array;
  /** Of each column, as deviations_of() has it; null: nothing was ever known. */
  deviation: Float32Array<ArrayBuffer> | null = null;
  /** Tiles whose triangles are old, by `tile_key`. */
  readonly changed = new Set<number>();
  /** Tiles whose owners are others. */
  readonly repainted = new Set<number>();
  /** Counts the times that heights have changed. */
  version = 0;
  readonly tiles_x: number;
  readonly tiles_y: number;
  /** Columns and rows of the tiles that have come, by their places. */
  private readonly sizes = new Map<string, [number, number]>();

  constructor(readonly grid: Grid) {
    const { nx, ny, top } = grid;
    this.heights = new Float32Array(nx * ny).fill(top);
    this.owners = new Uint16Array(nx * ny);
    this.tiles_x = Math.max(1, Math.ceil((nx - 1) / TILE_CELLS));
    this.tiles_y = Math.max(1, Math.ceil((ny - 1) / TILE_CELLS));
    for (let key = 0; key < this.tiles_x * this.tiles_y; key++) this.changed.add(key);
  }

  tile_key = (x: number, y: number): number => y * this.tiles_x + x;

  /** What of a tile lies on the part; false: nothing. */
  put(tile: HeightTile): boolean {
    const { nx, ny } = this.grid;
    const i0 = tile.x * TILE_CELLS;
    const j0 = tile.y * TILE_CELLS;
    if (i0 < 0 || j0 < 0 || i0 >= nx || j0 >= ny) return false;
    const box = new ChangedBox();
    const rows = Math.min(tile.ny, ny - j0);
    for (let j = 0; j < rows; j++) this.put_row(tile, j, [i0, j0 + j], box);
    this.sizes.set(`${tile.x} ${tile.y}`, [tile.nx, tile.ny]);
    this.repainted.add(this.key_of_cell(i0, j0));
    this.mark(box);
    return true;
  }

  private put_row(tile: HeightTile, row: number, [i0, j]: [number, number], box: ChangedBox): void {
    const from = row * tile.nx;
    const to = j * this.grid.nx + i0;
    const columns = Math.min(tile.nx, this.grid.nx - i0);
    for (let i = 0; i < columns; i++) {
      this.owners[to + i] = tile.owner[from + i];
      if (!this.put_height(to + i, height_in(tile, from + i))) continue;
      box.add(i0 + i, j);
      // A column that has not changed is as far off as it was.
      if (this.deviation) this.deviation[to + i] = NO_DEVIATION;
    }
  }

  /** Of the columns of a tile that has come; of those beside the part nothing is kept. */
  put_deviation(x: number, y: number, values: Float32Array): void {
    const { nx, ny } = this.grid;
    const [columns, rows] = this.sizes.get(`${x} ${y}`) ?? [0, 0];
    if (columns === 0 || values.length !== columns * rows) return;
    this.deviation ??= new Float32Array(nx * ny).fill(NO_DEVIATION);
    const [i0, j0] = [x * TILE_CELLS, y * TILE_CELLS];
    const kept = Math.min(columns, nx - i0);
    for (let j = 0; j < Math.min(rows, ny - j0); j++)
      this.deviation.set(values.subarray(j * columns, j * columns + kept), (j0 + j) * nx + i0);
    this.repainted.add(this.key_of_cell(i0, j0));
  }
  /** True: it was another one. */
  private put_height(cell: number, height: number): boolean {
    if (this.heights[cell] === height) return false;
    this.heights[cell] = height;
    return true;
  }

  /** All heights at once; of the triangles only those become old that another height bears upon. */
  take_heights(heights: Float32Array): void {
    const { nx, ny } = this.grid;
    for (let y = 0; y < this.tiles_y; y++) {
      for (let x = 0; x < this.tiles_x; x++) {
        const end: [number, number] = [
          this.end_of(x, this.tiles_x, nx),
          this.end_of(y, this.tiles_y, ny),
        ];
        this.mark(this.take_tile(heights, [x * TILE_CELLS, y * TILE_CELLS], end));
      }
    }
  }
  private take_tile(
    heights: Float32Array,
    [i0, j0]: [number, number],
    [i1, j1]: [number, number],
  ): ChangedBox {
    const { nx } = this.grid;
    const box = new ChangedBox();
    for (let j = j0; j < j1; j++)
      for (let i = i0; i < i1; i++)
        if (this.put_height(j * nx + i, heights[j * nx + i])) box.add(i, j);
    return box;
  }
  private end_of = (tile: number, tiles: number, count: number): number =>
    tile === tiles - 1 ? count : (tile + 1) * TILE_CELLS;

  /** Takes over heights and owners of another one of the same part. */
  look_like(other: HeightField): void {
    const { nx, ny } = this.grid;
    const { nx: columns, ny: rows } = other.grid;
    for (let j = 0; j < ny; j++) {
      const row = Math.floor(((j + 0.5) * rows) / ny) * columns;
      for (let i = 0; i < nx; i++) {
        const from = row + Math.floor(((i + 0.5) * columns) / nx);
        this.heights[j * nx + i] = other.heights[from];
        this.owners[j * nx + i] = other.owners[from];
      }
    }
    this.repainted.add(0);
    this.version++;
  }

  /** Null: beside the part, or nothing is left there. */
  height_at(x: number, y: number): number | null {
    const at = this.cell_at(x, y);
    const height = at < 0 ? VOID : this.heights[at];
    return height === VOID ? null : height;
  }
  owner_at(x: number, y: number): number {
    const at = this.cell_at(x, y);
    return at < 0 ? 0 : this.owners[at];
  }

  private cell_at(x: number, y: number): number {
    const { nx, ny, cell, corner } = this.grid;
    const i = Math.floor((x - corner[0]) / cell[0]);
    const j = Math.floor((y - corner[1]) / cell[1]);
    return i < 0 || j < 0 || i >= nx || j >= ny ? -1 : j * nx + i;
  }
  private key_of_cell(i: number, j: number): number {
    const within = (cell: number, tiles: number) =>
      Math.min(tiles - 1, Math.max(0, Math.floor(cell / TILE_CELLS)));
    return this.tile_key(within(i, this.tiles_x), within(j, this.tiles_y));
  }
  private mark({ i0, i1, j0, j1 }: ChangedBox): void {
    if (i1 < i0) return;
    this.version++;
    const low = this.key_of_cell(i0 - APRON, j0 - APRON);
    const high = this.key_of_cell(i1 + APRON, j1 + APRON);
    for (let y = Math.floor(low / this.tiles_x); y <= Math.floor(high / this.tiles_x); y++)
      for (let x = low % this.tiles_x; x <= high % this.tiles_x; x++)
        this.changed.add(this.tile_key(x, y));
  }
}

function height_in({ z0, dz, height }: HeightTile, at: number): number {
  const raw = height[at];
  return Math.fround(raw === NOTHING_LEFT ? VOID : z0 + dz * raw);
}

class ChangedBox {
  i0 = Infinity;
  i1 = -Infinity;
  j0 = Infinity;
  j1 = -Infinity;
  add(i: number, j: number): void {
    if (i < this.i0) this.i0 = i;
    if (i > this.i1) this.i1 = i;
    if (j < this.j0) this.j0 = j;
    if (j > this.j1) this.j1 = j;
  }
}
