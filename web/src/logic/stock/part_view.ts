/** Which state of the part is to be seen, and where its findings stand on the slider. */
import type { Finding, PartFacts } from './part_store';

/**
 * Seconds of the program; null: as far as it is cut. Whoever has moved the slider sees that instant; while the program runs the
 * part is as the machine has made it; before it begins, and when it is over, it is seen as it becomes.
 */
export function wanted_time(now: {
  slider_s: number | null;
  path_s: number | null;
  is_over: boolean;
}): number | null {
  if (now.slider_s !== null) return now.slider_s;
  return now.is_over ? null : now.path_s;
}

/** Cells of which a browser makes triangles within a second or two. */
const MOST_FINE_CELLS = 2_500_000;

/** Whether there is a finer level that is worth to be asked for. */
export function asks_for_fine({ levels }: PartFacts, is_wanted: boolean): boolean {
  const fine = levels[1];
  return is_wanted && (!fine || fine.cells[0] * fine.cells[1] <= MOST_FINE_CELLS);
}

export interface SliderMark {
  /** Of the slider, 0 to 1. */
  share: number;
  severity: Finding['severity'];
  /** Those that stand so close that they are one mark, in the order of time. */
  findings: Finding[];
}

/** So many marks find room side by side. */
const PLACES = 160;

/** `end_s` and the times of marks are those of the slider. */
export function finding_marks(
  findings: readonly Finding[],
  end_s: number,
  on_slider: (program_s: number) => number = (s) => s,
): SliderMark[] {
  if (!(end_s > 0)) return [];
  const places = new Map<number, SliderMark>();
  for (const finding of findings) {
    const share = Math.min(1, Math.max(0, on_slider(finding.time_s) / end_s));
    const place = Math.round(share * PLACES);
    const mark = places.get(place) ?? { share, severity: finding.severity, findings: [] };
    mark.findings.push(finding);
    if (finding.severity === 'error') mark.severity = 'error';
    places.set(place, mark);
  }
  return [...places.values()].sort((a, b) => a.share - b.share);
}

/** What the head of the page says of a program. */
export type Verdict = 'clean' | 'findings' | 'stale' | 'checking' | 'nothing';

export function verdict_of(now: {
  has_program: boolean;
  problems: number;
  is_stale: boolean;
  /** Text, run and part are looked at to their ends. */
  is_done: boolean;
}): Verdict {
  if (!now.has_program) return now.problems ? 'findings' : 'nothing';
  if (now.is_stale) return 'stale';
  if (now.problems) return 'findings';
  return now.is_done ? 'clean' : 'checking';
}
