/** What has been done in the contour editor, step by step: each can be taken back, and done again. */
import type { Edit } from './edits';
import type { Element } from './elements';

/** The outer contour, then the islands. */
export interface Outline {
  /** Null: the outer one. */
  island: number | null;
  is_closed: boolean;
  elements: Element[];
}

export interface Step {
  edits: Edit[];
  /** What all edits up to here make; null: the server has not said it yet. */
  outlines: Outline[] | null;
  /** Steps of one kind, one behind the other, are one: keys that are pressed again and again. */
  merges: string;
}

export interface Steps {
  done: Step[];
  undone: Step[];
}

export const NO_STEPS: Steps = { done: [], undone: [] };

export const with_step = ({ done }: Steps, step: Step): Steps => {
  const last = done.at(-1);
  const is_same = step.merges !== '' && last?.merges === step.merges;
  return { done: [...(is_same ? done.slice(0, -1) : done), step], undone: [] };
};

export function taken_back({ done, undone }: Steps): Steps {
  const last = done.at(-1);
  return last ? { done: done.slice(0, -1), undone: [...undone, last] } : { done, undone };
}

export function done_again({ done, undone }: Steps): Steps {
  const last = undone.at(-1);
  return last ? { done: [...done, last], undone: undone.slice(0, -1) } : { done, undone };
}

/** All edits, in their order. */
export const edits_of_steps = ({ done }: Steps): Edit[] => done.flatMap(({ edits }) => edits);

/** The last thing that is known of the contour. */
export function outlines_of_steps({ done }: Steps, original: Outline[]): Outline[] {
  const known = done.filter(({ outlines }) => outlines !== null);
  return known.at(-1)?.outlines ?? original;
}

/** What the contour was before the last step, if that merges with the next one. */
export function before_step({ done }: Steps, merges: string, original: Outline[]): Outline[] {
  const is_same = merges !== '' && done.at(-1)?.merges === merges;
  return outlines_of_steps({ done: is_same ? done.slice(0, -1) : done, undone: [] }, original);
}

/** The server has said what the edits up to a step make. */
export function with_outlines(steps: Steps, count: number, outlines: Outline[]): Steps {
  const fill = (step: Step, i: number): Step => (i === count - 1 ? { ...step, outlines } : step);
  return { ...steps, done: steps.done.map(fill) };
}
