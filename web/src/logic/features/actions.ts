/** What can be done to a contour besides moving it: with the numbers that each needs, and what they are at first. */
import type { Selected } from './dimensions';
import type { Edit } from './edits';
import { by_id, type Element, is_arc, midpoint, neighbour, type Point, rounded } from './elements';

/** Those that ask for numbers. */
export const FORM_ACTIONS = ['line', 'arc', 'fillet', 'chamfer', 'island'] as const;
export type FormAction = (typeof FORM_ACTIONS)[number];
export type Action = FormAction | 'join' | 'delete';

export type ActionNumbers = Record<string, number>;

/** The key that does it. */
export const ACTION_KEYS: Record<string, Action> = {
  l: 'line',
  a: 'arc',
  f: 'fillet',
  c: 'chamfer',
  j: 'join',
  Delete: 'delete',
  Backspace: 'delete',
};

interface Situation {
  elements: readonly Element[];
  selected: Selected | null;
  /** Selected before that. */
  other: Selected | null;
  /** Where the pointer is, or the middle of what is seen. */
  place: Point;
}

/** Why an action has nothing to work on; null: it can be done. */
export function lacks(action: Action, { elements, selected, other }: Situation): string | null {
  if (action === 'line' || action === 'arc' || action === 'island') return null;
  if (!selected) return 'needs-element';
  if (action === 'join')
    return other && other.element !== selected.element ? null : 'needs-two-elements';
  if (action === 'delete') return null;
  return corner_of(elements, selected) === null ? 'needs-corner' : null;
}

/** The corner that is meant: an end that is selected, or where a selected element begins. */
export function corner_of(elements: readonly Element[], selected: Selected): number | null {
  const element = by_id(elements, selected.element);
  if (!element) return null;
  if (selected.part === 'end') return neighbour(elements, element, true)?.id ?? null;
  return neighbour(elements, element, false) ? element.id : null;
}

/** By their names; a lathe's x are diameters only in the file. */
export function numbers_of(action: FormAction, situation: Situation): ActionNumbers {
  const [x, y] = situation.place.map((value) => Math.round(value));
  if (action === 'fillet') return { r: 5 };
  if (action === 'chamfer') return { d1: 2, d2: 2 };
  if (action === 'island') return { x, y, w: 10, h: 10 };
  const [from, to] = gap_of(situation) ?? [
    [x, y],
    [x + 10, y],
  ];
  const ends = { x1: from[0], y1: from[1], x2: to[0], y2: to[1] };
  return action === 'line' ? ends : { ...ends, xm: (from[0] + to[0]) / 2, ym: from[1] + 5 };
}

/** Where a contour is open: what is drawn there closes it. */
function gap_of({ elements }: Situation): [Point, Point] | null {
  const ends = elements.filter((element) => !neighbour(elements, element, true));
  const begins = elements.filter((element) => !neighbour(elements, element, false));
  return ends.length === 1 && begins.length === 1 ? [ends[0].to, begins[0].from] : null;
}

export function edits_of_action(
  action: Action,
  numbers: ActionNumbers,
  { elements, selected, other }: Situation,
): Edit[] {
  const n = (name: string): number => rounded(numbers[name]);
  const p = (x: string, y: string): Point => [n(x), n(y)];
  if (action === 'line') return [{ op: 'add-line', from: p('x1', 'y1'), to: p('x2', 'y2') }];
  if (action === 'arc')
    return [{ op: 'add-arc', through: [p('x1', 'y1'), p('xm', 'ym'), p('x2', 'y2')] }];
  if (action === 'island') return [{ op: 'add-island', contour: box(numbers) }];
  if (!selected) return [];
  if (action === 'delete') return [{ op: 'delete', element: selected.element }];
  if (action === 'join')
    return other ? [{ op: 'join', elements: [other.element, selected.element] }] : [];
  const corner = corner_of(elements, selected);
  if (corner === null) return [];
  if (action === 'fillet') return [{ op: 'fillet', corner, r: n('r') }];
  return [{ op: 'chamfer', corner, d1: n('d1'), d2: n('d2') }];
}

/** Counterclockwise about its middle. */
function box({ x, y, w, h }: ActionNumbers): [number, number, number][] {
  const signs = [
    [-1, -1],
    [1, -1],
    [1, 1],
    [-1, 1],
  ];
  return signs.map(([a, b]) => [rounded(x + (a * w) / 2), rounded(y + (b * h) / 2), 0]);
}

/** Where the numbers of a dimension stand: at the middle of an element, or at the corner. */
export function label_place(
  elements: readonly Element[],
  { element, part }: Selected,
): Point | null {
  const found = by_id(elements, element);
  if (!found) return null;
  if (part === 'element') return midpoint(found);
  return part === 'start' ? found.from : found.to;
}

/** What an element is, in a word and its size. */
export const kind_of = (element: Element): 'line' | 'arc' => (is_arc(element) ? 'arc' : 'line');
