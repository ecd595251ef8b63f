/** Taking edits of tables back and doing them again, and the word about it. Why a machine refuses was told by `panel.act`. */
import { notices } from './notices.svelte';
import { panel } from './panel.svelte';
import { t } from './words.svelte';

export async function take_back(): Promise<void> {
  const what = await panel.edits.undo().catch(() => null);
  if (what) notices.say(t('notice.undone', { what }));
}

export async function do_again(): Promise<void> {
  const what = await panel.edits.redo().catch(() => null);
  if (what) notices.say(t('notice.redone', { what }));
}
