/** Makes the bytes of a chunk as the server does, for tests. */
export interface VertexOfTest {
  xyz: [number, number, number];
  time_s?: number;
  feed?: number;
  speed?: number;
  motion?: number;
  line?: number;
  file?: number;
  kind?: number;
  tool?: number;
  power?: number;
  rotary?: [number, number];
}

export interface ChunkOfTest {
  run?: number;
  chunk?: number;
  first_motion?: number;
  time_base_s?: number;
  source?: number;
  vertices: VertexOfTest[];
}

export function chunk_bytes(wish: ChunkOfTest): ArrayBuffer {
  const n = wish.vertices.length;
  const rotary = wish.vertices.some((v) => v.rotary);
  const size = (bytes: number) => (bytes + 3) & ~3;
  const total =
    32 + 12 * n + 3 * 4 * n + 2 * 4 * n + size(2 * n) + 3 * size(n) + (rotary ? 8 * n : 0);
  const view = new DataView(new ArrayBuffer(total));
  [...'KPTH'].forEach((letter, i) => view.setUint8(i, letter.charCodeAt(0)));
  view.setUint16(4, 1 | (rotary ? 0x100 : 0), true);
  view.setUint16(6, wish.source ?? 0, true);
  view.setUint32(8, wish.run ?? 1, true);
  view.setUint32(12, wish.chunk ?? 0, true);
  view.setUint32(16, wish.first_motion ?? 0, true);
  view.setUint32(20, n, true);
  view.setFloat64(24, wish.time_base_s ?? 0, true);
  let at = 32;
  const floats = (values: number[]) =>
    values.forEach((v) => (view.setFloat32(at, v, true), (at += 4)));
  const words = (values: number[]) =>
    values.forEach((v) => (view.setUint32(at, v, true), (at += 4)));
  const bytes = (values: number[]) => {
    values.forEach((v, i) => view.setUint8(at + i, v));
    at += size(values.length);
  };
  const each = (value: (v: VertexOfTest) => number | undefined) =>
    wish.vertices.map((v) => value(v) ?? 0);
  floats(wish.vertices.flatMap((v) => v.xyz));
  floats(each((v) => v.time_s));
  floats(each((v) => v.feed));
  floats(each((v) => v.speed));
  words(each((v) => v.motion));
  words(each((v) => v.line));
  each((v) => v.file).forEach((v, i) => view.setUint16(at + 2 * i, v, true));
  at += size(2 * n);
  bytes(wish.vertices.map((v) => v.kind ?? 1));
  bytes(each((v) => v.tool));
  bytes(each((v) => v.power));
  if (rotary) floats(wish.vertices.flatMap((v) => v.rotary ?? [0, 0]));
  return view.buffer;
}
