import { describe, expect, it } from 'vitest';
import { decode_chunk } from '../src/logic/chunk';
import { PathStore } from '../src/logic/path_store';
import { pick } from '../src/logic/pick';
import { chunk_bytes } from './chunk_bytes';

/** From above: machine -50 … 50 mm is the 100 pixels of the screen, Y upwards, what is higher is in front. */
const FROM_ABOVE = [1 / 50, 0, 0, 0, 0, 1 / 50, 0, 0, 0, 0, -1 / 50, 0, 0, 0, 0, 1];
const aim = (x: number, y: number) => ({
  matrix: FROM_ABOVE,
  width: 100,
  height: 100,
  x,
  y,
  reach_px: 6,
});

const store = new PathStore();
store.add(
  decode_chunk(
    chunk_bytes({
      vertices: [
        { xyz: [-40, 0, 0] },
        { xyz: [40, 0, 0] },
        { xyz: [40, 30, 0] },
        { xyz: [40, 30, 5], kind: 2 },
        { xyz: [-40, 30, 5] },
        { xyz: [-40, 0, 5] },
        { xyz: [40, 0, 5] },
      ],
    }),
  ),
);

describe('the pointer', () => {
  it('finds the segment under it', () => {
    expect(pick(store, aim(88, 35))).toMatchObject({ chunk: 0, vertex: 2, distance_px: 2 });
  });
  it('finds the one in front where two lie over each other', () => {
    expect(pick(store, aim(50, 50))?.vertex).toBe(6);
  });
  it('finds nothing out of reach', () => {
    expect(pick(store, aim(50, 35))).toBeNull();
  });
});
