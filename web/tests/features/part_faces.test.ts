import { expect, it } from 'vitest';
import { elements_of } from '../../src/logic/features/elements';
import { faces_of } from '../../src/logic/features/part_faces';
import type { Preview } from '../../src/logic/features/preview';
import { p1, shaft } from './documents';

const [pocket] = p1.features;
const answer = {
  revision: 1,
  problem: null,
  contours: [],
  added: [
    {
      feature: 'F1',
      layer: 1,
      regions: [
        [
          [50, 10, 0],
          [54, 10, 0],
          [54, 38, 0],
          [50, 38, 0],
        ],
      ],
    },
  ],
  removed: [
    {
      feature: 'F1',
      layer: 2,
      regions: [
        [
          [10, 10, 0],
          [14, 10, 0],
          [14, 38, 0],
          [10, 38, 0],
        ],
      ],
    },
  ],
} as Preview;

it('the part is the stock from above with each layer, the deeper the darker, and holes', () => {
  const faces = faces_of(p1, { feature: pocket, answer: null, elements: [] }, false);
  expect(faces[0]).toEqual({ path: 'M2 0H125V73H2Z', depth: 0 });
  const layers = p1.features.flatMap(({ layers }) => layers.length).reduce((a, b) => a + b);
  expect(faces).toHaveLength(1 + layers + p1.holes.length);
  const [first, second] = faces.slice(1);
  expect([first.depth, second.depth]).toEqual([2 / 17, 4 / 17]);
  expect(faces.at(-1)!.depth).toBeCloseTo(12 / 17, 9);
});

it('behind the edits what is cut more has its depth, and what is no more cut that of the layer above', () => {
  const edited = { feature: pocket, answer, elements: [] };
  const before = faces_of(p1, edited, false);
  const after = faces_of(p1, edited, true);
  expect(after).toHaveLength(before.length + 2);
  const [added, left] = after.slice(3, 5);
  expect(added).toEqual({ path: 'M50 10L54 10L54 38L50 38L50 10Z', depth: 2 / 17 });
  expect(left).toEqual({ path: 'M10 10L14 10L14 38L10 38L10 10Z', depth: 2 / 17 });
  expect(faces_of(p1, { ...edited, answer: null }, true)).toEqual(before);
});

it('of a lathe the bar is told, and what is turned away along the contour as it is drawn', () => {
  const feature = shaft.features.find(({ type }) => type === 'turning')!;
  const elements = elements_of(feature.contour, false, true);
  const longer = elements.map((each) => ({
    ...each,
    from: [each.from[0] - 1, each.from[1]] as [number, number],
  }));
  const before = faces_of(shaft, { feature, answer: null, elements: longer }, false);
  const after = faces_of(shaft, { feature, answer: null, elements: longer }, true);
  expect(before[0].depth).toBe(0);
  expect(before.slice(1).every(({ depth }) => depth === null)).toBe(true);
  const different = before.filter(({ path }, i) => path !== after[i].path);
  expect(different).toHaveLength(1);
});
