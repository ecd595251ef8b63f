/** The dimensions of what is selected, each of which can be typed: every drag of a hand has its number. */
import { type Edit } from './edits';
import {
  angle_deg,
  by_id,
  type Element,
  is_arc,
  length,
  type Point,
  radius,
  rounded,
} from './elements';
import { edits_of } from './gestures';

export type Part = 'element' | 'start' | 'end';

export interface Selected {
  /** Null: the outer contour. */
  island: number | null;
  element: number;
  part: Part;
}

export type DimensionName =
  'length' | 'angle' | 'radius' | 'x1' | 'y1' | 'x2' | 'y2' | 'x' | 'y' | 'by';

export interface Dimension {
  name: DimensionName;
  value: number;
  /** What is to be edited so that it has this value; none: it cannot. */
  edits(value: number): Edit[];
}

/** `turned`: x of a lathe is told as a diameter. */
export function dimensions_of(
  elements: readonly Element[],
  selected: Selected,
  turned = false,
): Dimension[] {
  const element = by_id(elements, selected.element);
  if (!element) return [];
  const { part } = selected;
  if (part !== 'element') return place(elements, element, part === 'end', ['x', 'y'], turned);
  const ends = [
    ...place(elements, element, false, ['x1', 'y1'], turned),
    ...place(elements, element, true, ['x2', 'y2'], turned),
  ];
  return [...(is_arc(element) ? of_arc(elements, element) : of_line(elements, element)), ...ends];
}

function of_line(elements: readonly Element[], element: Element): Dimension[] {
  const { id } = element;
  return [
    {
      name: 'length',
      value: rounded(length(element)),
      edits: (value) => edits_of(elements, { kind: 'length', element: id, length: value }),
    },
    {
      name: 'by',
      value: 0,
      // As a person sees it: outwards of a contour is more, and its way is counterclockwise.
      edits: (value) => edits_of(elements, { kind: 'edge', element: id, by: -value }),
    },
    {
      name: 'angle',
      value: rounded(angle_deg(element)),
      edits: (value) => [{ op: 'modify-line', element: id, angle_deg: value }],
    },
  ];
}

function of_arc(elements: readonly Element[], element: Element): Dimension[] {
  const edits = (value: number): Edit[] =>
    edits_of(elements, { kind: 'arc', element: element.id, radius: value });
  return [{ name: 'radius', value: rounded(radius(element)), edits }];
}

function place(
  elements: readonly Element[],
  element: Element,
  at_end: boolean,
  names: [DimensionName, DimensionName],
  turned: boolean,
): Dimension[] {
  const at = at_end ? element.to : element.from;
  return names.map((name, i) => {
    const times = turned && i === 1 ? 2 : 1;
    const edits = (value: number): Edit[] => {
      const to = at.map((old, k) => (k === i ? value / times : old)) as Point;
      return edits_of(elements, { kind: 'corner', element: element.id, at_end, to });
    };
    return { name, value: rounded(at[i] * times), edits };
  });
}
