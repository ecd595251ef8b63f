import { expect, it } from 'vitest';
import { by_id, elements_of, radius } from '../../src/logic/features/elements';
import { applied, edits_of } from '../../src/logic/features/gestures';
import { held_by, pulled, pulls_of, scene_of, type Grip } from '../../src/logic/features/pulls';
import { SNAP_KINDS, type SnapKind } from '../../src/logic/features/snap';

/** A stadium's half: a line, a half circle up to the left, a line back to the left, and a side that leans. */
const contour = elements_of(
  [
    [0, 0, 0],
    [40, 0, 1],
    [40, 20, 0],
    [5, 21, 0],
  ],
  true,
);
const grip = (element: number, part: Grip['part']): Grip => ({
  element: by_id(contour, element)!,
  part,
  before: contour,
});
const snapping = (own: Grip, ...kinds: SnapKind[]) => ({
  scene: scene_of(own, contour, 0.1),
  kinds: new Set(kinds),
  reach: 1,
});

it('a corner is drawn to where its side goes on from the arc without a bend', () => {
  const own = grip(2, 'end');
  const pull = pulled(own, [5, 21], [5.3, 20.4], snapping(own, 'tangent'));
  expect(pull!.mark).toMatchObject({ kind: 'tangent', of: { id: 1 } });
  expect(pull!.mark!.at[1]).toBeCloseTo(20, 9);
  expect(pull!.mark!.at[0]).toBeCloseTo(5.3, 9);
  expect(pull!.gesture).toMatchObject({ kind: 'corner', element: 2, at_end: true });
  expect(pulled(own, [5, 21], [5.3, 20.4], snapping(own, 'end'))!.mark).toBeNull();
});

it('a corner is drawn to where its side is as long as another line, along an axis before askew', () => {
  const own = grip(2, 'end');
  const askew = pulled(own, [5, 21], [0.4, 24.5], snapping(own, 'length'))!.mark!;
  expect(askew).toMatchObject({ kind: 'length', of: { id: 0 } });
  expect(Math.hypot(40 - askew.at[0], 20 - askew.at[1])).toBeCloseTo(40, 9);
  const square = pulled(own, [5, 21], [0.4, 20.5], snapping(own, 'length'))!.mark!;
  expect(square.at).toEqual([0, 20]);
});

it('an edge is drawn to where a side beside it is as long as another line', () => {
  const box = elements_of(
    [
      [0, 0, 0],
      [30, 0, 0],
      [30, 20, 0],
      [0, 20, 0],
    ],
    true,
  );
  const own: Grip = { element: box[1], part: 'element', before: box };
  // The sides beside it become as long as it is, not as long as they are.
  const kinds = new Set<SnapKind>(['length']);
  const scene = scene_of(own, box, 0.1);
  const pull = pulled(own, [30, 10], [20.4, 10], { scene, kinds, reach: 1 })!;
  expect(pull.mark).toMatchObject({ kind: 'length', at: [20, 10] });
  const made = applied(box, edits_of(box, pull.gesture))!;
  expect(by_id(made, 0)!.to).toEqual([20, 0]);
});

it('an arc is drawn to the radius with which it leaves a line without a bend, and to that of another', () => {
  const bent = elements_of(
    [
      [0, 0, 0],
      [40, 0, 0.3],
      [50, 10, 0],
      [50, 30, 0.5],
      [30, 30, 0],
      [0, 30, 0],
    ],
    true,
  );
  const own: Grip = { element: bent[1], part: 'element', before: bent };
  const scene = scene_of(own, bent, 0.1);
  const all = pulls_of(own, { scene, kinds: new Set(SNAP_KINDS), reach: 1 });
  const radii = all.map(({ gesture, mark }) => [
    (gesture as { radius: number }).radius,
    mark!.kind,
    mark!.of!.id,
  ]);
  // Both neighbours lie along the axes, so that R10 suits both: it is told once.
  const sorted = radii.map(([r]) => Math.abs((r as number) - radius(bent[1])));
  expect([...sorted].sort((a, b) => a - b)).toEqual(sorted);
  expect(radii.filter(([, kind]) => kind === 'tangent')).toHaveLength(1);
  const tangent = radii.find(([, kind]) => kind === 'tangent')!;
  expect(tangent[0]).toBeCloseTo(10, 9);
  expect(radii.find(([, kind]) => kind === 'length')![0]).toBeCloseTo(radius(bent[3]), 9);
});

it('keys go to what is nearest first, never to where they are, and know what holds there', () => {
  const own = grip(2, 'end');
  const near = { ...snapping(own, 'tangent', 'length', 'end'), reach: 1e-3 };
  const pulls = pulls_of(own, near);
  const far = pulls.map(({ mark }) => Math.hypot(mark!.at[0] - 5, mark!.at[1] - 21));
  expect(far).toEqual([...far].sort((a, b) => a - b));
  expect(far[0]).toBeGreaterThan(1e-3);
  expect(pulls[0].mark!.kind).toBe('tangent');
  expect(held_by(own, near)).toBeNull();
  const moved = applied(contour, edits_of(contour, pulls[0].gesture))!;
  const there: Grip = { element: by_id(moved, 2)!, part: 'end', before: moved };
  const held = held_by(there, { scene: scene_of(there, [], 0.1), kinds: near.kinds, reach: 1 });
  expect(held).toMatchObject({ kind: 'tangent', of: { id: 1 } });
  expect(held!.at[1]).toBeCloseTo(20, 9);
});
