import { expect, it } from 'vitest';
import {
  angle_deg,
  type Element,
  elements_of,
  length,
  midpoint,
  type Point,
  radius,
} from '../../src/logic/features/elements';
import {
  applied,
  drag_of,
  edits_of,
  type Gesture,
  nudge,
  radius_through,
} from '../../src/logic/features/gestures';
import { p1, shaft } from './documents';

const pocket = elements_of(p1.features[0].nominal!, true);
const done = (elements: Element[], gesture: Gesture): Element[] =>
  applied(elements, edits_of(elements, gesture))!;
const corners = (elements: Element[]): Point[] => elements.map(({ from }) => from);
const near = (a: Point, b: Point): void => a.forEach((v, i) => expect(v).toBeCloseTo(b[i], 6));

it('a side of a pocket is moved beside itself, and the sides next to it become longer', () => {
  const edits = edits_of(pocket, { kind: 'edge', element: 1, by: -2 });
  expect(edits).toEqual([{ op: 'modify-line', element: 1, from: [52, 10], to: [52, 38] }]);
  const wider = applied(pocket, edits)!;
  expect(corners(wider)).toEqual([
    [10, 10],
    [52, 10],
    [52, 38],
    [10, 38],
  ]);
  expect(length(wider[0])).toBe(42);
});

it('a length that is typed moves the side that follows, so that nothing becomes slanted', () => {
  expect(edits_of(pocket, { kind: 'length', element: 0, length: 42 })).toEqual([
    { op: 'modify-line', element: 1, from: [52, 10], to: [52, 38] },
  ]);
});

it('beside slanted sides a side keeps their directions', () => {
  const slanted = elements_of(
    [
      [0, 0, 0],
      [40, 0, 0],
      [30, 20, 0],
      [10, 20, 0],
    ],
    true,
  );
  const before = slanted.map(angle_deg);
  for (const by of [-3, 5]) {
    const after = done(slanted, { kind: 'edge', element: 0, by });
    after.map(angle_deg).forEach((angle, i) => expect(angle).toBeCloseTo(before[i], 6));
    expect(after[0].from[1]).toBeCloseTo(by, 6);
  }
});

/** 40 × 20 with corners of 5. */
const rounded = elements_of(
  [
    [5, 0, 0],
    [35, 0, Math.SQRT2 - 1],
    [40, 5, 0],
    [40, 15, Math.SQRT2 - 1],
    [35, 20, 0],
    [5, 20, Math.SQRT2 - 1],
    [0, 15, 0],
    [0, 5, Math.SQRT2 - 1],
  ],
  true,
);

it('fillets go with the side that they end in, and stay as round as they are', () => {
  const after = done(rounded, { kind: 'edge', element: 2, by: -3 });
  for (const [i, r] of [1, 3, 5, 7].map((k) => [k, radius(after[k])]))
    expect(r, `arc ${i}`).toBeCloseTo(5, 5);
  near(after[2].from, [43, 5]);
  near(after[2].to, [43, 15]);
  near(after[0].to, [38, 0]);
  near(after[4].from, [38, 20]);
  expect(after[0].from).toEqual([5, 0]);
});

it('a length goes through a fillet to the side behind it', () => {
  const after = done(rounded, { kind: 'length', element: 0, length: 32 });
  expect(length(after[0])).toBeCloseTo(32, 6);
  near(after[2].from, [42, 5]);
});

it('a side between half circles moves alone, and the half circles stay half circles', () => {
  const slot = elements_of(
    [
      [0, 0, 0],
      [30, 0, 1],
      [30, 10, 0],
      [0, 10, 1],
    ],
    true,
  );
  const after = done(slot, { kind: 'edge', element: 0, by: -2 });
  near(after[0].from, [0, -2]);
  expect(after[1]).toMatchObject({ bulge: 1, to: [30, 10] });
  expect(radius(after[1])).toBeCloseTo(6, 9);
});

it('a corner takes both of its sides with it, an end of an arc keeps its roundness', () => {
  const moved = done(pocket, { kind: 'corner', element: 1, at_end: false, to: [55, 8] });
  expect(moved[0].to).toEqual([55, 8]);
  expect(moved[1].from).toEqual([55, 8]);
  const arc = done(rounded, { kind: 'corner', element: 1, at_end: false, to: [33, 0] });
  expect(arc[0].to).toEqual([33, 0]);
  expect(arc[1].from).toEqual([33, 0]);
  expect(arc[1].bulge).toBeCloseTo(rounded[1].bulge, 9);
});

it('an arc has another radius between its ends, and none that is too small', () => {
  const edits = edits_of(rounded, { kind: 'arc', element: 1, radius: 6 });
  expect(edits).toEqual([{ op: 'modify-arc', element: 1, radius: 6 }]);
  expect(radius(applied(rounded, edits)![1])).toBeCloseTo(6, 9);
  expect(edits_of(rounded, { kind: 'arc', element: 1, radius: 3 })).toEqual([]);
});

it('a round pocket has one radius', () => {
  const round = elements_of(p1.features[2].nominal!, true);
  const edits = edits_of(round, { kind: 'arc', element: 1, radius: 9 });
  expect(edits).toMatchObject([{ op: 'replace' }]);
  const larger = applied(round, edits)!;
  expect(larger.map(radius)).toEqual([9, 9]);
  near(midpoint(larger[0]), [62, 51]);
});

it('a key moves a side across itself, a corner anywhere, and makes an arc rounder', () => {
  expect(nudge(pocket, 1, 'element', [0.1, 0])).toEqual({ kind: 'edge', element: 1, by: -0.1 });
  expect(nudge(pocket, 1, 'element', [0, 0.1])).toBeNull();
  expect(nudge(pocket, 1, 'start', [0.1, 0])).toMatchObject({ kind: 'corner', to: [50.1, 10] });
  expect(nudge(rounded, 1, 'element', [0, 1])).toMatchObject({ kind: 'arc' });
});

it('what is dragged is measured across the side, and of an arc through the pointer', () => {
  expect(drag_of(pocket[1], [50, 24], [53, 99])).toBeCloseTo(-3, 9);
  expect(radius_through(rounded[1], midpoint(rounded[1]))).toBeCloseTo(5, 9);
  expect(radius_through(rounded[1], [37, 3])).toBeNull();
});

it('what is another edit is left to the server', () => {
  expect(applied(pocket, [{ op: 'fillet', corner: 1, r: 3 }])).toBeNull();
  expect(applied(pocket, [{ op: 'modify-line', element: 9, from: [0, 0] }])).toBeNull();
});

it('a half section is open, and drawn with radii', () => {
  const half = elements_of(shaft.features[0].contour, false, true);
  expect(half).toHaveLength(shaft.features[0].contour.length - 1);
  expect(half[2]).toMatchObject({ from: [-0.765685, 10], to: [-24, 10] });
  expect(radius(half[4])).toBeCloseTo(2.6, 3);
});
