import { describe, expect, it } from 'vitest';
import { hit_of_field } from '../src/logic/stock/field_ray';
import { HeightField, VOID } from '../src/logic/stock/height_field';
import { measure, type Place } from '../src/logic/stock/measure';
import { random } from './random';

describe('a measure', () => {
  it('between two places is their distance, with its parts along the axes', () => {
    expect(
      measure('distance', [
        [1, 2, 3],
        [4, 6, 15],
      ]),
    ).toMatchObject({
      value: 13,
      along: [3, 4, 12],
    });
    expect(measure('distance', [[1, 2, 3]])).toBeNull();
  });
  it('of a depth counts along the axis alone', () => {
    const found = measure('depth', [
      [0, 0, -1],
      [7, 8, -6.5],
    ]);
    expect(found?.value).toBe(5.5);
    expect(found?.line).toEqual([
      [0, 0, -1],
      [0, 0, -6.5],
      [7, 8, -6.5],
    ]);
  });
  it('of a diameter is that of the circle through three places, whatever their heights', () => {
    const next = random(5);
    for (let round = 0; round < 200; round++) {
      const [cx, cy, r] = [100 * next() - 50, 100 * next() - 50, 0.1 + 40 * next()];
      const first = 7 * next();
      const places = [0, 1.1 + next(), 3 + next()].map((turn): Place => [
        cx + r * Math.cos(first + turn),
        cy + r * Math.sin(first + turn),
        -10 * next(),
      ]);
      const found = measure('diameter', places);
      expect(found!.value).toBeCloseTo(2 * r, 6);
      expect(found!.centre![0]).toBeCloseTo(cx, 6);
      expect(found!.centre![1]).toBeCloseTo(cy, 6);
    }
  });
  it('of a diameter may lie about another axis, and three places on a line have none', () => {
    expect(
      measure(
        'diameter',
        [
          [9, 5, 0],
          [3, 0, 5],
          [1, -5, 0],
        ],
        0,
      )?.value,
    ).toBeCloseTo(10, 9);
    expect(
      measure('diameter', [
        [0, 0, 0],
        [1, 1, 0],
        [3, 3, 5],
      ]),
    ).toBeNull();
    expect(
      measure('diameter', [
        [2, 2, 0],
        [2, 2, 0],
        [2, 2, 0],
      ]),
    ).toBeNull();
  });
});

describe('a line of sight on a height field', () => {
  const field = new HeightField({ nx: 40, ny: 30, cell: [0.5, 0.5], corner: [-5, 0, -8], top: 0 });
  for (let j = 0; j < 30; j++)
    for (let i = 0; i < 40; i++)
      field.heights[j * 40 + i] = i > 9 && i < 20 && j > 9 ? (j > 20 ? VOID : -5) : 0;
  const down = Math.SQRT1_2;

  it('from above meets top, floor, and nothing where nothing is left', () => {
    expect(hit_of_field(field, [-3, 2, 50], [0, 0, -1])).toMatchObject({
      at: [-3, 2, 0],
      normal: [0, 0, 1],
    });
    expect(hit_of_field(field, [2, 8, 50], [0, 0, -1])?.at[2]).toBe(-5);
    expect(hit_of_field(field, [2, 12, 50], [0, 0, -1])).toBeNull();
    expect(hit_of_field(field, [99, 2, 50], [0, 0, -1])).toBeNull();
  });
  it('aslant meets the side of a pocket, with the normal of that side', () => {
    const hit = hit_of_field(
      field,
      [2, 7, 50],
      [down, 0, -down].map((v, i) => (i ? v : -v)) as Place,
    );
    expect(hit).toBeNull(); // it has passed the part
    const wall = hit_of_field(field, [3, 7, 1], [down, 0, -down]);
    expect(wall).toMatchObject({ normal: [-1, 0, 0] });
    expect(wall!.at[0]).toBeCloseTo(5, 9);
    expect(wall!.at[2]).toBeCloseTo(-1, 9);
  });
  it('from outside meets the side of the part, from below its bottom', () => {
    expect(hit_of_field(field, [-20, 2, -4], [1, 0, 0])).toMatchObject({
      at: [-5, 2, -4],
      normal: [-1, 0, 0],
    });
    expect(hit_of_field(field, [-3, 2, -50], [0, 0, 1])).toMatchObject({
      at: [-3, 2, -8],
      normal: [0, 0, -1],
    });
  });
  it('passes what lies beyond a section, and meets the cut face', () => {
    const plane = { normal: [0, -1, 0] as Place, at: -5 }; // what lies before Y5 is away
    const hit = hit_of_field(field, [-3, -20, -4], [0, 1, 0], plane);
    expect(hit).toMatchObject({ at: [-3, 5, -4], normal: [0, -1, 0] });
    expect(hit_of_field(field, [-3, 2, 50], [0, 0, -1], plane)).toBeNull();
  });
  it('meets what a search in small steps finds', () => {
    const next = random(9);
    for (let round = 0; round < 120; round++) {
      const from: Place = [30 * next() - 10, 25 * next() - 5, 5 + 5 * next()];
      const raw = [next() - 0.5, next() - 0.5, -next() - 0.05];
      const length = Math.hypot(...raw);
      const way = raw.map((v) => v / length) as Place;
      const hit = hit_of_field(field, from, way);
      let found: number | null = null;
      for (let t = 0; t < 60 && found === null; t += 0.005) {
        const [x, y, z] = from.map((v, i) => v + t * way[i]);
        const height = field.height_at(x, y);
        if (height !== null && z <= height && z >= -8) found = t;
      }
      const t = hit ? (hit.at[2] - from[2]) / way[2] : null;
      if (found === null || t === null) expect(t === null || Math.abs(t) > 59).toBe(found === null);
      else expect(Math.abs(t - found)).toBeLessThan(0.01);
    }
  });
});
