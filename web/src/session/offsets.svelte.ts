/** Work offsets and the tool table; changes can be taken back. */
import {
  type OffsetRow,
  type Tool,
  type WorkOffset,
  by_system,
  with_added,
} from '../logic/offsets';
import { panel } from './panel.svelte';

export type ToolValue = Exclude<keyof Tool, 'number'>;

const MOST_OFTEN_MS = 400;

class Offsets {
  work = $state.raw<WorkOffset[]>([]);
  /** Those that the machine tells, and the rows that stand already: one that becomes all 0, or is to be filled in, stays. */
  tools = $state.raw<Tool[]>([]);
  private machine = '';
  private timer: ReturnType<typeof setTimeout> | null = null;

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
    if (machine !== panel.machine) return;
    const rows = machine === this.machine ? this.tools.map((tool) => tool.number) : [];
    if (work) this.work = by_system(work.offsets as OffsetRow[]);
    if (tools) this.tools = with_added(tools.tools as Tool[], rows);
    if (tools) this.machine = machine;
  }
}

export const offsets = new Offsets();
