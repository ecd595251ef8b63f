/**
 * Which line of one text is which of another that was made of it by edits: the machine executes the text that was loaded,
 * the editor shows the one of now. Found by comparing the two, so that it holds however the second came about: by typing,
 * from a draft, from an earlier revision.
 */
import { lines_of } from './line_ends';

export interface LineMap {
  /** Where a line of the first text is in the second; null: it is gone. Lines count from 1. */
  forth(line: number): number | null;
  /** Where a line of the second text was in the first; null: it is new. */
  back(line: number): number | null;
}

/** A stretch in which the texts differ: lines [from, from + removed) of the first became [to, to + added) of the second. */
export interface Hunk {
  from: number;
  removed: number;
  to: number;
  added: number;
}

/** More changes than this are not told apart: the whole stretch between the equal ends is one. */
const MOST_CHANGES = 1000;

const SAME: LineMap = { forth: (line) => line, back: (line) => line };

export function line_map(first: string, second: string): LineMap {
  if (first === second) return SAME;
  const hunks = hunks_of(lines_of(first), lines_of(second));
  const turned = hunks.map(({ from, removed, to, added }) => ({
    from: to,
    removed: added,
    to: from,
    added: removed,
  }));
  return {
    forth: (line) => moved(hunks, line),
    back: (line) => moved(turned, line),
  };
}

/** A changed line is the line in its place; where a stretch has become shorter, its last lines are gone. */
function moved(hunks: Hunk[], line: number): number | null {
  let low = 0;
  let high = hunks.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (hunks[middle].from < line) low = middle + 1;
    else high = middle;
  }
  const hunk = hunks[low - 1];
  if (!hunk) return line;
  const into = line - 1 - hunk.from;
  if (into >= hunk.removed) return line + hunk.to + hunk.added - hunk.from - hunk.removed;
  return into < hunk.added ? hunk.to + into + 1 : null;
}

/** From 0 on, in order. */
export function hunks_of(a: readonly string[], b: readonly string[]): Hunk[] {
  const head = equal_from_start(a, b);
  const tail = equal_from_end(a, b, head);
  const removed = a.length - head - tail;
  const added = b.length - head - tail;
  if (removed === 0 && added === 0) return [];
  const whole = { from: head, removed, to: head, added };
  if (removed === 0 || added === 0) return [whole];
  const between = (lines: readonly string[]) => lines.slice(head, lines.length - tail);
  const script = shortest_script(between(a), between(b), MOST_CHANGES);
  return script?.map((h) => ({ ...h, from: h.from + head, to: h.to + head })) ?? [whole];
}

function equal_from_start(a: readonly string[], b: readonly string[]): number {
  let head = 0;
  while (head < a.length && head < b.length && a[head] === b[head]) head++;
  return head;
}

/** But for those that are equal from the start. */
function equal_from_end(a: readonly string[], b: readonly string[], head: number): number {
  const most = Math.min(a.length, b.length) - head;
  let tail = 0;
  while (tail < most && a[a.length - 1 - tail] === b[b.length - 1 - tail]) tail++;
  return tail;
}

/** Myers' O(ND) algorithm: the fewest lines removed and added. Null: more than `most`. */
function shortest_script(a: readonly string[], b: readonly string[], most: number): Hunk[] | null {
  const trail: Int32Array[] = [];
  let reach = new Int32Array(3);
  for (let changes = 0; changes <= most; changes++) {
    const next = new Int32Array(2 * changes + 3);
    for (let k = -changes; k <= changes; k += 2) {
      const at = (d: number): number => reach[d + changes] ?? 0; // reach is one change narrower
      const down = k === -changes || (k !== changes && at(k - 1) < at(k + 1));
      let x = changes === 0 ? 0 : down ? at(k + 1) : at(k - 1) + 1;
      while (x < a.length && x - k < b.length && a[x] === b[x - k]) x++;
      next[k + changes + 1] = x;
      if (x >= a.length && x - k >= b.length) return script_of(trail, a.length, b.length);
    }
    trail.push(next);
    reach = next;
  }
  return null;
}

/** Back from the end, from change to change; `trail[d]` holds how far the diagonals -d … d came. */
function script_of(trail: Int32Array[], x: number, y: number): Hunk[] {
  const hunks: Hunk[] = [];
  for (let changes = trail.length; changes > 0; changes--) {
    const reach = trail[changes - 1];
    const at = (d: number): number => reach[d + changes] ?? 0;
    const k = x - y;
    const down = k === -changes || (k !== changes && at(k - 1) < at(k + 1));
    const x_before = down ? at(k + 1) : at(k - 1);
    const y_before = x_before - (down ? k + 1 : k - 1);
    join(hunks, { from: x_before, removed: down ? 0 : 1, to: y_before, added: down ? 1 : 0 });
    x = x_before;
    y = y_before;
  }
  return hunks.reverse();
}

/** The list goes backwards: one that ends where the last one begins is part of it. */
function join(hunks: Hunk[], hunk: Hunk): void {
  const last = hunks[hunks.length - 1];
  if (last && hunk.from + hunk.removed === last.from && hunk.to + hunk.added === last.to) {
    last.from = hunk.from;
    last.to = hunk.to;
    last.removed += hunk.removed;
    last.added += hunk.added;
  } else hunks.push(hunk);
}
