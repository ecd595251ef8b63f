/** What the picture is to show when it is fitted. */
import { type Box, diagonal, empty_box, grow, is_empty, join } from './box';
import type { Point } from './kinematics';

/** A path shorter than this is a place: there is nothing to be seen of it. */
const SHORTEST_MM = 1e-3;

export const is_path = (bounds: Box): boolean => diagonal(bounds) > SHORTEST_MM;

export interface Wishes {
  rapids: boolean;
  /** Where the tool stands. */
  tip: Point | null;
  /** What is so far off that the cuts would become a smaller part of the box than this is left out. */
  least_cuts: number;
}

/** The cuts, or the whole path where it cuts nothing, then its rapids, then the tool. */
export function fit_box(cuts: Box, bounds: Box, { rapids, tip, least_cuts }: Wishes): Box {
  const subject = is_empty(cuts) ? bounds : cuts;
  const most_mm = diagonal(subject) / least_cuts;
  let box = joined(empty_box(), subject);
  for (const other of [rapids ? bounds : empty_box(), box_at(tip)]) {
    const larger = joined(box, other);
    if (diagonal(larger) <= most_mm) box = larger;
  }
  return box;
}

function joined(a: Box, b: Box): Box {
  const box = empty_box();
  join(box, a);
  join(box, b);
  return box;
}

function box_at(place: Point | null): Box {
  const box = empty_box();
  if (place) grow(box, ...place);
  return box;
}
