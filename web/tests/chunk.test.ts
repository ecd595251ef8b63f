import { describe, expect, it } from 'vitest';
import { BadChunk, decode_chunk } from '../src/logic/chunk';
import { chunk_bytes } from './chunk_bytes';

const three = chunk_bytes({
  run: 7,
  chunk: 2,
  first_motion: 40,
  time_base_s: 12.5,
  vertices: [
    { xyz: [1, 2, 3], time_s: 0, motion: 39, line: 8, kind: 0 },
    {
      xyz: [4, 5, 6],
      time_s: 0.25,
      feed: 500,
      speed: 480,
      motion: 40,
      line: 70_000,
      file: 513,
      tool: 12,
      power: 80,
    },
    { xyz: [7, 8, -9.5], time_s: 0.5, motion: 41, line: 10, kind: 4 },
  ],
});

describe('a chunk', () => {
  it('is read array by array, across the padding of odd counts', () => {
    const chunk = decode_chunk(three);
    expect(chunk).toMatchObject({
      source: 'preview',
      run: 7,
      chunk: 2,
      first_motion: 40,
      vertices: 3,
      time_base_s: 12.5,
    });
    expect([...chunk.xyz]).toEqual([1, 2, 3, 4, 5, 6, 7, 8, -9.5]);
    expect([...chunk.time_s]).toEqual([0, 0.25, 0.5]);
    expect([...chunk.feed_mm_min]).toEqual([0, 500, 0]);
    expect([...chunk.speed_mm_min]).toEqual([0, 480, 0]);
    expect([...chunk.motion]).toEqual([39, 40, 41]);
    expect([...chunk.line]).toEqual([8, 70_000, 10]);
    expect([...chunk.file]).toEqual([0, 513, 0]);
    expect([...chunk.kind]).toEqual([0, 1, 4]);
    expect([...chunk.tool]).toEqual([0, 12, 0]);
    expect([...chunk.power_percent]).toEqual([0, 80, 0]);
    expect(chunk.rotary).toBeNull();
  });

  it('has two angles a vertex where the flag says so', () => {
    const bytes = chunk_bytes({
      vertices: [
        { xyz: [0, 0, 0], rotary: [10, 20] },
        { xyz: [1, 0, 0], rotary: [30, 450] },
      ],
    });
    expect([...(decode_chunk(bytes).rotary ?? [])]).toEqual([10, 20, 30, 450]);
  });

  it.each([
    ['shorter than a header', three.slice(0, 20)],
    ['cut off in its arrays', three.slice(0, three.byteLength - 4)],
  ])('that is %s is refused', (_, bytes) => {
    expect(() => decode_chunk(bytes)).toThrow(BadChunk);
  });

  it('of another version or of something else is refused', () => {
    const other = three.slice(0);
    new DataView(other).setUint16(4, 2, true);
    expect(() => decode_chunk(other)).toThrow('version 2');
    new DataView(other).setUint8(0, 'X'.charCodeAt(0));
    expect(() => decode_chunk(other)).toThrow('XPTH');
  });
});
