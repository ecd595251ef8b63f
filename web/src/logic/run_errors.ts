/** Errors that only running finds, of the preview and of the machine itself, as diagnostics of the text that runs. */
import type { Alarm, Diagnostic } from './protocol';

export interface RunText {
  name: string;
  text: string;
  /** As the machine has it; null: not loaded. */
  loaded: string | null;
}

/** Only of a text that is the machine's: in an edited one the line may be another. */
export function run_errors(
  document: RunText | undefined,
  alarms: readonly (Alarm | null | undefined)[],
): Diagnostic[] {
  if (!document || document.loaded !== document.text) return [];
  const here = alarms.filter((alarm) => alarm?.file === document.name && alarm.line > 0);
  return without_repeats(here.map((alarm) => diagnostic_of(alarm!)));
}

/** What both the check and the run have found counts once. */
export const together = (checked: Diagnostic[], of_run: Diagnostic[]): Diagnostic[] =>
  without_repeats([...checked, ...of_run]);

function without_repeats(list: Diagnostic[]): Diagnostic[] {
  const same = (a: Diagnostic, b: Diagnostic) => a.code === b.code && a.line === b.line;
  return list.filter((one, i) => list.findIndex((other) => same(one, other)) === i);
}

function diagnostic_of(alarm: Alarm): Diagnostic {
  const { code, message, line, column, cause, remedy } = alarm;
  const { severity = 'error', length = 0 } = alarm;
  return { severity, code, message, line, column, length, cause, remedy };
}
