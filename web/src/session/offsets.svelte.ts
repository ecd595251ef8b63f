/** Work offsets and the tool table; changes can be taken back. */
import {
  type OffsetRow,
  type Tool,
  type WorkOffset,
  by_system,
  with_added,
  with_systems,
} from '../logic/offsets';
import { panel } from './panel.svelte';

export type ToolValue = Exclude<keyof Tool, 'number'>;

const MOST_OFTEN_MS = 400;

class Offsets {
  /** What the machine tells, and the rows that stand already: one that becomes all 0, or is to be filled in, stays. */
  work = $state.raw<WorkOffset[]>([]);
  tools = $state.raw<Tool[]>([]);
  /** Whose tables these are. */
  private machine = $state('');
  private timer: ReturnType<typeof setTimeout> | null = null;

  /** Those of the machine before are still shown while this is false. */
  get are_of_this_machine(): boolean {
    return this.machine === panel.machine;
  }

  refresh(): void {
    if (this.timer !== null) return;
    this.timer = setTimeout(() => {
      this.timer = null;
      void this.ask();
    }, MOST_OFTEN_MS);
  }

  set(offset: string, axis: string, value: number, before: number): Promise<void> {
    return this.change(`${offset} ${axis}`, { offset, axis }, value, before);
  }

  set_tool(number: number, key: ToolValue, value: number, before: number): Promise<void> {
    return this.change(`T${number} ${key}`, { offset: `tool.${number}.${key}` }, value, before);
  }

  /** A row for a system of which nothing is known yet. */
  add_system(name: string): void {
    this.work = with_systems(this.work, [name]);
  }

  /** A row for a tool of which nothing is known yet. */
  add_tool(number: number): void {
    this.tools = with_added(this.tools, [number]);
  }

  private async change(
    what: string,
    place: Record<string, unknown>,
    value: number,
    before: number,
  ): Promise<void> {
    const write = async (to: number) => {
      const answer = await panel.act('set-offset', { ...place, value: to });
      if (!answer) throw new Error('refused');
      await this.ask();
    };
    await panel.edits
      .perform({ what, undo: () => write(before), redo: () => write(value) })
      .catch(() => null);
  }

  private async ask(): Promise<void> {
    const { machine } = panel;
    const work = await panel.ask('offsets').catch(() => null);
    const tools = await panel.ask('tools').catch(() => null);
    if (!work || !tools || machine !== panel.machine) return;
    if (!this.are_of_this_machine) [this.work, this.tools] = [[], []];
    const systems = this.work.map(({ name }) => name);
    const numbers = this.tools.map(({ number }) => number);
    this.work = with_systems(by_system(work.offsets as OffsetRow[]), systems);
    this.tools = with_added(tools.tools as Tool[], numbers);
    this.machine = machine;
  }
}

export const offsets = new Offsets();
