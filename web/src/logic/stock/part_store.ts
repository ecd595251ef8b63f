/** What is known of the part: what the event `stock` has told, and what its frames show. */
import type { Diagnostic } from '../protocol';
import { type Grid, HeightField } from './height_field';
import { put_facts } from './part_facts';
import type { MeshTile, ProfileLoop, StockFrame } from './stock_frame';
import { SheetField } from './sheet_field';

export type StockModel = 'zmap' | 'tridexel' | 'profile' | 'sheet';

export interface GridOfLevel {
  /** The middle of the first column, from the zero of the stock. */
  first: [number, number];
  cell_mm: [number, number];
  cells: [number, number];
}

/** A finding of the run against the part. */
export interface Finding extends Diagnostic {
  file: string;
  time_s: number;
  tool: number;
  motion: number;
  /** From the zero of the stock; of a lathe X is a radius. */
  at: [number, number, number];
  depth_mm: number;
  volume_mm3: number;
  /** How often the block did it. */
  count: number;
}

export interface Thread {
  line: number;
  from: number;
  to: number;
  major: number;
  minor: number;
  pitch: number;
  starts: number;
}

export interface PartFacts {
  run: number;
  model: StockModel | '';
  reason: string;
  /** Its zero in machine coordinates, and the box of the stock from there. */
  stock: { origin: number[]; low: number[]; high: number[] } | null;
  levels: (GridOfLevel | null)[];
  files: string[];
  done_s: number;
  done: boolean;
  removed_mm3: number;
  findings: Finding[];
  more_findings: number;
  threads: Thread[];
  /** What it is compared with; null: with nothing. */
  design: { file: string; tolerance_mm: number } | null;
  behind: boolean;
  error: { message: string; code?: string; values?: Record<string, string> } | null;
}

export interface Owner {
  file: number;
  line: number;
  tool: number;
  /** The largest angle over which the tool was in the material; null: it is not known. */
  engagement_deg: number | null;
}

const NOTHING: PartFacts = {
  run: -1,
  model: '',
  reason: '',
  stock: null,
  levels: [],
  files: [],
  done_s: 0,
  done: false,
  removed_mm3: 0,
  findings: [],
  more_findings: 0,
  threads: [],
  design: null,
  behind: false,
  error: null,
};

/** What a model shows; another one replaces it as a whole. */
export type Shape =
  | { kind: 'heights'; field: HeightField }
  | { kind: 'mesh'; tiles: Map<string, MeshTile>; changed: Set<string> }
  | {
      kind: 'profile';
      loops: ProfileLoop[];
      /** Take the place of the loops when it is known who has cut them. */
      next: ProfileLoop[] | null;
    }
  | { kind: 'sheet'; field: SheetField };

interface OwnerRows {
  from: number;
  rows: (number | null)[][];
}

function owner_of([file, line, tool, engagement_deg]: (number | null)[]): Owner {
  return {
    file: file ?? 0,
    line: line ?? 0,
    tool: tool ?? 0,
    engagement_deg: engagement_deg ?? null,
  };
}

export class PartStore {
  facts: PartFacts = NOTHING;
  owners: Owner[] = [];
  shape: Shape | null = null;
  level = 0;
  /** Of the state that is shown. */
  time_s = 0;
  /** Counts what has changed in shape or owners. */
  version = 0;
  owners_version = 0;
  private run = -1;

  clear(): void {
    this.facts = NOTHING;
    this.owners = [];
    this.shape = null;
    this.run = -1;
    this.version++;
    this.owners_version++;
  }

  /** Keys that have not changed are not told again, but of another run all is new. */
  take_event(event: Record<string, unknown>): void {
    const { owners, ...told } = event;
    if (typeof told.run === 'number' && told.run !== this.facts.run) {
      this.facts = NOTHING;
      this.owners = [];
    }
    const facts = { ...this.facts };
    for (const key of Object.keys(NOTHING) as (keyof PartFacts)[])
      if (key in told) (facts as Record<string, unknown>)[key] = told[key];
    this.facts = facts;
    if (owners) this.take_owners(owners as OwnerRows);
  }

