/** Makes the bytes of frames of the part as the server does, for tests. */
export class StockBytes {
  private readonly parts: number[][] = [];
  private current: number[] = [];

  constructor(
    private readonly kind: number,
    private readonly wish: {
      run?: number;
      number?: number;
      level?: number;
      time_s?: number;
      version?: number;
      parts?: number;
    } = {},
  ) {}

  private put(size: number, write: (view: DataView) => void): this {
    const view = new DataView(new ArrayBuffer(size));
    write(view);
    this.current.push(...new Uint8Array(view.buffer));
    return this;
  }
  words = (...values: number[]): this =>
    this.each(4, values, (view, v) => view.setInt32(0, v, true));
  halves = (...values: number[]): this =>
    this.each(2, values, (view, v) => view.setUint16(0, v & 0xffff, true));
  bytes = (...values: number[]): this =>
    this.each(1, values, (view, v) => view.setUint8(0, v & 255));
  floats = (...values: number[]): this =>
    this.each(4, values, (view, v) => view.setFloat32(0, v, true));
  doubles = (...values: number[]): this =>
    this.each(8, values, (view, v) => view.setFloat64(0, v, true));

  private each(size: number, values: number[], write: (view: DataView, v: number) => void): this {
    for (const value of values) this.put(size, (view) => write(view, value));
    return this;
  }

  /** Ends a part. */
  part(): this {
    while (this.current.length % 4) this.current.push(0);
    this.parts.push(this.current);
    this.current = [];
    return this;
  }

  made(): ArrayBuffer {
    const { run = 1, number = 0, level = 0, time_s = 0, version = 1 } = this.wish;
    const head = new DataView(new ArrayBuffer(32));
    [...'KSTK'].forEach((letter, i) => head.setUint8(i, letter.charCodeAt(0)));
    head.setUint16(4, version, true);
    head.setUint16(6, this.kind, true);
    head.setUint32(8, run, true);
    head.setUint32(12, number, true);
    head.setUint32(16, level, true);
    head.setUint32(20, this.wish.parts ?? this.parts.length, true);
    head.setFloat64(24, time_s, true);
    return new Uint8Array([...new Uint8Array(head.buffer), ...this.parts.flat()]).buffer;
  }
}

/** A tile of heights z0 + dz · height. */
export function height_bytes(
  x: number,
  y: number,
  nx: number,
  height: number[],
  { z0 = 0, dz = 1, owner = height.map(() => 0), ...header }: HeightWish = {},
): ArrayBuffer {
  return new StockBytes(0, header)
    .words(x, y)
    .halves(nx, height.length / nx)
    .floats(z0, dz)
    .halves(...height)
    .halves(...owner)
    .part()
    .made();
}

interface HeightWish {
  z0?: number;
  dz?: number;
  owner?: number[];
  run?: number;
  number?: number;
  level?: number;
  time_s?: number;
}
