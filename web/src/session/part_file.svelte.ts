/** The part as a file: the server cuts it with the cells that its tools ask for, and keeps it in the library. */
import { documents } from './documents.svelte';
import { address } from './library_files';
import { notices } from './notices.svelte';
import { panel } from './panel.svelte';
import { t } from './words.svelte';

export type PartFormat = 'stl' | 'glb' | '3mf' | 'kstock';
/** With their names. */
export const PART_FORMATS: [PartFormat, string][] = [
  ['stl', 'STL'],
  ['glb', 'glTF'],
  ['3mf', '3MF'],
  ['kstock', 'KSTOCK'],
];

class PartFile {
  /** It is being cut. */
  is_busy = $state(false);

  /** Tells a refusal by itself. */
  async keep(format: PartFormat): Promise<void> {
    if (this.is_busy) return;
    this.is_busy = true;
    const answer = await panel
      .act('stock_export', { format })
      .finally(() => (this.is_busy = false));
    if (!answer) return;
    const name = String(answer.name);
    notices.say(t('part.kept', { name }));
    await documents.refresh();
    // What a set-up begins from stays in the library; the others are for other programs.
    if (format !== 'kstock') fetch_file(name);
  }
}

function fetch_file(name: string): void {
  const link = document.createElement('a');
  link.href = address(name);
  link.download = name;
  link.click();
}

export const part_file = new PartFile();
