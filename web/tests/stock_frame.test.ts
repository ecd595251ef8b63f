import { describe, expect, it } from 'vitest';
import {
  BadStockFrame,
  decode_stock_frame,
  deviations_of,
  is_stock_frame,
  NO_DEVIATION,
  NOTHING_LEFT,
  octahedral,
} from '../src/logic/stock/stock_frame';
import { random } from './random';
import { height_bytes, StockBytes } from './stock_bytes';

const heights = height_bytes(-1, 2, 3, [0, 10, 20, 30, 40, NOTHING_LEFT], {
  z0: -20,
  dz: 0.5,
  owner: [1, 2, 3, 4, 5, 6],
  run: 9,
  number: 4,
  level: 1,
  time_s: 2.5,
});

const mesh = new StockBytes(1, { run: 3 })
  .words(0, 1, -2, 3, 1)
  .floats(10, 20, 30, 0.25)
  .halves(0, 0, 0, 4, 0, 0, 0, 4, -4)
  .bytes(0, 0, 127, 0, 0, -127)
  .halves(7, 8, 9)
  .halves(0, 1, 2)
  .part()
  .made();

const sheet = new StockBytes(3, {})
  .words(0, 0)
  .halves(3, 1)
  .floats(12.5)
  .bytes(0, 128, 255)
  .bytes(255, 0, 100)
  .part()
  .made();

const profile = new StockBytes(2, {})
  .words(3)
  .doubles(0, 0, 0, 0, 10, 0.5, -20, 10, 0)
  .part()
  .words(0)
  .part()
  .made();

const facts = new StockBytes(4)
  .words(1, 2, -3)
  .halves(0, 0)
  .words(3)
  .floats(0.25)
  .halves(4, -2, -32768)
  .part()
  .words(0, 0, 0)
  .halves(1, 0)
  .words(2)
  .floats(1)
  .halves(7, 65535)
  .part()
  .made();

describe('a frame of the part', () => {
  it('of heights has tiles with their places, heights and owners', () => {
    const frame = decode_stock_frame(heights);
    expect(frame).toMatchObject({ kind: 'heights', run: 9, number: 4, level: 1, time_s: 2.5 });
    if (frame.kind !== 'heights') throw new Error(frame.kind);
    const [tile] = frame.tiles;
    expect(tile).toMatchObject({ x: -1, y: 2, nx: 3, ny: 2, z0: -20, dz: 0.5 });
    expect([...tile.height]).toEqual([0, 10, 20, 30, 40, NOTHING_LEFT]);
    expect([...tile.owner]).toEqual([1, 2, 3, 4, 5, 6]);
  });

  it('of triangles has signed places and normals', () => {
    const frame = decode_stock_frame(mesh);
    if (frame.kind !== 'mesh') throw new Error(frame.kind);
    const [tile] = frame.tiles;
    expect(tile).toMatchObject({ x: 0, y: 1, z: -2, origin: [10, 20, 30], scale: 0.25 });
    expect([...tile.position]).toEqual([0, 0, 0, 4, 0, 0, 0, 4, -4]);
    expect([...tile.normal]).toEqual([0, 0, 127, 0, 0, -127]);
    expect([...tile.owner]).toEqual([7, 8, 9]);
    expect([...tile.index]).toEqual([0, 1, 2]);
  });

  it('of a profile has closed lines, also empty ones', () => {
    const frame = decode_stock_frame(profile);
    if (frame.kind !== 'profile') throw new Error(frame.kind);
    expect(frame.loops.map(({ z }) => [...z])).toEqual([[0, 0, -20], []]);
    expect([...frame.loops[0].rho]).toEqual([0, 10, 10]);
    expect([...frame.loops[0].bulge]).toEqual([0, 0.5, 0]);
  });

  it('of a sheet has energy and coverage', () => {
    const frame = decode_stock_frame(sheet);
    if (frame.kind !== 'sheet') throw new Error(frame.kind);
    expect(frame.tiles[0]).toMatchObject({ nx: 3, ny: 1, full_scale: 12.5 });
    expect([...frame.tiles[0].energy]).toEqual([0, 128, 255]);
    expect([...frame.tiles[0].coverage]).toEqual([255, 0, 100]);
  });

  it('of facts says what is known of places: how far off they are, and who has cut them', () => {
    const frame = decode_stock_frame(facts);
    if (frame.kind !== 'facts') throw new Error(frame.kind);
    const [off, owners] = frame.tiles;
    expect(off).toMatchObject({ x: 1, y: 2, z: -3, what: 'deviation', scale: 0.25 });
    expect([...deviations_of(off)]).toEqual([1, -0.5, NO_DEVIATION]);
    expect(owners.what).toBe('owner');
    expect([...owners.value]).toEqual([7, -1]);
  });
  it('is told from a chunk of a path by its first letters', () => {
    expect(is_stock_frame(heights)).toBe(true);
    expect(is_stock_frame(new TextEncoder().encode('KPTH').buffer as ArrayBuffer)).toBe(false);
    expect(is_stock_frame(new ArrayBuffer(2))).toBe(false);
  });
});

