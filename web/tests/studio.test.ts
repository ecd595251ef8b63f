import { describe, expect, it } from 'vitest';
import { HeightField, VOID } from '../src/logic/stock/height_field';
import { AMBIENT_SIZE, mean_heights } from '../src/logic/stock/ambient';
import { gleam_at, light_at } from '../src/picture/studio';

type Three = [number, number, number];
const unit = (x: number, y: number, z: number): Three => {
  const length = Math.hypot(x, y, z);
  return [x / length, y / length, z / length];
};
const brightness = (...normal: Three): number =>
  light_at(unit(...normal)).reduce((sum, part) => sum + part, 0) / 3;

describe('the light of the studio', () => {
  it('comes over the left shoulder, and leaves no side that is seen black', () => {
    expect(brightness(-0.6, 0.4, 0.6)).toBeGreaterThan(brightness(0, 0.6, 0.8));
    expect(brightness(-0.7, -0.4, 0.6)).toBeGreaterThan(1.5 * brightness(0.7, -0.4, 0.6));
    for (let k = 0; k < 64; k++) {
      const [x, y] = [Math.cos(k / 10), Math.sin(k / 10)];
      expect(brightness(x, y, 0.05)).toBeGreaterThan(0.1);
    }
  });
  it('never makes a matt place much brighter than white', () => {
    for (let x = -1; x <= 1; x += 0.1)
      for (let y = -1; y <= 1; y += 0.1)
        if (x * x + y * y < 1)
          expect(Math.max(...light_at(unit(x, y, Math.sqrt(1 - x * x - y * y))))).toBeLessThan(
            1.25,
          );
  });
  it('gleams in the lamps, and not in a place that faces who looks', () => {
    expect(gleam_at([0, 0, 1])).toBeLessThan(0.01);
    expect(gleam_at(unit(-0.3, 0.27, 0.9))).toBeGreaterThan(0.3);
  });
});

describe('mean heights', () => {
  const grid = { nx: 200, ny: 200, cell: [1, 1], corner: [0, 0, -10], top: 0 } as const;
  const at = (means: Uint8Array, x: number, y: number): [wide: number, near: number] => {
    const k =
      Math.floor((y / 200) * AMBIENT_SIZE) * AMBIENT_SIZE + Math.floor((x / 200) * AMBIENT_SIZE);
    return [means[2 * k], means[2 * k + 1]];
  };
  it('are those of the part where it is flat', () => {
    const field = new HeightField({ ...grid, cell: [1, 1], corner: [0, 0, -10] });
    expect(mean_heights(field).every((mean) => mean === 255)).toBe(true);
    expect(mean_heights(new HeightField({ ...field.grid, top: 0 })).length).toBe(
      2 * AMBIENT_SIZE * AMBIENT_SIZE,
    );
  });
  it('see a hole from near before they see it from afar', () => {
    const field = new HeightField({ ...grid, cell: [1, 1], corner: [0, 0, -10] });
    for (let j = 90; j < 110; j++) for (let i = 90; i < 110; i++) field.heights[j * 200 + i] = VOID;
    const [wide, near] = at(mean_heights(field), 100, 100);
    expect(near).toBeLessThan(60);
    expect(wide).toBeGreaterThan(near);
    expect(at(mean_heights(field), 20, 20)).toEqual([255, 255]);
  });
});
