/**
 * How open the sky is over a place of a height field, nearly: a place far below the mean height around it is a pocket and lies in
 * shade. The mean heights are a small picture of the part, 0 the bottom and 255 the top.
 */
import { type HeightField, VOID } from './height_field';

export const AMBIENT_SIZE = 96;
const BLUR_ROUNDS = 3;
const RADIUS = 4;

export function mean_heights(field: HeightField): Uint8Array<ArrayBuffer> {
  const n = AMBIENT_SIZE;
  let values = samples(field);
  for (let round = 0; round < BLUR_ROUNDS; round++)
    values = blurred(blurred(values, 1, n, RADIUS), n, 1, RADIUS);
  return Uint8Array.from(values, (value) => Math.round(255 * Math.min(1, Math.max(0, value))));
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
