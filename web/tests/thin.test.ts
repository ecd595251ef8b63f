import { describe, expect, it } from 'vitest';
import { decode_chunk } from '../src/logic/chunk';
import { PathStore } from '../src/logic/path_store';
import { thinned } from '../src/logic/thin';
import { type VertexOfTest, chunk_bytes } from './chunk_bytes';
import { random } from './random';

function block_of(vertices: VertexOfTest[]) {
  const store = new PathStore();
  store.add(decode_chunk(chunk_bytes({ vertices })));
  return store.blocks[0];
}

/** Distance of a point from a segment, by a hundred points along it and none of the code under test. */
function distance(p: number[], a: number[], b: number[]): number {
  let nearest = Infinity;
  for (let i = 0; i <= 100; i++) {
    const along = a.map((value, k) => value + (i / 100) * (b[k] - value));
    nearest = Math.min(nearest, Math.hypot(...along.map((value, k) => value - p[k])));
  }
  return nearest;
}

describe('a thinned path', () => {
  it.each([1, 2, 3, 4, 5])('leaves the path by at most the tolerance (seed %i)', (seed) => {
    const next = random(seed);
    let [x, y, z] = [0, 0, 0];
    const vertices: VertexOfTest[] = Array.from({ length: 600 }, () => {
      const step = next() < 0.05 ? 20 : 0.2;
      [x, y, z] = [x + step * (next() - 0.4), y + step * (next() - 0.5), z + 0.1 * (next() - 0.5)];
      return { xyz: [x, y, z] };
    });
    const block = block_of(vertices);
    const tolerance = 0.5;
    const kept = thinned(block, tolerance);
    expect(kept.length).toBeLessThan(500);
    const at = (i: number) => [...block.chunk.xyz.subarray(3 * i, 3 * i + 3)];
    for (let k = 1; k < kept.length; k++) {
      for (let i = kept[k - 1]; i <= kept[k]; i++) {
        // A hundredth of the segment is what looking at a hundred points may miss.
        const slack = 0.01 * Math.hypot(...at(kept[k]).map((v, axis) => v - at(kept[k - 1])[axis]));
        expect(distance(at(i), at(kept[k - 1]), at(kept[k]))).toBeLessThanOrEqual(
          tolerance + slack,
        );
      }
    }
  });

  it('keeps its ends and every change of kind, tool and power', () => {
    const kinds = [0, 0, 1, 1, 1, 1, 1, 1];
    const vertices = kinds.map((kind, i): VertexOfTest => ({
      xyz: [0.001 * i, 0, 0],
      kind,
      tool: i < 5 ? 1 : 2,
      power: i < 7 ? 10 : 20,
    }));
    expect([...thinned(block_of(vertices), 1)]).toEqual([0, 1, 4, 6, 7]);
  });
});
