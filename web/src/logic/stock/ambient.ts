/**
 * How open the sky is over a place of a height field, nearly: a place far below the mean height around it is a pocket and lies in
 * shade. The mean heights are a small picture of the part, 0 the bottom and 255 the top.
 */
import { type HeightField, VOID } from './height_field';

export const AMBIENT_SIZE = 96;
const BLUR_ROUNDS = 3;

export function mean_heights({ grid, heights }: HeightField): Uint8Array<ArrayBuffer> {
  const n = AMBIENT_SIZE;
  const { nx, ny, corner, top } = grid;
  const span = Math.max(1e-9, top - corner[2]);
  let values = new Float32Array(n * n);
  for (let j = 0; j < n; j++) {
    const row = Math.floor(((j + 0.5) / n) * ny) * nx;
    for (let i = 0; i < n; i++) {
      const height = heights[row + Math.floor(((i + 0.5) / n) * nx)];
      values[j * n + i] = height === VOID ? 0 : (height - corner[2]) / span;
    }
  }
  const radius = 4;
  for (let round = 0; round < BLUR_ROUNDS; round++)
    values = blurred(blurred(values, 1, n, radius), n, 1, radius);
  return Uint8Array.from(values, (value) => Math.round(255 * Math.min(1, Math.max(0, value))));
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