describe('a frame is refused that', () => {
  const all = { heights, mesh, sheet, profile, facts };
  it.each(Object.entries(all))('is cut short anywhere: %s', (_, whole) => {
    for (let bytes = 0; bytes < whole.byteLength; bytes++)
      expect(() => decode_stock_frame(whole.slice(0, bytes)), String(bytes)).toThrow(BadStockFrame);
  });

  it.each(Object.entries(all))('has something behind its end: %s', (_, whole) => {
    const longer = new Uint8Array(whole.byteLength + 4);
    longer.set(new Uint8Array(whole));
    expect(() => decode_stock_frame(longer.buffer)).toThrow(BadStockFrame);
  });

  const changed = (whole: ArrayBuffer, change: (view: DataView) => void): ArrayBuffer => {
    const copy = whole.slice(0);
    change(new DataView(copy));
    return copy;
  };
  it.each([
    ['is of another version', changed(heights, (v) => v.setUint16(4, 2, true))],
    ['is of an unknown kind', changed(heights, (v) => v.setUint16(6, 5, true))],
    [
      'says that it has four milliards of parts',
      changed(heights, (v) => v.setUint32(20, 2 ** 32 - 1, true)),
    ],
    ['has a time that is no number', changed(heights, (v) => v.setFloat64(24, NaN, true))],
    ['has a tile beyond all parts', changed(heights, (v) => v.setInt32(32, 2 ** 31 - 1, true))],
    ['has a tile of 66 columns', changed(heights, (v) => v.setUint16(40, 66, true))],
    ['has a tile without columns', changed(heights, (v) => v.setUint16(40, 0, true))],
    ['has a height that is no number', changed(heights, (v) => v.setFloat32(44, Infinity, true))],
    [
      'has a triangle of a vertex that is not there',
      changed(mesh, (v) => v.setUint16(mesh.byteLength - 4, 3, true)),
    ],
    [
      'says that it has four milliards of vertices',
      changed(mesh, (v) => v.setUint32(44, 2 ** 32 - 1, true)),
    ],
    ['has facts of an unknown kind', changed(facts, (v) => v.setUint16(44, 2, true))],
    ['has a scale that is no number', changed(facts, (v) => v.setFloat32(52, NaN, true))],
    ['has facts of too many places', changed(facts, (v) => v.setUint32(48, 2 ** 31, true))],
    ['has a corner that is no number', changed(profile, (v) => v.setFloat64(36, NaN, true))],
    ['has a loop of too many corners', changed(profile, (v) => v.setUint32(32, 2 ** 31, true))],
  ])('%s', (_, bytes) => expect(() => decode_stock_frame(bytes)).toThrow(BadStockFrame));

  it('or is read, whatever bytes it has: nothing else happens', () => {
    const next = random(7);
    for (let round = 0; round < 3000; round++) {
      const frames = Object.values(all);
      const bytes = new Uint8Array(frames[round % 4].slice(0));
      for (let i = 0; i < 3; i++)
        bytes[Math.floor(next() * bytes.length)] = Math.floor(next() * 256);
      try {
        decode_stock_frame(bytes.buffer);
      } catch (reason) {
        expect(reason).toBeInstanceOf(BadStockFrame);
      }
    }
  });
});

describe('an octahedral normal', () => {
  it('is a unit vector, and the axes are exact', () => {
    expect(octahedral(0, 0)).toEqual([0, 0, 1]);
    expect(octahedral(127, 0)).toEqual([1, 0, 0]);
    expect(octahedral(0, -127)).toEqual([0, -1, 0]);
    for (const corner of [octahedral(127, 127), octahedral(-127, 127)]) expect(corner[2]).toBe(-1);
    for (let u = -127; u <= 127; u += 13)
      for (let v = -127; v <= 127; v += 11)
        expect(Math.hypot(...octahedral(u, v))).toBeCloseTo(1, 12);
  });
});
