import { expect, it } from 'vitest';
import { elements_of, midpoint, type Point } from '../../src/logic/features/elements';
import { calculated } from '../../src/logic/features/expression';
import {
  extents_of,
  fitted,
  in_plane,
  on_screen,
  pinched,
  zoomed,
} from '../../src/logic/features/frame';
import { grid_of, SNAP_KINDS, snapped, snapped_edge } from '../../src/logic/features/snap';
import { path_of, path_of_told } from '../../src/logic/features/svg_path';
import { random } from '../random';
import { p1 } from './documents';

const pocket = elements_of(p1.features[0].nominal!, true);
const scene = { still: pocket, original: pocket, anchors: [[50, 10] as Point], grid_mm: 0.5 };
const all = new Set(SNAP_KINDS);

it('numbers are calculated as they are typed', () => {
  const values: [string, number | undefined][] = [
    ['60/2', 30],
    ['2*(10+5)', 30],
    ['12,5', 12.5],
    ['\u22123', -3],
    ['.5', 0.5],
    ['10-2-3', 5],
    ['8/2/2', 2],
    ['-(1+2)*-2', 6],
    [' 1 + 1 ', 2],
    ['', undefined],
    ['1/0', undefined],
    ['2*', undefined],
    ['(2', undefined],
    ['2)', undefined],
    ['2x', undefined],
    ['1 2', 12],
    [`${'('.repeat(90)}1`, undefined],
  ];
  for (const [text, value] of values) expect(calculated(text), text).toBe(value);
});

it('a place of the screen and one of the plane are the same, whatever the window', () => {
  const next = random(3);
  for (let round = 0; round < 100; round++) {
    const frame = { scale: 0.1 + 40 * next(), origin: [500 * next(), 500 * next()] as Point };
    const place: Point = [100 * next(), -100 * next()];
    const back = in_plane(frame, on_screen(frame, place));
    back.forEach((value, i) => expect(value).toBeCloseTo(place[i], 9));
    const about: Point = [70, 90];
    const there = in_plane(frame, about);
    const after = in_plane(zoomed(frame, about, 1 + next()), about);
    after.forEach((value, i) => expect(value).toBeCloseTo(there[i], 9));
  }
});

it('all of a contour is seen in the middle, arcs with what they bulge', () => {
  const round = elements_of(p1.features[2].nominal!, true);
  expect(extents_of(round)).toEqual({ low: [54, 52], high: [70, 68] });
  const frame = fitted({ low: [54, 52], high: [70, 68] }, 400, 200);
  expect(on_screen(frame, [62, 60])).toEqual([200, 100]);
  expect(frame.scale).toBeCloseTo(9.5, 9);
  expect(extents_of([])).toBeNull();
});

it('two fingers that go apart make it larger, and what was between them stays between them', () => {
  const frame = { scale: 2, origin: [0, 0] as Point };
  const before: [Point, Point] = [
    [100, 100],
    [200, 100],
  ];
  const now: [Point, Point] = [
    [60, 120],
    [260, 120],
  ];
  const after = pinched(frame, before, now);
  expect(after.scale).toBe(4);
  expect(in_plane(after, [160, 120])).toEqual(in_plane(frame, [150, 100]));
});

it('a place is drawn to an end before a middle before a ray, and to the grid where nothing is near', () => {
  expect(snapped([50.2, 37.9], scene, all, 0.5)).toEqual({ at: [50, 38], kind: 'end' });
  expect(snapped([30.1, 10.2], scene, all, 0.5)).toMatchObject({ at: [30, 10], kind: 'middle' });
  expect(snapped([70, 30.1], scene, all, 0.5).kind).toBe('angle');
  expect(snapped([61.3, 27.6], scene, all, 0.05)).toEqual({ at: [61.5, 27.5], kind: 'grid' });
  expect(snapped([61.3, 27.6], scene, new Set(), 9)).toEqual({ at: [61.3, 27.6], kind: null });
});

it('an edge that is dragged comes to be in line with another, or to a round coordinate', () => {
  const kinds = new Set(['grid', 'end'] as const);
  const other = elements_of(
    [
      [57.25, 0, 0],
      [80, 0, 0],
    ],
    false,
  );
  const with_other = { ...scene, still: other };
  expect(snapped_edge(pocket[1], -7.2, with_other, kinds, 0.2)).toEqual({ by: -7.25, kind: 'end' });
  expect(snapped_edge(pocket[1], -1.8, with_other, kinds, 0.2)).toEqual({ by: -2, kind: 'grid' });
  expect(snapped_edge(pocket[1], -1.8, with_other, new Set(), 0.2)).toEqual({
    by: -1.8,
    kind: null,
  });
});

it('the grid is a round number of some ten pixels', () => {
  expect([0.01, 0.06, 0.1, 0.2, 1].map(grid_of)).toEqual([0.1, 0.5, 1, 2, 10]);
});

it('paths have arcs, the large way and the sense, and gaps where elements do not meet', () => {
  expect(path_of(pocket, true)).toBe('M10 10L50 10L50 38L10 38L10 10Z');
  expect(path_of_told([p1.features[2].nominal!], true)).toBe(
    'M54 60A8 8 0 0 1 70 60A8 8 0 0 1 54 60Z',
  );
  const gap = [pocket[0], pocket[2]];
  expect(path_of(gap, false)).toBe('M10 10L50 10M50 38L10 38');
  const large = elements_of(
    [
      [0, 0, 2],
      [10, 0, 0],
    ],
    false,
  );
  expect(path_of(large, false)).toBe('M0 0A6.25 6.25 0 1 1 10 0');
  expect(midpoint(large[0])).toEqual([5, -10]);
});
