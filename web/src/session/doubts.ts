/** Asks about an entry that looks like a slip of the finger, before the machine gets it. */
import { type Doubt, doubt_of } from '../logic/entry';
import { position } from '../logic/format';
import { preferences } from './preferences.svelte';
import { question } from './question.svelte';
import { t } from './words.svelte';

/** Whether the operator means it. `most`: as long as this can be at most, null: no limit is known. */
export async function is_meant(
  what: string,
  value: number,
  before: number,
  most: number | null,
): Promise<boolean> {
  const doubt = doubt_of(value, before, most, preferences.ask_above);
  if (!doubt) return true;
  const why = reason_of(doubt);
  const change = t('entry.change', { before: position(before), value: position(value) });
  const answer = await question.ask(what, `${change}\n${why}`, [
    { answer: 'set', label: t('entry.set', { value: position(value) }), tone: 'danger' },
  ]);
  return answer === 'set';
}

const reason_of = (doubt: Doubt): string =>
  doubt.kind === 'beyond'
    ? t('entry.beyond', { most: position(doubt.most) })
    : t('entry.far', { by: position(doubt.by), step: preferences.ask_above });
