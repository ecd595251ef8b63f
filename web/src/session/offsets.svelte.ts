/** Work offsets and the tool table; changes can be taken back. */
import {
  type OffsetRow,
  type Tool,
  type WorkOffset,
  by_system,
  empty_tool,
  with_added,
  with_systems,
} from '../logic/offsets';
import {
  type Nose,
  type TurningOffset,
  type TurningPart,
  empty_offset,
  nose_of,
} from '../logic/turning_offsets';
import { panel } from './panel.svelte';

export type ToolValue = Exclude<keyof Tool, 'number'>;

const MOST_OFTEN_MS = 400;

class Offsets {
  /** What the machine tells, and the rows that stand already: one that becomes all 0, or is to be filled in, stays. */
  work = $state.raw<WorkOffset[]>([]);
  tools = $state.raw<Tool[]>([]);
  /** Of lathes. */
  turning = $state.raw<TurningOffset[]>([]);
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

  set_tool(
    number: number,
    key: ToolValue | TurningPart,
    value: number,
    before: number,
  ): Promise<void> {
    return this.change(`T${number} ${key}`, { offset: `tool.${number}.${key}` }, value, before);
  }

  /** The geometry becomes the one with which the axis reads `reads` where it stands. */
  measure(number: number, axis: string, reads: number): Promise<void> {
    const part = `geometry_${axis.toLowerCase()}` as TurningPart;
    const set = (value: number) =>
      this.write('set-offset', { offset: `tool.${number}.${part}`, value });
    const before = this.row(number)[part];
    // Done again it is the same value, wherever the tool stands then.
    let measured: number | null = null;
    const redo = async () => {
      if (measured !== null) return set(measured);
      await this.write('measure-offset', { number, axis, reads });
      measured = this.row(number)[part];
    };
    return this.perform(`T${number} ${axis}`, redo, () => set(before));
  }

  nose(number: number): Nose {
    return nose_of(this.row(number));
  }

  private row(number: number): TurningOffset {
    return this.turning.find((row) => row.number === number) ?? empty_offset(number);
  }

  /** A row for a system of which nothing is known yet. */
  add_system(name: string): void {
    this.work = with_systems(this.work, [name]);
  }

  /** A row for a tool of which nothing is known yet. */
  add_tool(number: number): void {
    if (panel.definition?.lathe) this.turning = with_added(this.turning, [number], empty_offset);
    else this.tools = with_added(this.tools, [number], empty_tool);
  }

  private change(
    what: string,
    place: Record<string, unknown>,
    value: number,
    before: number,
  ): Promise<void> {
    const write = (to: number) => this.write('set-offset', { ...place, value: to });
    return this.perform(
      what,
      () => write(value),
      () => write(before),
    );
  }

  private async perform(
    what: string,
    redo: () => Promise<void>,
    undo: () => Promise<void>,
  ): Promise<void> {
    await panel.edits.perform({ what, undo, redo }).catch(() => null);
  }

  private async write(command: string, words: Record<string, unknown>): Promise<void> {
    if (!(await panel.act(command, words))) throw new Error('refused');
    await this.ask();
  }

  private async ask(): Promise<void> {
    const { machine } = panel;
    const work = await panel.ask('offsets').catch(() => null);
    const tools = await panel.ask('tools').catch(() => null);
    if (!work || !tools || machine !== panel.machine) return;
    if (!this.are_of_this_machine) [this.work, this.tools, this.turning] = [[], [], []];
    const systems = this.work.map(({ name }) => name);
    this.work = with_systems(by_system(work.offsets as OffsetRow[]), systems);
    this.take_tools(tools.tools);
    this.machine = machine;
  }

  /** Rows that stand already stay. */
  private take_tools(told: unknown): void {
    const numbers = (rows: { number: number }[]) => rows.map(({ number }) => number);
    if (panel.definition?.lathe)
      this.turning = with_added(told as TurningOffset[], numbers(this.turning), empty_offset);
    else this.tools = with_added(told as Tool[], numbers(this.tools), empty_tool);
  }
}

export const offsets = new Offsets();
