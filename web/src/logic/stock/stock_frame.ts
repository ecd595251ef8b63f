/**
 * A binary frame of the virtual part (docs/panel-protocol.md, Frames of the part): header, then parts, each padded to four
 * bytes. What is cut short, longer than it says, or says what cannot be is refused as a whole: no part of it is drawn.
 */

export interface StockHeader {
  run: number;
  /** Counts the frames of a run. */
  number: number;
  level: number;
  /** Of the state that is shown, seconds of the run. */
  time_s: number;
}

/** A tile of columns: their heights over the zero of the stock, and the motion that cut each last. */
export interface HeightTile {
  x: number;
  y: number;
  nx: number;
  ny: number;
  /** The height of a column is z0 + dz · height; NOTHING_LEFT: there is none. */
  z0: number;
  dz: number;
  height: Uint16Array;
  owner: Uint16Array;
}

/** A tile of triangles, which replaces what it was. */
export interface MeshTile {
  x: number;
  y: number;
  z: number;
  /** A vertex stands at origin + scale · position. */
  origin: [number, number, number];
  scale: number;
  position: Int16Array;
  /** Octahedral, two a vertex. */
  normal: Int8Array;
  owner: Uint16Array;
  index: Uint16Array;
  /** Of the vertices, as deviations_of() has it. */
  deviation?: Float32Array;
}

/** A closed line of the half section: from each corner a line or arc leads to the next. */
export interface ProfileLoop {
  z: Float64Array;
  /** A radius. */
  rho: Float64Array;
  /** The tangent of a quarter of the angle of the arc; 0: a line. */
  bulge: Float64Array;
  /** Of the pieces that begin at the corners: the motion that cut each last. */
  owner?: Uint16Array;
  /** At the corners, as deviations_of() has it. */
  deviation?: Float32Array;
}

export interface SheetTile {
  x: number;
  y: number;
  nx: number;
  ny: number;
  /** What 255 of `energy` stands for, J/mm². */
  full_scale: number;
  energy: Uint8Array;
  /** 255: wholly cut. */
  coverage: Uint8Array;
}

/** What is known of the places of a tile besides, in the order of its columns, its vertices or its corners. */
export interface FactTile {
  x: number;
  y: number;
  z: number;
  what: 'deviation' | 'owner';
  /** Of a deviation: millimetres a unit. */
  scale: number;
  value: Int16Array;
}

export type StockFrame = StockHeader &
  (
    | { kind: 'heights'; tiles: HeightTile[] }
    | { kind: 'mesh'; tiles: MeshTile[] }
    | { kind: 'profile'; loops: ProfileLoop[] }
    | { kind: 'sheet'; tiles: SheetTile[] }
    | { kind: 'facts'; tiles: FactTile[] }
  );

export class BadStockFrame extends Error {}

export const NOTHING_LEFT = 65535;
/** Of a place: no deviation is known. */
const UNKNOWN = -32768;
/** Columns from one tile to the next; a tile may have one row and column of its neighbours besides. */
export const TILE_CELLS = 64;

const MAGIC = 'KSTK';
const VERSION = 1;
const HEADER_BYTES = 32;
const MOST_IN_A_TILE = TILE_CELLS + 1;
/** Farther tiles than these no part has: they would only fill the memory. */
const FARTHEST_TILE = 1 << 15;
const MOST_CORNERS = 1 << 20;

export const is_stock_frame = (bytes: ArrayBuffer): boolean =>
  bytes.byteLength >= 4 && String.fromCharCode(...new Uint8Array(bytes, 0, 4)) === MAGIC;

/** The arrays are views of `bytes` but for those of a profile. */
export function decode_stock_frame(bytes: ArrayBuffer): StockFrame {
  const reader = new Reader(bytes);
  if (!is_stock_frame(bytes)) throw new BadStockFrame('a frame of the part that does not begin so');
  reader.skip(4);
  const version = reader.half();
  if (version !== VERSION) throw new BadStockFrame(`frames of the part of version ${version}`);
  const kind = reader.half();
  const header = { run: reader.word(), number: reader.word(), level: reader.word() };
  const parts = reader.word();
  const time_s = finite(reader.double(), 'time');
  const frame = { ...header, time_s, ...body(reader, kind, parts) };
  reader.must_be_at_end();
  return frame;
}

function body(reader: Reader, kind: number, parts: number) {
  const each = <T>(read: (reader: Reader) => T): T[] => {
    const list: T[] = [];
    // Each part has bytes of its own, so a number that lies ends at the end of the frame.
    for (let i = 0; i < parts; i++) {
      list.push(read(reader));
      reader.pad();
    }
    return list;
  };
  if (kind === 0) return { kind: 'heights' as const, tiles: each(height_tile) };
  if (kind === 1) return { kind: 'mesh' as const, tiles: each(mesh_tile) };
  if (kind === 2) return { kind: 'profile' as const, loops: each(profile_loop) };
  if (kind === 3) return { kind: 'sheet' as const, tiles: each(sheet_tile) };
  if (kind === 4) return { kind: 'facts' as const, tiles: each(fact_tile) };
  throw new BadStockFrame(`a frame of the part of kind ${kind}`);
}

function height_tile(reader: Reader): HeightTile {
  const [x, y] = [tile_place(reader), tile_place(reader)];
  const [nx, ny] = [cells(reader), cells(reader)];
  const z0 = finite(reader.float(), 'height');
  const dz = finite(reader.float(), 'height');
  return { x, y, nx, ny, z0, dz, height: reader.halves(nx * ny), owner: reader.halves(nx * ny) };
}

