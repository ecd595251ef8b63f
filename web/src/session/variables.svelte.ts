/** The variables that the tab shows: asked again when the machine says that some may have changed, at most four times a second. */
import type { Variable } from '../logic/protocol';
import { panel } from './panel.svelte';
import { preferences } from './preferences.svelte';

const MOST_OFTEN_MS = 250;

export type Scope = 'local' | 'common' | 'permanent' | 'program';

class Variables {
  scope = $state<Scope | 'all'>('all');
  /** Of the call stack, 0: main; null: the innermost. */
  level = $state<number | null>(null);
  list = $state.raw<Variable[]>([]);
  watched = $state.raw<Variable[]>([]);
  scopes = $state.raw<Scope[]>([]);
  levels = $state(1);
  /** A name as the program's language writes it. */
  example = $derived(this.scopes.includes('program') ? 'X' : '#500');
  private timer: ReturnType<typeof setTimeout> | null = null;
  private asked_at = 0;

  /** Asks soon. */
  refresh(): void {
    if (this.timer !== null) return;
    const wait = Math.max(0, this.asked_at + MOST_OFTEN_MS - performance.now());
    this.timer = setTimeout(() => {
      this.timer = null;
      this.asked_at = performance.now();
      void this.ask();
    }, wait);
  }

  async set(variable: Variable, value: number | null): Promise<void> {
    const { name, value: before, level } = variable;
    const write = async (to: number | null) => {
      const args = level === null ? { name, value: to } : { name, value: to, level };
      if (!(await panel.act('set-variable', args))) throw new Error('refused');
      this.refresh();
    };
    await panel.edits
      .perform({ what: name, undo: () => write(before), redo: () => write(value) })
      .catch(() => null);
  }

  /** Among those that are watched, or no longer. */
  watch(name: string, is_watched: boolean): void {
    const others = preferences.watches.filter((watched) => watched !== name);
    preferences.watches = is_watched ? [...others, name] : others;
    this.refresh();
  }

  private async ask(): Promise<void> {
    const args = this.level === null ? {} : { level: this.level };
    const answer = await panel.ask('variables', args).catch(() => null);
    if (!answer) return;
    this.list = answer.variables as Variable[];
    this.scopes = (answer.scopes as Scope[] | undefined) ?? [];
    this.levels = Number(answer.levels ?? panel.state.stack.length) || 1;
    await this.ask_watched();
  }

  private async ask_watched(): Promise<void> {
    const names = preferences.watches;
    if (names.length === 0) {
      this.watched = [];
      return;
    }
    const answer = await panel.ask('variables', { names: [...names] }).catch(() => null);
    this.watched = (answer?.variables as Variable[] | undefined) ?? [];
  }
}

export const variables = new Variables();
