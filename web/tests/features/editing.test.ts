import { expect, it } from 'vitest';
import { edits_of_action, lacks, numbers_of } from '../../src/logic/features/actions';
import { dimensions_of, type Selected } from '../../src/logic/features/dimensions';
import { elements_of } from '../../src/logic/features/elements';
import { is_too_long, travel_share } from '../../src/logic/features/insight';
import { of_layer, outlines_of } from '../../src/logic/features/preview';
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
import { p1, shaft } from './documents';

type Pair = [number, number];

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

it('regions of layers that lie upon each other are those of one layer', () => {
  const square = (x: number): [number, number, number][] => [
    [x, 0, 0],
    [x + 1, 0, 0],
    [x + 1, 1, 0],
  ];
  const list = [2, 1].map((layer) => ({ feature: 'F1', layer, regions: [square(layer)] }));
  expect(of_layer(list, null)).toEqual([square(1)]);
  expect(of_layer(list, 2)).toEqual([square(2)]);
  expect(of_layer(list, 3)).toEqual([]);
  expect(of_layer(undefined, null)).toEqual([]);
});

it('the contours of an answer are those of the feature and layer that are edited', () => {
  const elements = [{ id: 0, from: [0, 20] as Pair, to: [-5, 20] as Pair, bulge: 0 }];
  const contour = { feature: 'F1', layer: 1, island: null, closed: false, elements };
  const answer = { revision: 1, problem: null, contours: [contour, { ...contour, feature: 'F2' }] };
  const drawn = outlines_of(answer, 'F1', null, true);
  expect(drawn).toMatchObject([{ island: null, elements: [{ from: [0, 10], to: [-5, 10] }] }]);
  expect(outlines_of(answer, 'F1', 2, true)).toBeNull();
  expect(outlines_of(answer, 'F3', null, true)).toBeNull();
});

it('a contour is made to be as its numbers say', () => {
  const pocket = elements_of(p1.features[0].nominal!, true);
  const named = (selected: Selected, name: string) =>
    dimensions_of(pocket, selected).find((dimension) => dimension.name === name)!;
  const side: Selected = { island: null, element: 1, part: 'element' };
  expect(named(side, 'by').edits(2)).toMatchObject([{ from: [52, 10], to: [52, 38] }]);
  expect(named(side, 'angle').edits(80)).toEqual([
    { op: 'modify-line', element: 1, angle_deg: 80 },
  ]);
  const corner: Selected = { island: null, element: 2, part: 'start' };
  expect(named(corner, 'y').edits(40)).toEqual([{ op: 'modify-line', element: 2, from: [50, 40] }]);
  const half = elements_of(shaft.features[0].contour, false, true);
  const x = dimensions_of(half, { island: null, element: 2, part: 'start' }, true)[1];
  expect(x.value).toBe(20);
  expect(x.edits(22)).toEqual([{ op: 'modify-line', element: 2, from: [-0.765685, 11] }]);
});

it('actions say what they lack, and a line closes the gap', () => {
  const pocket = elements_of(p1.features[0].nominal!, true);
  const selected: Selected = { island: null, element: 1, part: 'element' };
  const all = { elements: pocket, selected, other: null, place: [3.4, 5.6] as Pair };
  expect(lacks('join', all)).toBe('needs-two-elements');
  expect(lacks('fillet', { ...all, selected: null })).toBe('needs-element');
  expect(lacks('fillet', all)).toBeNull();
  expect(edits_of_action('fillet', { r: 3 }, all)).toEqual([{ op: 'fillet', corner: 1, r: 3 }]);
  const end = { ...all, selected: { ...selected, part: 'end' as const } };
  expect(edits_of_action('chamfer', { d1: 1, d2: 2 }, end)).toMatchObject([{ corner: 2 }]);
  const open = { ...all, elements: pocket.filter(({ id }) => id !== 2) };
  expect(numbers_of('line', open)).toEqual({ x1: 50, y1: 38, x2: 10, y2: 38 });
  expect(edits_of_action('island', { x: 30, y: 24, w: 4, h: 2 }, all)[0].contour?.[2]).toEqual([
    32, 25, 0,
  ]);
});

it('what a program is like has its travel as a share, and says what no offset makes fit', () => {
  const travel = { axis: 'X', from: -10, to: 115, limit_from: 0, limit_to: 500 };
  expect(travel_share(travel)).toBe(25);
  expect(is_too_long(travel)).toBe(false);
  expect(is_too_long({ ...travel, to: 500 })).toBe(true);
  expect(travel_share({ ...travel, limit_to: null })).toBeNull();
});
