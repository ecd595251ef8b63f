import { describe, expect, it } from 'vitest';
import type { Box } from '../src/logic/box';
import { empty_box } from '../src/logic/box';
import { fit_box, is_path } from '../src/logic/fit_box';
import type { Point } from '../src/logic/kinematics';

const cuts: Box = { min: [0, 0, -5], max: [50, 30, 0] };
const bounds: Box = { min: [-20, 0, -5], max: [50, 30, 100] };

const all = { rapids: true, tip: null, least_cuts: 0 };

describe('the picture is fitted to', () => {
  it('cuts and rapids', () => {
    expect(fit_box(cuts, bounds, all)).toEqual(bounds);
  });
  it('cuts alone where rapids are hidden, unless there is nothing else', () => {
    expect(fit_box(cuts, bounds, { ...all, rapids: false })).toEqual(cuts);
    expect(fit_box(empty_box(), bounds, { ...all, rapids: false })).toEqual(bounds);
  });
  it('the tool as well', () => {
    expect(fit_box(cuts, cuts, { ...all, tip: [-10, 40, 60] })).toEqual({
      min: [-10, 0, -5],
      max: [50, 40, 60],
    });
  });
  it('nothing so far off that the cuts become small', () => {
    const least_cuts = 0.4;
    expect(fit_box(cuts, bounds, { ...all, least_cuts })).toEqual(bounds);
    const tip: Point = [0, 0, 400];
    expect(fit_box(cuts, bounds, { ...all, tip, least_cuts })).toEqual(bounds);
    expect(fit_box(cuts, bounds, { ...all, least_cuts: 0.8 })).toEqual(cuts);
  });
  it('no path of one place', () => {
    expect(is_path({ min: [1, 0, 0], max: [1, 0, 0] })).toBe(false);
    expect(is_path(empty_box())).toBe(false);
    expect(is_path(cuts)).toBe(true);
  });
});
