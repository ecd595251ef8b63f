import { describe, expect, it } from 'vitest';
import {
  contrast,
  hex,
  luminance,
  rapid_colour,
  scale_colour,
  ticks,
  tool_colour,
} from '../src/logic/colour_scale';

const GROUND = { dark: hex('#1b232c'), light: hex('#dde5ec') };

describe.each(['dark', 'light'] as const)('colours on %s', (scheme) => {
  it('of the scale rise or fall in lightness all the way, so that they read in grey', () => {
    const shades = Array.from({ length: 41 }, (_, i) => luminance(scale_colour(i / 40, scheme)));
    const sign = scheme === 'dark' ? 1 : -1;
    for (let i = 1; i < shades.length; i++)
      expect(sign * (shades[i] - shades[i - 1])).toBeGreaterThan(0);
  });
  it('of tools and rapids stand out from the ground', () => {
    for (let tool = 1; tool <= 8; tool++)
      expect(contrast(tool_colour(tool, scheme), GROUND[scheme])).toBeGreaterThan(3);
    expect(contrast(rapid_colour(scheme), GROUND[scheme])).toBeGreaterThan(3);
  });
});

it('a scale ends at its ends', () => {
  expect(scale_colour(-1, 'dark')).toEqual(scale_colour(0, 'dark'));
  expect(scale_colour(7, 'dark')).toEqual(scale_colour(1, 'dark'));
});

describe('ticks', () => {
  it('are round, within the scale and not more than asked for', () => {
    expect(ticks(0, 100, 5)).toEqual([0, 25, 50, 75, 100]);
    expect(ticks(130, 2870, 5)).toEqual([1000, 2000]);
    for (const [low, high] of [
      [0.3, 0.9],
      [7, 13000],
      [-5, 5],
    ]) {
      const values = ticks(low, high, 6);
      expect(values.length).toBeLessThanOrEqual(6);
      for (const value of values) expect(value >= low && value <= high + 1e-9).toBe(true);
    }
  });
  it('of a scale without extent are its one value', () => {
    expect(ticks(5, 5, 5)).toEqual([5]);
  });
});
