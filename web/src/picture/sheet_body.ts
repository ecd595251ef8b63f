/** A sheet under a beam: a plate with what is burnt and what is cut, out of which pieces fall. */
import { Group, type DataTexture, MathUtils } from 'three';
import { between_stops, scale_colour, type Rgb, type Scheme } from '../logic/colour_scale';
import { hit_of_field } from '../logic/stock/field_ray';
import { far_corner, type Grid, HeightField, VOID } from '../logic/stock/height_field';
import type { SheetField, SheetPiece } from '../logic/stock/sheet_field';
import type { Body, BodyHit, Section, Vec } from './body';
import { FieldBody } from './field_body';
import { plane_of, SectionPlane } from './section_plane';
import { colour_table, type SurfaceColours } from './stock_material';

const FALL_MS = 700;
/** Of the longer side of the sheet: so far it falls. */
const FALL = 0.14;
const TILT_RAD = 0.12;
/** More and smaller ones are cut away without a fall. */
const MOST_PIECES = 200;
/** A piece has that many columns of nothing around it. */
const FRAME = 2;

/** Between two looks at all cells, so many times as long as one takes. */
const PAUSE = 9;

interface Falling {
  body: FieldBody;
  began: number;
  tilt: number;
}

export class SheetBody implements Body {
  readonly group = new Group();
  moves = false;
  private readonly field: HeightField;
  private readonly main: FieldBody;
  private readonly plane: SectionPlane;
  private readonly table: DataTexture = colour_table();
  private readonly falling = new Map<string, Falling>();
  private seen = -1;
  private follow_at = 0;
  private section: Section | null = null;
  private colours: SurfaceColours | null = null;

  constructor(
    private readonly sheet: SheetField,
    private readonly is_calm: () => boolean,
  ) {
    this.field = new HeightField(sheet.grid);
    this.main = new FieldBody(this.field, this.table);
    this.plane = new SectionPlane(this.main.materials);
    this.group.add(this.main.group, this.plane.mesh);
  }

  /** Of what burns: as wood and metal look, or by energy on the scale. */
  set_scheme(scheme: Scheme, by_energy: boolean): void {
    const data = this.table.image.data as Uint8Array;
    for (let i = 1; i < 256; i++) {
      const share = (i - 1) / 254;
      const colour = by_energy ? scale_colour(share, scheme) : burnt(share);
      colour.forEach((value, c) => (data[4 * i + c] = Math.round(255 * value)));
      data[4 * i + 3] = by_energy ? (i > 1 ? 255 : 0) : Math.round(235 * Math.min(1, 2.2 * share));
    }
    this.table.needsUpdate = true;
  }

  /** To follow takes a look at all cells: of a sheet of millions, now and then while it moves, and at rest at once. */
  update(most_ms: number, wants_coarse: boolean): boolean {
    const may_wait = wants_coarse && performance.now() < this.follow_at;
    if (this.seen !== this.sheet.version && !may_wait) this.follow();
    const is_done = this.main.update(most_ms);
    this.moves = false;
    for (const piece of this.falling.values()) {
      piece.body.update(most_ms);
      this.moves = this.let_fall(piece) || this.moves;
    }
    return is_done;
  }

  set_colours(colours: SurfaceColours): void {
    this.colours = colours;
    this.main.materials.set_colours(colours);
    for (const { body } of this.falling.values()) body.materials.set_colours(colours);
  }

  set_deviation(): void {}

  set_section(section: Section | null): void {
    this.section = section;
    this.plane.set(section, this.field.grid.corner, far_corner(this.field.grid));
  }

  hit(from: Vec, way: Vec): BodyHit | null {
    const found = hit_of_field(this.field, from, way, this.section && plane_of(this.section));
    return found && { ...found, owner: 0 };
  }

  dispose(): void {
    for (const { body } of this.falling.values()) body.dispose();
    this.main.dispose();
    this.plane.dispose();
    this.table.dispose();
    this.group.removeFromParent();
  }

  /** Takes over energy and cuts; what has come loose gets a body of its own, what is whole again goes back. */
  private follow(): void {
    const began = performance.now();
    this.seen = this.sheet.version;
    const heights = this.take_cells();
    const loose = this.sheet.pieces().filter(({ falls }) => falls);
    for (const { cells } of loose) for (const cell of cells) heights[cell] = VOID;
    this.let_go(new Map(loose.slice(0, MOST_PIECES).map((piece) => [key_of(piece), piece])));
    this.field.take_heights(heights);
    const now = performance.now();
    this.follow_at = now + PAUSE * (now - began);
  }

