import { expect, it } from 'vitest';
import { diff_rows } from '../../src/logic/features/diff_rows';
import { edits_name, edits_text, with_diameters } from '../../src/logic/features/edits';
import { Newest } from '../../src/logic/features/newest';
import { offer_of, with_offer } from '../../src/logic/features/offers';
import {
  before_step,
  done_again,
  edits_of_steps,
  NO_STEPS,
  outlines_of_steps,
  type Outline,
  taken_back,
  with_outlines,
  with_step,
} from '../../src/logic/features/steps';

it('of questions one is under way, and of those that wait only the newest is asked', async () => {
  const asked: number[] = [];
  const told: [number, boolean][] = [];
  const answers: (() => void)[] = [];
  const newest = new Newest<number, string>(
    (wish) => {
      asked.push(wish);
      return new Promise((resolve) => answers.push(() => resolve(String(wish))));
    },
    (answer, wish, is_newest) => {
      expect(answer).toBe(String(wish));
      told.push([wish, is_newest]);
    },
  );
  [1, 2, 3].forEach((wish) => newest.want(wish));
  expect(asked).toEqual([1]);
  answers.shift()!();
  await new Promise((resolve) => setTimeout(resolve));
  expect(asked).toEqual([1, 3]);
  answers.shift()!();
  await new Promise((resolve) => setTimeout(resolve));
  expect(told).toEqual([
    [1, false],
    [3, true],
  ]);
  expect(newest.is_busy).toBe(false);
});

it('an edits file is what kerf edit reads, an edit a line', () => {
  const text = edits_text([
    { op: 'depth', feature: 'F1', z: -5 },
    { op: 'delete-feature', feature: 'H1' },
  ]);
  expect(JSON.parse(text)).toEqual({
    version: 1,
    edits: [
      { op: 'depth', feature: 'F1', z: -5 },
      { op: 'delete-feature', feature: 'H1' },
    ],
  });
  expect(text.split('\n')[2]).toContain('delete-feature');
  expect(edits_name('part.nc')).toBe('part-edits.json');
});

it('of a lathe points are told with diameters, and lengths are not', () => {
  const edit = { op: 'modify-line', element: 1, from: [-5, 10] as [number, number], length: 7 };
  expect(with_diameters(edit)).toEqual({ ...edit, from: [-5, 20] });
});

it('a diff has rows with the numbers of their lines', () => {
  const diff = [
    '--- a/p1.nc',
    '+++ b/p1.nc',
    '@@ -21,3 +21,4 @@',
    ' N160',
    '-N180 X40 F300',
    '+N180 X42 F300',
    '+N185 Y1',
    ' N190',
    '',
  ];
  expect(diff_rows(diff.join('\n'))).toEqual([
    { kind: 'place', line: null, text: '@@ -21,3 +21,4 @@' },
    { kind: 'same', line: 21, text: 'N160' },
    { kind: 'removed', line: 22, text: 'N180 X40 F300' },
    { kind: 'added', line: 22, text: 'N180 X42 F300' },
    { kind: 'added', line: 23, text: 'N185 Y1' },
    { kind: 'same', line: 23, text: 'N190' },
  ]);
  expect(diff_rows('')).toEqual([]);
});

const outline = (x: number): Outline[] => [
  { island: null, is_closed: true, elements: [{ id: 0, from: [x, 0], to: [1, 1], bulge: 0 }] },
];
const edit = (x: number) => [{ op: 'modify-line', element: 0, from: [x, 0] as [number, number] }];

it('steps are taken back and done again, and a new one forgets those that were taken back', () => {
  let steps = with_step(NO_STEPS, { edits: edit(1), outlines: outline(1), merges: '' });
  steps = with_step(steps, {
    edits: [{ op: 'fillet', corner: 0, r: 2 }],
    outlines: null,
    merges: '',
  });
  expect(edits_of_steps(steps).map(({ op }) => op)).toEqual(['modify-line', 'fillet']);
  expect(outlines_of_steps(steps, outline(0))).toEqual(outline(1));
  steps = with_outlines(steps, 2, outline(7));
  expect(outlines_of_steps(steps, outline(0))).toEqual(outline(7));
  steps = taken_back(steps);
  expect(edits_of_steps(steps)).toEqual(edit(1));
  expect(outlines_of_steps(done_again(steps), outline(0))).toEqual(outline(7));
  steps = with_step(steps, { edits: edit(3), outlines: null, merges: '' });
  expect(done_again(steps).done).toHaveLength(2);
  expect(taken_back(NO_STEPS)).toEqual(NO_STEPS);
});

it('steps of one kind are one, counted from what was before the first of them', () => {
  const key = 'edge 1';
  let steps = with_step(NO_STEPS, { edits: edit(1), outlines: outline(1), merges: '' });
  for (const x of [2, 3]) {
    expect(before_step(steps, key, outline(0))).toEqual(outline(1));
    steps = with_step(steps, { edits: edit(x), outlines: outline(x), merges: key });
  }
  expect(edits_of_steps(steps)).toEqual([...edit(1), ...edit(3)]);
  expect(before_step(steps, 'edge 2', outline(0))).toEqual(outline(3));
});

it('a refusal offers what one member of the file is enough for', () => {
  expect(offer_of('EDIT_SHARED', false)).toBe('scope-all');
  expect(offer_of('EDIT_IN_LOOP', false)).toBe('unroll');
  expect(offer_of('EDIT_EXPRESSION', true)).toBe('argument');
  expect(offer_of('EDIT_EXPRESSION', false)).toBe('unroll');
  expect(offer_of('EDIT_OPEN', true)).toBeNull();
  expect(with_offer([{ op: 'depth', z: -1 }], 'unroll')).toEqual([
    { op: 'depth', z: -1, unroll: true },
  ]);
  expect(with_offer([{ op: 'depth', z: -1 }], 'scope-all')).toEqual([
    { op: 'depth', z: -1, scope: 'all' },
  ]);
});
