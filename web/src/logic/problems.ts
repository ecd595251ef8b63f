/**
 * All that is known to be wrong with a program: what shows in its text, what its preview has met, what the part
 * has met, and the machine's alarm.
 */
import type { Alarm, Diagnostic, PathEvent } from './protocol';
import type { Finding } from './stock/part_store';

/** Who has found it. */
export type ProblemSource = 'text' | 'run' | 'machine' | 'part';

export interface Problem {
  source: ProblemSource;
  severity: Diagnostic['severity'];
  code: string;
  message: string;
  file: string;
  line: number;
  column: number;
  cause: string;
  remedy: string;
  /** The control stops here: what the run has met behind it, no machine would have come to. */
  stops: boolean;
  /** Of the part: the instant and the place besides. */
  finding?: Finding;
}

export interface ProblemSources {
  /** Of the text on the screen. */
  checked: { file: string; found: readonly Diagnostic[] };
  path: Pick<PathEvent, 'findings' | 'error'> | null;
  alarm: Alarm | null;
  /** Of the part. */
  part?: readonly Finding[];
  /** Files whose text is no longer the machine's: their lines of the run may be others by now. */
  edited: ReadonlySet<string>;
}

/** Each code once a line, by file and line; files in the order in which they are met. */
export function problems_of({ checked, path, alarm, part, edited }: ProblemSources): Problem[] {
  const list: Problem[] = checked.found.map((one) => of_text(one, checked.file));
  const met = path ? of_path(path) : [];
  met.forEach((one, i) => {
    const stops = i === 0 && path?.error?.severity !== 'warning' && !!path?.error;
    if (!edited.has(one.file)) put(list, of_alarm(one, 'run', stops));
  });
  if (alarm && !edited.has(alarm.file)) put(list, of_alarm(alarm, 'machine', true));
  for (const finding of part ?? [])
    if (!edited.has(finding.file)) put(list, { ...of_alarm(finding, 'part', false), finding });
  const files = [...new Set(list.map(({ file }) => file))];
  return list.sort((a, b) => files.indexOf(a.file) - files.indexOf(b.file) || a.line - b.line);
}

/** The problem behind (1) or before (-1) a line, around the end; null: there are none. */
export function problem_beside(
  list: readonly Problem[],
  file: string,
  line: number,
  way: 1 | -1,
): Problem | null {
  const placed = list.filter((one) => one.line > 0);
  if (!placed.length) return null;
  const ordered = way > 0 ? placed : [...placed].reverse();
  const here = ordered.filter((one) => one.file === file);
  return here.find((one) => way * (one.line - line) > 0) ?? behind(here, ordered);
}

/** Behind the last one of a file comes the first of the next file. */
function behind(here: readonly Problem[], ordered: readonly Problem[]): Problem {
  const last = here.length ? ordered.indexOf(here[here.length - 1]) : -1;
  return ordered[(last + 1) % ordered.length];
}

export const count_errors = (list: readonly Problem[]): number =>
  list.filter((one) => one.severity === 'error').length;

/** A server's fault has no findings, and an error all the same. */
function of_path({ findings, error }: NonNullable<ProblemSources['path']>): readonly Alarm[] {
  if (findings.length) return findings;
  return error ? [error] : [];
}

/** The same mistake found twice is one; that the control stops there stays known. */
function put(list: Problem[], problem: Problem): void {
  const same = list.find(
    (known) =>
      known.code === problem.code && known.line === problem.line && known.file === problem.file,
  );
  if (same) {
    same.stops ||= problem.stops;
    same.finding ??= problem.finding;
  } else list.push(problem);
}

const of_text = (found: Diagnostic, file: string): Problem =>
  of_alarm({ ...found, file }, 'text', false);

function of_alarm(alarm: Alarm, source: ProblemSource, stops: boolean): Problem {
  const { severity = 'error', code, message, file, line, column, cause, remedy } = alarm;
  return { source, severity, code, message, file, line, column, cause, remedy, stops };
}