  /** False: it shows nothing of this part. */
  take_frame(frame: StockFrame): boolean {
    if (frame.kind === 'facts') return this.take_facts(frame);
    const is_new =
      frame.number === 0 || frame.run !== this.run || frame.level !== this.level || !this.shape;
    if (is_new || this.shape?.kind !== frame.kind) {
      const shape = this.new_shape(frame);
      if (!shape) return false;
      this.shape = shape;
    }
    this.run = frame.run;
    this.level = frame.level;
    this.time_s = frame.time_s;
    put(this.shape!, frame);
    this.version++;
    return true;
  }

  /** They speak of the tiles that are there: not of another run, nor of another level. */
  private take_facts(frame: StockFrame & { kind: 'facts' }): boolean {
    const { shape } = this;
    if (!shape || frame.run !== this.run || frame.level !== this.level) return false;
    for (const tile of frame.tiles) put_facts(shape, tile);
    this.version++;
    return true;
  }

  private take_owners({ from, rows }: OwnerRows): void {
    if (!rows.length && (from > 0 || !this.owners.length)) return;
    if (from === 0) this.owners = [];
    rows.forEach((row, i) => (this.owners[from + i] = owner_of(row)));
    this.owners_version++;
  }

  private new_shape(frame: StockFrame): Shape | null {
    if (frame.kind === 'mesh') return { kind: 'mesh', tiles: new Map(), changed: new Set() };
    if (frame.kind === 'profile') return { kind: 'profile', loops: [], next: null };
    const grid = this.grid_of(frame.level);
    if (!grid) return null;
    if (frame.kind === 'sheet') return { kind: 'sheet', field: new SheetField(grid) };
    const field = new HeightField(grid);
    // Until its own tiles are there a finer level looks like the one before.
    if (this.shape?.kind === 'heights' && frame.run === this.run) field.look_like(this.shape.field);
    return { kind: 'heights', field };
  }

  private grid_of(level: number): Grid | null {
    const { stock, levels } = this.facts;
    const grid = levels[level];
    if (!stock || !grid) return null;
    const [nx, ny] = grid.cells;
    if (!(nx >= 1 && ny >= 1 && nx * ny <= MOST_CELLS)) return null;
    const corner = [0, 1].map((i) => grid.first[i] - grid.cell_mm[i] / 2);
    return {
      nx,
      ny,
      cell: grid.cell_mm,
      corner: [corner[0], corner[1], stock.low[2]],
      top: stock.high[2],
    };
  }
}

/** More than any server shows: what says so is wrong. */
const MOST_CELLS = 1 << 26;

function put(shape: Shape, frame: StockFrame): void {
  if (shape.kind === 'profile' && frame.kind === 'profile') {
    if (frame.loops.length) put_loops(shape, frame.loops);
  } else if (shape.kind === 'mesh' && frame.kind === 'mesh') {
    for (const tile of frame.tiles) put_triangles(shape, tile);
  } else if (shape.kind === 'sheet' && frame.kind === 'sheet') {
    for (const tile of frame.tiles) shape.field.put(tile);
  } else if (shape.kind === 'heights' && frame.kind === 'heights') {
    for (const tile of frame.tiles) shape.field.put(tile);
  }
}

/** Who has cut them comes behind them: so that no colour flickers, those before are seen until then. */
function put_loops(shape: Shape & { kind: 'profile' }, loops: ProfileLoop[]): void {
  const waits = shape.loops.some(({ owner }) => owner !== undefined);
  if (waits) shape.next = loops;
  else shape.loops = loops;
}

/** They replace what the tile was; none: nothing is left there. */
function put_triangles({ tiles, changed }: Shape & { kind: 'mesh' }, tile: MeshTile): void {
  const key = `${tile.x} ${tile.y} ${tile.z}`;
  if (tile.index.length) tiles.set(key, tile);
  else tiles.delete(key);
  changed.add(key);
}
