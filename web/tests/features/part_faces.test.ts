import { expect, it } from 'vitest';
import type { ToldVertex } from '../../src/logic/features/document';
import { elements_of } from '../../src/logic/features/elements';
import { faces_of } from '../../src/logic/features/part_faces';
import type { Preview } from '../../src/logic/features/preview';
import { p1, shaft } from './documents';

const [pocket] = p1.features;
const nothing = { revision: 1, problem: null, contours: [] };
const region: ToldVertex[] = [
  [50, 10, 0],
  [54, 10, 0],
  [54, 38, 0],
  [50, 38, 0],
];

it('the part is the stock from above with each layer, the deeper the darker, and holes', () => {
  const faces = faces_of(p1, { feature: pocket, answer: null, elements: [] }, false);
  expect(faces[0]).toEqual({ path: 'M2 0H125V73H2Z', depth: 0 });
  const layers = p1.features.flatMap(({ layers }) => layers.length).reduce((a, b) => a + b);
  expect(faces).toHaveLength(1 + layers + p1.holes.length);
  const [first, second] = faces.slice(1);
  expect([first.depth, second.depth]).toEqual([2 / 17, 4 / 17]);
  expect(faces.at(-1)!.depth).toBeCloseTo(12 / 17, 9);
});

it('behind the edits a pocket has its new contour, and stands where no tool reaches', () => {
  const [from, to] = [
    [10, 10],
    [54, 10],
  ] as [[number, number], [number, number]];
  const contour = { feature: 'F1', layer: 2, island: null, closed: true };
  const corner = { feature: 'F1', layer: 2, regions: [region] };
  const answer = {
    ...nothing,
    contours: [{ ...contour, elements: [{ id: 0, from, to, bulge: 0 }] }],
    rest: [corner],
  } as Preview;
  const edited = { feature: pocket, answer, elements: [] };
  const before = faces_of(p1, edited, false);
  const after = faces_of(p1, edited, true);
  expect(after).toHaveLength(before.length + 1);
  expect(after[1]).toEqual(before[1]);
  expect(after[2]).toEqual({ path: 'M10 10L54 10Z', depth: 4 / 17 });
  // As high as layer 1 has left it.
  expect(after[3]).toEqual({ path: 'M50 10L54 10L54 38L50 38L50 10Z', depth: 2 / 17 });
});

it('what stays is the contour of a profile: there what is cut more and less is told', () => {
  const profile = p1.features[1];
  const regions = [{ feature: 'F2', layer: 1, regions: [region] }];
  const more = {
    feature: profile,
    answer: { ...nothing, added: regions } as Preview,
    elements: [],
  };
  const less = {
    feature: profile,
    answer: { ...nothing, removed: regions } as Preview,
    elements: [],
  };
  const path = 'M50 10L54 10L54 38L50 38L50 10Z';
  expect(faces_of(p1, more, true)).toContainEqual({ path, depth: 6 / 17 });
  expect(faces_of(p1, less, true)).toContainEqual({ path, depth: 0 });
  expect(faces_of(p1, { ...more, answer: null }, true)).toEqual(faces_of(p1, more, false));
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
