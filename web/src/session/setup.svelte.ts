/** The set-up of the loaded program: as the server keeps it, and as it is being changed in the forms. */
import { Refusal } from '../logic/connection';
import { EMPTY_SETUP, is_bad, read_setup, type Setup, written_setup } from '../logic/stock/setup';
import { type Wrong, wrong_in } from '../logic/stock/setup_rules';
import { notices } from './notices.svelte';
import { panel, said } from './panel.svelte';
import { t } from './words.svelte';

class SetupForms {
  /** As the server has it. */
  kept = $state.raw<Setup>(EMPTY_SETUP);
  is_default = $state(true);
  /** As the forms have it; null: nothing has been changed. */
  draft = $state.raw<Setup | null>(null);
  /** Why the server, or the text, is refused. */
  refused = $state('');
  private toml = $state('');
  private program = '';

  get shown(): Setup {
    return this.draft ?? this.kept;
  }
  get text(): string {
    return this.draft ? written_setup(this.draft) : this.toml;
  }
  get is_changed(): boolean {
    return this.draft !== null;
  }
  /** What cannot be, of all that the forms have. */
  wrong = $derived(wrong_in(this.shown));
  wrong_of(part: string): Wrong[] {
    return this.wrong.filter(({ field }) => field.split(' ')[0] === part);
  }
  is_wrong(field: string): boolean {
    return this.wrong.some((one) => one.field === field);
  }

  /** Asks for the set-up of the program that is loaded now. */
  async refresh(): Promise<void> {
    const { program, machine } = panel.state.program
      ? { ...panel.state, machine: panel.machine }
      : { program: '', machine: '' };
    const name = `${machine} ${program} ${panel.state.file}`;
    if (name !== this.program) {
      this.program = name;
      this.draft = null;
      this.refused = '';
    }
    const answer = program ? await panel.ask('stock', {}).catch(() => null) : null;
    this.take_kept(String(answer?.toml ?? ''), answer?.is_default !== false);
  }

  change(change: Partial<Setup>): void {
    this.draft = { ...this.shown, ...change };
    this.refused = '';
  }
  revert(): void {
    this.draft = null;
    this.refused = '';
  }

  /** A whole text instead of the forms; false: it is none. */
  change_text(toml: string): boolean {
    const read = read_setup(toml);
    if (is_bad(read)) {
      this.refused = t('setup.bad-line', { line: read.line, message: read.message });
      return false;
    }
    this.draft = read;
    this.refused = '';
    return true;
  }

  /** Gives it to the server, which keeps it with the program and cuts the part anew. */
  async take(): Promise<void> {
    const toml = this.text;
    try {
      const answer = await panel.ask('stock', { toml });
      this.take_kept(String(answer.toml ?? toml), answer.is_default === true);
      this.draft = null;
      this.refused = '';
      notices.say(t('setup.saved', { name: panel.state.file }));
    } catch (reason) {
      this.refused = reason instanceof Refusal ? said(reason) : String(reason);
    }
  }

  private take_kept(toml: string, is_default: boolean): void {
    const read = read_setup(toml);
    this.toml = toml;
    this.kept = is_bad(read) ? EMPTY_SETUP : read;
    this.is_default = is_default;
  }
}

export const setup = new SetupForms();
