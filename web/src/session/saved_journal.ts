/** What was done on the machine, saved as a file of this computer. */
import { panel } from './panel.svelte';

export async function save_journal(): Promise<void> {
  const answer = await panel.act('journal');
  if (!answer) return;
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([String(answer.text)], { type: 'application/json' }));
  link.download = String(answer.name);
  link.click();
  URL.revokeObjectURL(link.href);
}
