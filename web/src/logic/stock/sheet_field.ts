/**
 * A sheet under a beam: what each of its cells has got, how much of it is cut, and the pieces that come loose. A piece is a
 * connected part of what is left; one that does not reach the border of the sheet falls.
 */
import type { Grid } from './height_field';
import { type SheetTile, TILE_CELLS } from './stock_frame';

/** From this coverage on a cell is cut. */
const CUT = 128;
const LEAST_PIECE_CELLS = 4;

export interface SheetPiece {
  /** Its cells. */
  cells: Int32Array;
  falls: boolean;
}

export class SheetField {
  /** J/mm². */
  readonly energy: Float32Array;
  readonly coverage: Uint8Array;
  /** The largest energy of a cell. */
  peak = 0;
  /** Changes with every tile that is another one. */
  version = 0;

  constructor(readonly grid: Grid) {
    this.energy = new Float32Array(grid.nx * grid.ny);
    this.coverage = new Uint8Array(grid.nx * grid.ny);
  }

  put(tile: SheetTile): void {
    const { nx, ny } = this.grid;
    const i0 = tile.x * TILE_CELLS;
    const j0 = tile.y * TILE_CELLS;
    if (i0 < 0 || j0 < 0) return;
    for (let j = 0; j < tile.ny && j0 + j < ny; j++) {
      for (let i = 0; i < tile.nx && i0 + i < nx; i++) {
        const from = j * tile.nx + i;
        const to = (j0 + j) * nx + i0 + i;
        this.energy[to] = (tile.full_scale * tile.energy[from]) / 255;
        this.coverage[to] = tile.coverage[from];
        if (this.energy[to] > this.peak) this.peak = this.energy[to];
      }
    }
    this.version++;
  }

  is_cut = (cell: number): boolean => this.coverage[cell] >= CUT;

  /** The largest first; crumbs are left out. */
  pieces(): SheetPiece[] {
    const { nx, ny } = this.grid;
    const seen = new Uint8Array(nx * ny);
    const queue = new Int32Array(nx * ny);
    const pieces: SheetPiece[] = [];
    for (let start = 0; start < seen.length; start++) {
      if (seen[start] || this.is_cut(start)) continue;
      let [head, tail] = [0, 0];
      let falls = true;
      queue[tail++] = start;
      seen[start] = 1;
      const visit = (cell: number): void => {
        if (seen[cell] || this.is_cut(cell)) return;
        seen[cell] = 1;
        queue[tail++] = cell;
      };
      while (head < tail) {
        const cell = queue[head++];
        const i = cell % nx;
        const j = (cell - i) / nx;
        if (i === 0 || j === 0 || i === nx - 1 || j === ny - 1) falls = false;
        if (i > 0) visit(cell - 1);
        if (i < nx - 1) visit(cell + 1);
        if (j > 0) visit(cell - nx);
        if (j < ny - 1) visit(cell + nx);
      }
      if (tail >= LEAST_PIECE_CELLS) pieces.push({ cells: queue.slice(0, tail), falls });
    }
    return pieces.sort((a, b) => b.cells.length - a.cells.length);
  }
}
