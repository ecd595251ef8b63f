/**
 * How open the sky is over a place of a height field, nearly: a place far below the mean height around it is a pocket and lies in
 * shade. Of the mean heights there are two, of a wide neighbourhood and of a near one, as a small picture of the part: 0 is the
 * bottom and 255 the top.
 */
import { type HeightField, VOID } from './height_field';

export const AMBIENT_SIZE = 160;
const WIDE = { radius: 7, rounds: 3 };
const NEAR = { radius: 2, rounds: 2 };

/** Two numbers a place: the wide mean, the near one. */
export function mean_heights(field: HeightField): Uint8Array<ArrayBuffer> {
  const heights = samples(field);
  const wide = smoothed(heights, WIDE);
  const near = smoothed(heights, NEAR);
  const means = new Uint8Array(2 * heights.length);
  for (let k = 0; k < heights.length; k++) {
    means[2 * k] = Math.round(255 * within(wide[k]));
    means[2 * k + 1] = Math.round(255 * within(near[k]));
  }
  return means;
}

const within = (share: number): number => Math.min(1, Math.max(0, share));

function smoothed(heights: Float32Array, { radius, rounds }: typeof WIDE): Float32Array {
  let values = heights;
  for (let round = 0; round < rounds; round++)
    values = blurred(blurred(values, 1, AMBIENT_SIZE, radius), AMBIENT_SIZE, 1, radius);
  return values;
}

/** Heights at places of the small picture: 0 the bottom, 1 the top. */
function samples({ grid, heights }: HeightField): Float32Array<ArrayBuffer> {
  const n = AMBIENT_SIZE;
  const { nx, ny, corner, top } = grid;
  const span = Math.max(1e-9, top - corner[2]);
  const at = (i: number, count: number): number => Math.floor(((i + 0.5) / n) * count);
  return Float32Array.from({ length: n * n }, (_, k) => {
    const height = heights[at(Math.floor(k / n), ny) * nx + at(k % n, nx)];
    return height === VOID ? 0 : (height - corner[2]) / span;
  });
}

/** The mean of 2 radius + 1 values along lines; beyond their ends they go on as there. */
function blurred(from: Float32Array, step: number, other: number, radius: number) {
  const n = AMBIENT_SIZE;
  const to = new Float32Array(n * n);
  for (let line = 0; line < n; line++) {
    const at = (i: number): number => from[line * other + Math.min(n - 1, Math.max(0, i)) * step];
    let sum = 0;
    for (let i = -radius; i <= radius; i++) sum += at(i);
    for (let i = 0; i < n; i++) {
      to[line * other + i * step] = sum / (2 * radius + 1);
      sum += at(i + radius + 1) - at(i - radius);
    }
  }
  return to;
}
