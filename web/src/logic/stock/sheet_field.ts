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
    const search = new PieceSearch(this.grid, this.is_cut);
    const pieces: SheetPiece[] = [];
    for (let cell = 0; cell < this.coverage.length; cell++) {
      const piece = search.piece_of(cell);
      if (piece && piece.cells.length >= LEAST_PIECE_CELLS) pieces.push(piece);
    }
    return pieces.sort((a, b) => b.cells.length - a.cells.length);
  }
}

/** From a cell to its neighbours, each cell once. */
class PieceSearch {
  private readonly seen: Uint8Array;
  private readonly queue: Int32Array;
  private tail = 0;

  constructor(
    private readonly grid: Grid,
    private readonly is_cut: (cell: number) => boolean,
  ) {
    this.seen = new Uint8Array(grid.nx * grid.ny);
    this.queue = new Int32Array(grid.nx * grid.ny);
  }

  /** Null: the cell is cut, or of a piece that is known. */
  piece_of(start: number): SheetPiece | null {
    this.tail = 0;
    this.visit(start);
    if (this.tail === 0) return null;
    let falls = true;
    for (let head = 0; head < this.tail; head++) if (this.spread(this.queue[head])) falls = false;
    return { cells: this.queue.slice(0, this.tail), falls };
  }

  /** True: the cell lies at the border of the sheet. */
  private spread(cell: number): boolean {
    const { nx, ny } = this.grid;
    const i = cell % nx;
    const j = (cell - i) / nx;
    if (i > 0) this.visit(cell - 1);
    if (i < nx - 1) this.visit(cell + 1);
    if (j > 0) this.visit(cell - nx);
    if (j < ny - 1) this.visit(cell + nx);
    return i === 0 || j === 0 || i === nx - 1 || j === ny - 1;
  }

  private visit(cell: number): void {
    if (this.seen[cell] || this.is_cut(cell)) return;
    this.seen[cell] = 1;
    this.queue[this.tail++] = cell;
  }
}