  /** The colours of all cells; the heights of those that are not cut. */
  private take_cells(): Float32Array {
    const { grid, energy, peak } = this.sheet;
    const heights = new Float32Array(grid.nx * grid.ny).fill(grid.top);
    for (let cell = 0; cell < heights.length; cell++) {
      if (this.sheet.is_cut(cell)) heights[cell] = VOID;
      this.field.owners[cell] = peak > 0 ? 1 + Math.round((254 * energy[cell]) / peak) : 1;
    }
    this.field.repainted.add(0);
    return heights;
  }

  /** These have come loose, no others. */
  private let_go(loose: Map<string, SheetPiece>): void {
    for (const [key, piece] of loose)
      if (!this.falling.has(key)) this.falling.set(key, this.begins_to_fall(piece));
    for (const [key, { body }] of this.falling) {
      if (loose.has(key)) continue;
      body.dispose();
      this.falling.delete(key);
    }
  }

  private begins_to_fall(piece: SheetPiece): Falling {
    const body = new FieldBody(this.field_of(piece), this.table);
    if (this.colours) body.materials.set_colours(this.colours);
    this.group.add(body.group);
    const tilt = (piece.cells[0] % 2 ? 1 : -1) * TILT_RAD;
    return { body, began: this.is_calm() ? -Infinity : performance.now(), tilt };
  }

  /** A piece alone, with its colours. */
  private field_of({ cells }: SheetPiece): HeightField {
    const { nx, top } = this.sheet.grid;
    const { i0, j0, grid } = framed(cells, this.sheet.grid);
    const field = new HeightField(grid);
    field.heights.fill(VOID);
    for (const at of cells) {
      const to = (Math.floor(at / nx) - j0) * grid.nx + (at % nx) - i0;
      field.heights[to] = top;
      field.owners[to] = this.field.owners[at];
    }
    field.repainted.add(0);
    return field;
  }

  /** True: it still falls. */
  private let_fall({ body, began, tilt }: Falling): boolean {
    const share = Math.min(1, (performance.now() - began) / FALL_MS);
    const { nx, ny, cell, corner } = this.sheet.grid;
    const far = FALL * Math.max(nx * cell[0], ny * cell[1]);
    const { grid } = body.field;
    const cx = grid.corner[0] + (grid.nx * cell[0]) / 2;
    const angle = tilt * MathUtils.smoothstep(share, 0, 1);
    body.group.rotation.y = angle;
    // About its own middle.
    body.group.position.set(
      cx * (1 - Math.cos(angle)) - corner[2] * Math.sin(angle),
      0,
      -far * share * share + cx * Math.sin(angle),
    );
    return share < 1;
  }
}

const key_of = ({ cells }: SheetPiece): string => `${cells[0]} ${cells.length}`;

/** The columns of a piece and a frame of nothing around it, from column i0, j0 of the sheet on. */
function framed(cells: Int32Array, { nx, cell, corner, top }: Grid) {
  const box = box_of(cells, nx);
  const [i0, j0] = [box.i0 - FRAME, box.j0 - FRAME];
  const grid: Grid = {
    nx: box.i1 - i0 + 1 + FRAME,
    ny: box.j1 - j0 + 1 + FRAME,
    cell,
    corner: [corner[0] + i0 * cell[0], corner[1] + j0 * cell[1], corner[2]],
    top,
  };
  return { i0, j0, grid };
}

function box_of(cells: Int32Array, nx: number) {
  const box = { i0: Infinity, i1: -1, j0: Infinity, j1: -1 };
  for (const at of cells) {
    const [i, j] = [at % nx, Math.floor(at / nx)];
    box.i0 = Math.min(box.i0, i);
    box.i1 = Math.max(box.i1, i);
    box.j0 = Math.min(box.j0, j);
    box.j1 = Math.max(box.j1, j);
  }
  return box;
}

const CHARRED: Rgb[] = [
  [0.79, 0.66, 0.47],
  [0.55, 0.34, 0.17],
  [0.24, 0.12, 0.06],
  [0.07, 0.05, 0.05],
];
const burnt = (share: number): Rgb => between_stops(CHARRED, 1.6 * share);
