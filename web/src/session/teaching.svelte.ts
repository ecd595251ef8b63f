/** The taught program while it grows; its text is the machine's, the editor shows it. */
import type { Answer } from '../logic/connection';
import type { CaptureKind } from '../logic/protocol';
import { documents } from './documents.svelte';
import { panel } from './panel.svelte';

class Teaching {
  /** Its name in the editor; empty: nothing has been taught yet. */
  name = $state('');

  capture = async (kind: CaptureKind): Promise<void> =>
    this.take(await panel.act('teach-capture', { kind }));
  record = async (record: string): Promise<void> =>
    this.take(await panel.act('teach-record', { text: record }));
  take_back = async (): Promise<void> => this.take(await panel.act('teach-back'));

  begin = async (): Promise<void> => this.take(await panel.act('teach-new'));

  /** What was taught becomes the program of the machine, ready for cycle start. */
  async load(): Promise<void> {
    documents.show(this.name);
    await documents.load_text();
    await panel.set_mode('auto');
  }

  private take(answer: Answer | null): void {
    if (!answer) return;
    this.name = 'taught.tch';
    documents.taught(this.name, String(answer.text), Number(answer.line));
  }
}

export const teaching = new Teaching();
