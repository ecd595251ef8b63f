/** A height field in fewer columns: of each square of columns the one in its middle. */
import { type Grid, HeightField } from './height_field';

/** With so many times the columns it is worth while. */
const WORTH_WHILE = 1.4;

export class CoarseField {
  readonly field: HeightField;
  private seen: number;

  private constructor(
    private readonly of: HeightField,
    private readonly stride: number,
  ) {
    this.field = new HeightField(coarse_grid(of.grid, stride));
    this.seen = -1;
    this.follow();
  }

  /** With nearly so many columns along its longer side. Null: it has few as it is. */
  static of(field: HeightField, wanted: number): CoarseField | null {
    const side = Math.max(field.grid.nx, field.grid.ny);
    if (side < WORTH_WHILE * wanted || Math.min(field.grid.nx, field.grid.ny) < 16) return null;
    return new CoarseField(field, Math.max(2, Math.round(side / wanted)));
  }

  /** Takes over what has changed since the last time. */
  follow(): void {
    if (this.of.version === this.seen) return;
    this.seen = this.of.version;
    const { nx: columns, ny: rows } = this.field.grid;
    const { nx, ny } = this.of.grid;
    const heights = new Float32Array(columns * rows);
    for (let j = 0; j < rows; j++) {
      const row = Math.floor(((j + 0.5) * ny) / rows) * nx;
      for (let i = 0; i < columns; i++)
        heights[j * columns + i] = this.of.heights[row + Math.floor(((i + 0.5) * nx) / columns)];
    }
    this.field.take_heights(heights);
  }

  get is_coarser_by(): number {
    return this.stride;
  }
}

/** Over the same box: what the stride leaves over widens each cell a little. */
function coarse_grid({ nx, ny, cell, corner, top }: Grid, stride: number): Grid {
  const [columns, rows] = [Math.floor(nx / stride), Math.floor(ny / stride)];
  const wide: Grid['cell'] = [(nx * cell[0]) / columns, (ny * cell[1]) / rows];
  return { nx: columns, ny: rows, cell: wide, corner, top };
}
