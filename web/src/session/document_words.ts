/** What is asked and told about the texts of programs. */
import { line_end_name, line_ends_of } from '../logic/line_ends';
import {
  type Decoded,
  ENCODING_NAMES,
  type Encoding,
  is_kept,
  REPLACEMENT,
} from '../logic/text_bytes';
import { notices } from './notices.svelte';
import { question } from './question.svelte';
import { t } from './words.svelte';

/** Null: it stays open. */
export const ask_before_closing = (name: string): Promise<string | null> =>
  question.ask(t('program.close-edited', { name }), t('program.close-why'), [
    { answer: 'discard', label: t('program.discard'), tone: 'danger' },
    { answer: 'save', label: t('program.save'), tone: 'main' },
  ]);

/** False: nothing is written. */
export function refuse_character(character: string, encoding: Encoding): false {
  const name = ENCODING_NAMES[encoding];
  notices.say(t('notice.not-in', { character, encoding: name }), 'refused');
  return false;
}

/** What saving would change in a file beside what is edited. */
export function tell_reading(name: string, { text, read_as }: Decoded): void {
  const { end, is_mixed } = line_ends_of(text);
  const encoding = ENCODING_NAMES[read_as];
  if (!is_kept(read_as)) notices.say(t('notice.read-as-wide', { name, encoding }), 'refused');
  else if (read_as !== 'utf-8') notices.say(t('notice.read-as', { name, encoding }), 'refused');
  else if (text.includes(REPLACEMENT)) notices.say(t('notice.damaged', { name }), 'refused');
  if (is_mixed) notices.say(t('notice.mixed-ends', { name, end: line_end_name(end) }), 'refused');
}
