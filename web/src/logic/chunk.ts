/** A binary frame of path geometry (docs/panel-protocol.md): header, then arrays, each padded to four bytes. */

export const Kind = { rapid: 0, cut: 1, none: 2, thread: 3, probe: 4 } as const;

export interface Chunk {
  source: 'preview' | 'trace';
  run: number;
  chunk: number;
  first_motion: number;
  vertices: number;
  time_base_s: number;
  xyz: Float32Array;
  time_s: Float32Array;
  feed_mm_min: Float32Array;
  speed_mm_min: Float32Array;
  motion: Uint32Array;
  line: Uint32Array;
  file: Uint16Array;
  kind: Uint8Array;
  tool: Uint8Array;
  power_percent: Uint8Array;
  /** Two angles a vertex, or null on a machine without rotary axes. */
  rotary: Float32Array | null;
}

const MAGIC = 'KPTH';
const VERSION = 1;
const HAS_ROTARY = 0x100;
const HEADER_BYTES = 32;

export class BadChunk extends Error {}

/** The arrays are views of `bytes`: nothing is copied. */
export function decode_chunk(bytes: ArrayBuffer): Chunk {
  const header = read_header(bytes);
  const n = header.vertices;
  const arrays = new ArrayReader(bytes, HEADER_BYTES);
  return {
    ...header,
    xyz: arrays.floats(3 * n),
    time_s: arrays.floats(n),
    feed_mm_min: arrays.floats(n),
    speed_mm_min: arrays.floats(n),
    motion: arrays.words(n),
    line: arrays.words(n),
    file: arrays.halves(n),
    kind: arrays.bytes(n),
    tool: arrays.bytes(n),
    power_percent: arrays.bytes(n),
    rotary: header.has_rotary ? arrays.floats(2 * n) : null,
  };
}

function read_header(bytes: ArrayBuffer) {
  if (bytes.byteLength < HEADER_BYTES) throw new BadChunk('a path chunk without a whole header');
  const view = new DataView(bytes);
  const magic = String.fromCharCode(...new Uint8Array(bytes, 0, 4));
  if (magic !== MAGIC) throw new BadChunk(`a binary frame that begins with ${magic}`);
  const version = view.getUint16(4, true);
  if ((version & 0xff) !== VERSION) throw new BadChunk(`path chunks of version ${version & 0xff}`);
  return {
    has_rotary: (version & HAS_ROTARY) !== 0,
    source: view.getUint16(6, true) === 0 ? ('preview' as const) : ('trace' as const),
    run: view.getUint32(8, true),
    chunk: view.getUint32(12, true),
    first_motion: view.getUint32(16, true),
    vertices: view.getUint32(20, true),
    time_base_s: view.getFloat64(24, true),
  };
}

class ArrayReader {
  constructor(
    private readonly buffer: ArrayBuffer,
    private at: number,
  ) {}

  floats(count: number): Float32Array {
    return new Float32Array(this.buffer, this.take(4 * count), count);
  }
  words(count: number): Uint32Array {
    return new Uint32Array(this.buffer, this.take(4 * count), count);
  }
  halves(count: number): Uint16Array {
    return new Uint16Array(this.buffer, this.take(2 * count), count);
  }
  bytes(count: number): Uint8Array {
    return new Uint8Array(this.buffer, this.take(count), count);
  }

  private take(size: number): number {
    const start = this.at;
    if (start + size > this.buffer.byteLength)
      throw new BadChunk('a path chunk that ends too early');
    this.at = start + ((size + 3) & ~3);
    return start;
  }
}
