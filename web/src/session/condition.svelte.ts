/** The breakpoint whose condition is being written. */
import { at, with_condition } from '../logic/breakpoints';
import { dialogs } from './dialogs.svelte';
import { panel } from './panel.svelte';

class Condition {
  place = $state.raw({ file: '', line: 0 });
  text = $state('');

  edit(file: string, line: number): void {
    this.place = { file, line };
    this.text = at(panel.breakpoints, file, line)?.condition ?? '';
    dialogs.show('condition');
  }

  async take(): Promise<void> {
    const { file, line } = this.place;
    dialogs.close();
    await panel.set_breakpoints(with_condition(panel.breakpoints, file, line, this.text));
  }
}

export const condition = new Condition();
