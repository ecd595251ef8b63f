import { describe, expect, it } from 'vitest';
import { contrast, hex, thread_colour, tool_colour } from '../src/logic/colour_scale';
import { counted, letter_of, way_of } from '../src/logic/diameters';
import type { AxisDefinition } from '../src/logic/protocol';
import { with_added } from '../src/logic/offsets';
import {
  type Flat,
  empty_offset,
  insert_shape,
  nose_of,
  parts_of,
  tip_way,
} from '../src/logic/turning_offsets';

const axis = (name: string, diameter: boolean): AxisDefinition => ({
  name,
  rotary: false,
  diameter,
  min: -20,
  max: 400,
  unit: 'mm',
  program: true,
});

it('an axis of diameters shows twice its way, and says so', () => {
  const [x, z] = [axis('X', true), axis('Z', false)];
  expect([counted(x, 30), counted(z, 30), counted(undefined, 30)]).toEqual([60, 30, 30]);
  expect([way_of(x, 400), way_of(z, 300)]).toEqual([200, 300]);
  expect([letter_of(x), letter_of(z)]).toEqual(['XØ', 'Z']);
});

it('only a lathe with Y has offsets of it', () => {
  expect(parts_of(['X', 'Z'])).toEqual([
    'geometry_x',
    'geometry_z',
    'geometry_radius',
    'wear_x',
    'wear_z',
    'wear_radius',
    'tip',
  ]);
  expect(parts_of(['X', 'Z', 'Y'])).toHaveLength(9);
});

it('rows that were added are empty, and stand by their number', () => {
  const five = { ...empty_offset(5), tip: 3 };
  const rows = with_added([five], [12, 5, 1], empty_offset);
  expect(rows.map(({ number }) => number)).toEqual([1, 5, 12]);
  expect(rows[1]).toBe(five);
  expect(rows[2].wear_x).toBe(0);
});

it('a nose is its geometry and wear together; no offset has none', () => {
  const row = { ...empty_offset(3), geometry_radius: 0.8, wear_radius: -0.05, tip: 3 };
  expect(nose_of(row)).toEqual({ tip: 3, radius_mm: 0.75 });
  expect(nose_of(undefined)).toEqual({ tip: 0, radius_mm: 0 });
});

const far_from = (a: Flat, b: Flat): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

describe.each([1, 2, 3, 4, 5, 6, 7, 8])('an insert with the tip %i', (tip) => {
  const radius = 0.8;
  const { outline, centre, inwards } = insert_shape({ tip, radius_mm: radius }, 12);
  const [z, x] = tip_way(tip);

  it('has its nose touch the lines along Z and X through the imaginary tip', () => {
    expect(Math.abs(centre[0])).toBeCloseTo(Math.abs(z) * radius, 12);
    expect(Math.abs(centre[1])).toBeCloseTo(Math.abs(x) * radius, 12);
    // The tip is the origin: no point of the insert lies beyond it where the tip points to.
    for (const [along_z, along_x] of outline) {
      if (z !== 0) expect(z * along_z).toBeLessThan(1e-9);
      if (x !== 0) expect(x * along_x).toBeLessThan(1e-9);
    }
    const reach_z = Math.max(...outline.map(([along]) => z * along));
    const reach_x = Math.max(...outline.map(([, along]) => x * along));
    expect(Math.max(reach_z, reach_x)).toBeGreaterThan(-0.02 * radius);
  });
  it('lies behind its nose, with edges of one length that touch it', () => {
    expect(inwards[0] * z + inwards[1] * x).toBeLessThan(0);
    const [right, end, left] = outline.slice(-3);
    const nose = outline.slice(0, -3);
    for (const point of nose) expect(far_from(point, centre)).toBeCloseTo(radius, 9);
    expect(far_from(nose[nose.length - 1], right)).toBeCloseTo(12, 9);
    expect(far_from(nose[0], left)).toBeCloseTo(12, 9);
    expect(far_from(right, end)).toBeCloseTo(12, 9);
    // Square to the radius where it begins.
    const edge = [right[0] - nose[nose.length - 1][0], right[1] - nose[nose.length - 1][1]];
    const spoke = [nose[nose.length - 1][0] - centre[0], nose[nose.length - 1][1] - centre[1]];
    expect(edge[0] * spoke[0] + edge[1] * spoke[1]).toBeCloseTo(0, 9);
  });
});

it('an insert whose tip is the centre of its nose is round', () => {
  for (const tip of [0, 9]) {
    const { outline, centre } = insert_shape({ tip, radius_mm: 3 }, 12);
    expect(centre).toEqual([0, 0]);
    for (const point of outline) expect(far_from(point, centre)).toBeCloseTo(3, 9);
  }
  const { outline } = insert_shape({ tip: 0, radius_mm: 0 }, 12);
  expect(far_from(outline[0], [0, 0])).toBeCloseTo(6, 9);
});

it.each(['dark', 'light'] as const)(
  'threads stand out from the ground and are no tool (%s)',
  (scheme) => {
    const ground = { dark: hex('#1b232c'), light: hex('#dde5ec') }[scheme];
    expect(contrast(thread_colour(scheme), ground)).toBeGreaterThan(7);
    for (let tool = 1; tool <= 8; tool++) {
      const colour = tool_colour(tool, scheme);
      const apart = Math.hypot(...thread_colour(scheme).map((part, i) => part - colour[i]));
      expect(apart).toBeGreaterThan(0.35);
    }
  },
);
