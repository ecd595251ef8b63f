import { describe, expect, it } from 'vitest';
import { cutting_outline } from '../src/logic/stock/cutting_outline';
import {
  LATHE_TYPES,
  MILL_TYPES,
  type Point2,
  segments_of,
  tool_shape,
  type ToolTable,
  type_of,
} from '../src/logic/stock/tool_shape';
import { insert_of } from '../src/logic/stock/turning_shape';

const radius_at = (outline: Point2[], height: number): number => {
  for (let i = 1; i < outline.length; i++) {
    const [[r0, z0], [r1, z1]] = [outline[i - 1], outline[i]];
    if (z0 <= height && height <= z1 && z1 > z0)
      return r0 + ((height - z0) / (z1 - z0)) * (r1 - r0);
  }
  return NaN;
};
const outline = (tool: Omit<ToolTable, 'number'>): Point2[] =>
  cutting_outline(
    { number: 1, ...tool },
    type_of({ number: 1, ...tool }),
    Number(tool.diameter) / 2,
  );

describe('the outline of a tool', () => {
  it('of a ball is a circle', () => {
    for (const z of [0.4, 1.5, 2.9])
      expect(radius_at(outline({ type: 'ball', diameter: 6 }), z)).toBeCloseTo(
        Math.sqrt(6 * z - z * z),
        1,
      );
  });
  it('of a bull nose is R − c + √(2cζ − ζ²)', () => {
    const points = outline({ type: 'bull', diameter: 12, corner_radius: 2 });
    expect(radius_at(points, 1)).toBeCloseTo(4 + Math.sqrt(3), 1);
  });
  it('of a drill is a point of its angle', () => {
    const points = outline({ type: 'drill', diameter: 10 });
    expect(points[points.length - 1][1]).toBeCloseTo(5 / Math.tan((59 * Math.PI) / 180), 9);
  });
  it('of a cone begins at its flat, or touches its ball', () => {
    const flat = outline({ type: 'v', diameter: 6, angle: 60, tip_diameter: 0.2 });
    expect(radius_at(flat, 1)).toBeCloseTo(0.1 + Math.tan(Math.PI / 6), 9);
    const ball = outline({ type: 'engrave', diameter: 6, angle: 60, tip_radius: 0.5 });
    expect(radius_at(ball, 0.25)).toBeCloseTo(0.5 * Math.cos(Math.PI / 6), 2);
  });
  it('of a dovetail narrows upwards', () => {
    const points = outline({
      type: 'dovetail',
      diameter: 20,
      angle: 60,
      height: 5,
      neck_diameter: 8,
    });
    expect(radius_at(points, 5)).toBeCloseTo(10 - 5 / Math.tan(Math.PI / 3), 9);
  });

  it('has its shank on the flutes and its holder on the stickout', () => {
    const shape = tool_shape({
      number: 5,
      type: 'flat',
      diameter: 12,
      flute_length: 26,
      stickout: 45,
      shank: [{ height: 10, diameter: 10 }],
      holder: [
        { height: 25, lower: 30, upper: 40 },
        { height: 40, diameter: 63 },
      ],
    });
    expect(shape?.parts.map(({ kind }) => kind)).toEqual(['cutting', 'shank', 'shank', 'holder']);
    const [cutting, shank, between, holder] = shape!.parts.map(({ outline: o }) => o);
    expect(cutting[cutting.length - 1]).toEqual([6, 26]);
    expect(shank).toEqual([
      [5, 26],
      [5, 36],
    ]);
    expect(between).toEqual([
      [5, 36],
      [5, 45],
    ]);
    expect(holder).toEqual([
      [15, 45],
      [20, 70],
      [31.5, 70],
      [31.5, 110],
    ]);
  });
  it('may have a holder of a name', () => {
    const tool = { number: 1, type: 'flat', diameter: 6, stickout: 30, holder_name: 'ER32' };
    const holders = [{ name: 'ER32', segments: [{ height: 50, diameter: 63 }] }];
    expect(tool_shape(tool, holders)?.parts.at(-1)).toEqual({
      kind: 'holder',
      outline: [
        [31.5, 30],
        [31.5, 80],
      ],
    });
    expect(tool_shape(tool)?.parts.some(({ kind }) => kind === 'holder')).toBe(false);
  });
  it('of every type is drawn: radii that are none below zero, heights that do not fall', () => {
    for (const type of MILL_TYPES) {
      const profile = [
        [2, 0],
        [5, 4],
        [5, 9],
      ];
      const shape = tool_shape({
        number: 1,
        type,
        diameter: 10,
        corner_radius: 1,
        pilot_diameter: 3,
        pilot_length: 2,
        width: 3,
        neck_diameter: 5,
        angle: 60,
        height: 3,
        pitch: 1.5,
        flute_length: 20,
        profile,
      });
      expect(shape, type).not.toBeNull();
      for (const { outline: points } of shape!.parts)
        points.forEach(([r, z], i) => {
          expect(r, type).toBeGreaterThanOrEqual(0);
          if (i) expect(z - points[i - 1][1], type).toBeGreaterThan(-1e-9);
        });
    }
    for (const type of LATHE_TYPES)
      for (const tip of [1, 2, 3, 4, 8]) {
        const shape = tool_shape({ number: 1, type, tip, width: 3 });
        expect(shape?.turning).toBe(true);
        expect(
          shape!.parts.flatMap(({ outline: o }) => o.flat()).every(Number.isFinite),
          type,
        ).toBe(true);
      }
  });
  it('without a diameter is none', () =>
    expect(tool_shape({ number: 3, type: 'flat' })).toBeNull());
});

describe('an insert', () => {
  it('is read from its designation, and keys count more', () => {
    expect(insert_of({ number: 1, insert: 'CNMG120408' })).toEqual({
      shape: 'C',
      ic: 12.7,
      nose: 0.8,
    });
    expect(insert_of({ number: 1, insert: 'DNMG110404', nose_radius: 0.2 })).toEqual({
      shape: 'D',
      ic: 9.525,
      nose: 0.2,
    });
    expect(insert_of({ number: 1, insert: 'CNMG120400' }).nose).toBe(0);
  });
  it('has its nose at the imaginary tip: nothing lies beyond both axes, and both are touched', () => {
    const [, insert] = tool_shape({ number: 1, insert: 'CNMG120408' })!.parts;
    const z = insert.outline.map(([a]) => a);
    const r = insert.outline.map(([, b]) => b);
    expect(Math.min(...z)).toBeGreaterThan(-1.2); // κ 95°: the edge leans 5° over
    expect(Math.min(...r)).toBeCloseTo(0, 2);
    const near = insert.outline.filter(([a, b]) => Math.hypot(a - 0.8, b - 0.8) < 0.801);
    expect(near.length).toBeGreaterThan(8);
    expect(Math.min(...near.map(([a]) => a))).toBeCloseTo(0, 2);
  });
  it('of a type that nobody says is told by its keys', () => {
    expect(type_of({ number: 1, insert: 'CNMG120408' })).toBe('turning');
    expect(type_of({ number: 1, diameter: 6 })).toBe('flat');
    expect(type_of({ number: 1, type: 'nonsense' })).toBe('flat');
  });
  it('segments that say nothing are left out', () => {
    expect(
      segments_of([
        { height: 0, diameter: 5 },
        { height: 5 },
        'x',
        { height: 2, lower: 3, upper: 4 },
      ]),
    ).toEqual([{ height: 2, lower: 3, upper: 4 }]);
    expect(segments_of(undefined)).toEqual([]);
  });
});
