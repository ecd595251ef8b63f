/** Exercises of the training mode, and what a program of one is worth. */
import { fixed } from './format';
import type { Language, TextKey } from './i18n';
import { alarm_words } from './i18n/alarms';
import type { MachineEntry } from './protocol';

export const KINDS = ['ends', 'all', 'only', 'rapids', 'checks', 'time', 'lines'] as const;

export interface Exercise {
  name: string;
  title: Record<Language, string>;
  task: Record<Language, string>;
  machine: string;
  file: string;
  start: string;
  /** What is on the table and in the magazine, of an exercise that is judged by its part. */
  set_up: string | null;
  zero_mm: number[];
}

export interface Criterion {
  kind: (typeof KINDS)[number];
  points: number;
  most: number;
  met: boolean;
  finding: string;
  sentence: string;
  values: Record<string, number>;
  code: string;
  message: string;
  file: string;
  line: number;
}

export interface Assessment {
  score: number;
  criteria: Criterion[];
}

/** The machine to exercise on: the one on the screen, or else one that nobody else has. Null: none fits. */
export function fitting_machine(
  machines: readonly MachineEntry[],
  definition: string,
  current: string,
  me: string,
): string | null {
  const fit = machines.filter(
    ({ definition: kind, operator }) => kind === definition && (operator ?? me) === me,
  );
  const found = fit.find((machine) => machine.name === current) ?? fit[0];
  return found?.name ?? null;
}

/** What a new machine to exercise on is called. */
export function free_name(machines: readonly MachineEntry[], definition: string): string {
  const taken = new Set(machines.map((machine) => machine.name));
  const name = `training-${definition}`;
  if (!taken.has(name)) return name;
  let number = 2;
  while (taken.has(`${name}-${number}`)) number++;
  return `${name}-${number}`;
}

/** Which text says what was found of a criterion, with its values as words. */
export function words_of(
  criterion: Criterion,
  language: Language,
): { key: TextKey; values: Record<string, string> } {
  const values: Record<string, string> = {};
  for (const [name, value] of Object.entries(criterion.values)) {
    const decimals = name.endsWith('_s') ? 1 : 3;
    values[name] = decimals === 1 ? fixed(value, 1) : fixed(value, 3).replace(/\.?0+$/, '');
  }
  values.place = ['x', 'y', 'z']
    .filter((axis) => axis in values)
    .map((axis) => axis.toUpperCase() + values[axis])
    .join(' ');
  values.code = criterion.code;
  values.message = alarm_words(language, { ...criterion, cause: '', remedy: '' }).message;
  const key = criterion.met ? `fulfilled.${criterion.kind}` : `finding.${criterion.finding}`;
  return { key: key as TextKey, values };
}

/** With the score of another try: the best one stays. */
export function with_score(
  scores: Readonly<Record<string, number>>,
  exercise: string,
  score: number,
): Record<string, number> {
  return { ...scores, [exercise]: Math.max(score, scores[exercise] ?? 0) };
}