function mesh_tile(reader: Reader): MeshTile {
  const [x, y, z] = [tile_place(reader), tile_place(reader), tile_place(reader)];
  const vertices = reader.word();
  const triangles = reader.word();
  if (vertices > 65535) throw new BadStockFrame(`a tile of ${vertices} vertices`);
  const place = (): number => finite(reader.float(), 'place');
  const origin: [number, number, number] = [place(), place(), place()];
  const scale = place();
  const position = reader.signed_halves(3 * vertices);
  const normal = reader.signed_bytes(2 * vertices);
  const owner = reader.halves(vertices);
  const index = reader.halves(3 * triangles);
  if (index.some((vertex) => vertex >= vertices))
    throw new BadStockFrame('a triangle of a vertex that is not there');
  return { x, y, z, origin, scale, position, normal, owner, index };
}

function profile_loop(reader: Reader): ProfileLoop {
  const n = reader.word();
  if (n > MOST_CORNERS) throw new BadStockFrame(`a loop of ${n} corners`);
  const loop = {
    z: new Float64Array(n),
    rho: new Float64Array(n),
    bulge: new Float64Array(n),
  };
  reader.needs(24 * n);
  for (let i = 0; i < n; i++) {
    loop.z[i] = finite(reader.double(), 'corner');
    loop.rho[i] = finite(reader.double(), 'corner');
    loop.bulge[i] = finite(reader.double(), 'corner');
  }
  return loop;
}

function sheet_tile(reader: Reader): SheetTile {
  const [x, y] = [tile_place(reader), tile_place(reader)];
  const [nx, ny] = [cells(reader), cells(reader)];
  const full_scale = finite(reader.float(), 'energy');
  return {
    x,
    y,
    nx,
    ny,
    full_scale,
    energy: reader.bytes(nx * ny),
    coverage: reader.bytes(nx * ny),
  };
}

const FACTS = ['deviation', 'owner'] as const;

function fact_tile(reader: Reader): FactTile {
  const [x, y, z] = [tile_place(reader), tile_place(reader), tile_place(reader)];
  const what = FACTS[reader.half()];
  if (!what) throw new BadStockFrame('facts that nobody knows');
  reader.skip(2);
  const n = reader.word();
  return { x, y, z, what, scale: finite(reader.float(), 'scale'), value: reader.signed_halves(n) };
}

/** Where nothing is known of a place; no number, so that a texture can hold it. */
export const NO_DEVIATION = -1e9;

/** Millimetres: above 0 material is left, below 0 it is cut away; NO_DEVIATION: it is not known. */
export const deviations_of = ({ value, scale }: FactTile): Float32Array =>
  Float32Array.from(value, (raw) => (raw === UNKNOWN ? NO_DEVIATION : scale * raw));

function tile_place(reader: Reader): number {
  const place = reader.signed_word();
  if (Math.abs(place) > FARTHEST_TILE) throw new BadStockFrame(`a tile at ${place}`);
  return place;
}

function cells(reader: Reader): number {
  const count = reader.half();
  if (count < 1 || count > MOST_IN_A_TILE) throw new BadStockFrame(`a tile of ${count} columns`);
  return count;
}

function finite(value: number, what: string): number {
  if (!Number.isFinite(value)) throw new BadStockFrame(`a ${what} that is no number`);
  return value;
}

class Reader {
  private readonly view: DataView;
  private at = 0;

  constructor(private readonly buffer: ArrayBuffer) {
    this.view = new DataView(buffer);
    this.needs(HEADER_BYTES);
  }

  half = (): number => this.view.getUint16(this.take(2), true);
  word = (): number => this.view.getUint32(this.take(4), true);
  signed_word = (): number => this.view.getInt32(this.take(4), true);
  float = (): number => this.view.getFloat32(this.take(4), true);
  double = (): number => this.view.getFloat64(this.take(8), true);
  halves = (count: number): Uint16Array =>
    new Uint16Array(this.buffer, this.take(2 * count), count);
  signed_halves = (count: number): Int16Array =>
    new Int16Array(this.buffer, this.take(2 * count), count);
  bytes = (count: number): Uint8Array => new Uint8Array(this.buffer, this.take(count), count);
  signed_bytes = (count: number): Int8Array => new Int8Array(this.buffer, this.take(count), count);

  skip(bytes: number): void {
    this.take(bytes);
  }
  pad(): void {
    const over = this.at % 4;
    if (over) this.take(4 - over);
  }
  needs(bytes: number): void {
    if (this.at + bytes > this.buffer.byteLength)
      throw new BadStockFrame('a frame of the part that ends too early');
  }
  must_be_at_end(): void {
    if (this.at !== this.buffer.byteLength)
      throw new BadStockFrame('a frame of the part with something behind its end');
  }

  private take(bytes: number): number {
    this.needs(bytes);
    const start = this.at;
    this.at += bytes;
    return start;
  }
}

/** The unit vector of an octahedral normal, each of its two numbers -127 to 127. */
export function octahedral(u: number, v: number): [number, number, number] {
  let [x, y] = [Math.max(-1, u / 127), Math.max(-1, v / 127)];
  const z = 1 - Math.abs(x) - Math.abs(y);
  if (z < 0) {
    const turned = (1 - Math.abs(y)) * (x < 0 ? -1 : 1);
    y = (1 - Math.abs(x)) * (y < 0 ? -1 : 1);
    x = turned;
  }
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
}
