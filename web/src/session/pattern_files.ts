/** Patterns into the library, which has their bytes: the server makes them of the listing. */
import { text_fits } from '../logic/message_size';
import { notices } from './notices.svelte';
import { panel } from './panel.svelte';
import { t } from './words.svelte';

/** The listing as it is kept: bytes hold records, and neither comments nor blank lines. Null: refused, and told. */
export async function put_listing(name: string, text: string): Promise<string | null> {
  if (!text_fits(text)) {
    notices.say(t('notice.pattern-too-long', { name }), 'refused');
    return null;
  }
  const answer = await panel.act('write', { name, text });
  if (!answer) return null;
  const kept = String(answer.text);
  if (kept !== text) notices.say(t('notice.records-kept', { name }));
  return kept;
}
