import { describe, expect, it } from 'vitest';
import { decode_chunk } from '../src/logic/chunk';
import { BLOCK, PathStore, last_not_above } from '../src/logic/path_store';
import { type VertexOfTest, chunk_bytes } from './chunk_bytes';

/** Along X, a millimetre and a second a vertex; line i makes the segment that ends at x = i. */
function straight(
  from: number,
  to: number,
  more: (i: number) => Partial<VertexOfTest> = () => ({}),
) {
  return Array.from({ length: to - from + 1 }, (_, k) => {
    const i = from + k;
    const vertex: VertexOfTest = { xyz: [i, 0, 0], time_s: k, line: i, motion: i };
    return { ...vertex, ...more(i) };
  });
}

const add = (store: PathStore, vertices: VertexOfTest[], chunk = 0, run = 1) =>
  store.add(decode_chunk(chunk_bytes({ run, chunk, time_base_s: vertices[0].xyz[0], vertices })));

function two_chunks(): PathStore {
  const store = new PathStore();
  add(store, straight(0, 4));
  add(store, straight(4, 9), 1);
  return store;
}

describe('time', () => {
  it('leads to the place between two vertices', () => {
    const store = two_chunks();
    expect(store.place_at(2.25)).toEqual({ chunk: 0, vertex: 2, fraction: 0.25 });
    expect(store.point_at(store.place_at(6.5)!)).toEqual([6.5, 0, 0]);
  });
  it('before and behind the path leads to its ends', () => {
    const store = two_chunks();
    expect(store.point_at(store.place_at(-1)!)).toEqual([0, 0, 0]);
    expect(store.point_at(store.place_at(99)!)).toEqual([9, 0, 0]);
  });
  it('of an empty path leads nowhere', () => {
    expect(new PathStore().place_at(1)).toBeNull();
  });
  it('stays on a dwell while it lasts', () => {
    const store = new PathStore();
    add(store, [
      { xyz: [0, 0, 0], time_s: 0 },
      { xyz: [1, 0, 0], time_s: 1 },
      { xyz: [1, 0, 0], time_s: 3, kind: 2 },
      { xyz: [2, 0, 0], time_s: 4 },
    ]);
    expect(store.point_at(store.place_at(2)!)).toEqual([1, 0, 0]);
    expect(store.point_at(store.place_at(3.5)!)).toEqual([1.5, 0, 0]);
  });
});

describe('lines', () => {
  it('lead to all their segments, also across chunks', () => {
    const store = new PathStore();
    add(
      store,
      straight(0, 4, (i) => ({ line: i >= 3 ? 50 : 20 })),
    );
    add(
      store,
      straight(4, 8, (i) => ({ line: i <= 5 ? 50 : 20 })),
      1,
    );
    expect(store.ranges_of(0, 50)).toEqual([
      { chunk: 0, first: 2, last: 4 },
      { chunk: 1, first: 0, last: 1 },
    ]);
  });
  it('of another file are other lines', () => {
    const store = new PathStore();
    add(
      store,
      straight(0, 4, (i) => ({ line: 7, file: i === 2 ? 1 : 0 })),
    );
    expect(store.ranges_of(1, 7)).toEqual([{ chunk: 0, first: 1, last: 2 }]);
  });
});

describe('a motion under way', () => {
  it('is found by its number, and the tool by its foot on it', () => {
    const store = new PathStore();
    add(
      store,
      straight(0, 6, (i) => ({ motion: i <= 2 ? 1 : 2 })),
    );
    const place = store.place_of_motion(2, [4.5, 0.2, 0]);
    expect(place).toEqual({ chunk: 0, vertex: 4, fraction: 0.5 });
    expect(store.seconds_at(place!)).toBeCloseTo((store.time_of(0, 4) + store.time_of(0, 5)) / 2);
  });
  it('that draws nothing stands where the one before it ended', () => {
    const store = new PathStore();
    add(
      store,
      straight(0, 4, (i) => ({ motion: i <= 2 ? 1 : 9 })),
    );
    expect(store.place_of_motion(5, [0, 0, 0])).toEqual({ chunk: 0, vertex: 2, fraction: 0 });
  });
});

describe('the store', () => {
  it('begins anew with a newer run and leaves chunks of an older one out', () => {
    const store = two_chunks();
    expect(add(store, straight(0, 2), 0, 5)).toBe(true);
    expect(store.facts.segments).toBe(2);
    expect(add(store, straight(0, 4), 1, 4)).toBe(false);
    expect(store.facts.segments).toBe(2);
  });
  it('cuts chunks into blocks that share their border vertex and have the box around them', () => {
    const store = new PathStore();
    add(store, straight(0, BLOCK + 10));
    expect(store.blocks.map(({ first, last }) => [first, last])).toEqual([
      [0, BLOCK],
      [BLOCK, BLOCK + 10],
    ]);
    expect(store.blocks[1].box).toEqual({ min: [BLOCK, 0, 0], max: [BLOCK + 10, 0, 0] });
  });
  it('knows what was cut, how fast, and with which tools', () => {
    const store = new PathStore();
    add(store, [
      { xyz: [-50, 0, 9], time_s: 0, kind: 0, tool: 9 },
      { xyz: [0, 0, 9], time_s: 1, kind: 0, tool: 9 },
      { xyz: [0, 0, -2], time_s: 2, tool: 3, feed: 100, speed: 90 },
      { xyz: [5, 4, -2], time_s: 3, tool: 1, feed: 600, speed: 580, power: 10 },
    ]);
    expect(store.facts.cuts).toEqual({ min: [0, 0, -2], max: [5, 4, 9] });
    expect(store.facts.bounds.min[0]).toBe(-50);
    expect(store.facts).toMatchObject({
      feed: [100, 600],
      speed: [90, 580],
      tools: [1, 3],
      end_s: -50 + 3,
    });
  });
});

describe('last_not_above', () => {
  it('agrees with looking at every value', () => {
    const values = Float32Array.from([0, 0, 1, 2, 2, 2, 5]);
    for (let limit = -1; limit <= 6; limit += 0.5) {
      expect(last_not_above(values, limit)).toBe(values.filter((v) => v <= limit).length - 1);
    }
  });
});
