/** The program texts that are open: the one to be edited, and those that the machine runs besides. */
import { MDI_ENTRY, type Diagnostic, type ProgramEntry } from '../logic/protocol';
import { notices } from './notices.svelte';
import { panel } from './panel.svelte';
import { t } from './words.svelte';

export interface TextDocument {
  name: string;
  text: string;
  /** As the library has it; null: not in the library. */
  saved: string | null;
  /** As the machine has it; null: not loaded. */
  loaded: string | null;
}

class Documents {
  open = $state.raw<TextDocument[]>([]);
  current = $state('');
  programs = $state.raw<ProgramEntry[]>([]);
  diagnostics = $state.raw<Diagnostic[]>([]);
  /** Changes when the text comes from elsewhere than the editor. */
  revision = $state(0);
  /** A place that the editor is to show. */
  goto = $state.raw<{ line: number; select: boolean; token: number } | null>(null);
  /** The line that the cursor is in. */
  cursor = $state(1);

  get document(): TextDocument | undefined {
    return this.open.find((d) => d.name === this.current);
  }
  get is_dirty(): boolean {
    const document = this.document;
    return document !== undefined && document.text !== (document.saved ?? document.loaded ?? '');
  }
  /** The machine would run another text than the one on the screen. */
  get is_ahead(): boolean {
    const document = this.document;
    return document !== undefined && document.loaded !== null && document.loaded !== document.text;
  }

  edited(text: string): void {
    this.change(this.current, { text });
  }

  show(name: string): void {
    this.current = name;
    this.revision++;
  }

  go_to(line: number, select = true): void {
    this.goto = { line, select, token: (this.goto?.token ?? 0) + 1 };
  }

  close(name: string): void {
    this.open = this.open.filter((d) => d.name !== name);
    if (this.current === name) this.show(this.open[0]?.name ?? '');
  }

  close_all(): void {
    this.open = [];
    this.show('');
  }

  async refresh(): Promise<void> {
    const answer = await panel.act('programs');
    if (answer) this.programs = answer.programs as ProgramEntry[];
  }

  /** Opens a program of the library without loading it. */
  async read(name: string, revision?: number): Promise<boolean> {
    const text =
      revision === undefined ? await this.fetched(name) : await this.asked(name, revision);
    if (text === null) return false;
    const known = this.open.find((d) => d.name === name);
    this.put({
      name,
      text,
      saved: revision === undefined ? text : (known?.saved ?? null),
      loaded: known?.loaded ?? null,
    });
    this.show(name);
    return true;
  }

  /** Opens a program of the library and loads it into the machine, which need not wait for the text. */
  async open_and_load(name: string): Promise<void> {
    const [is_read, loaded] = await Promise.all([
      this.read(name),
      panel.act('load', { program: name }),
    ]);
    if (is_read && loaded) this.mark_loaded(name);
  }

  /** What the machine has loaded, when the page comes to it. */
  async show_what_is_loaded(): Promise<void> {
    const { file } = panel.state;
    if (!file || this.open.some((d) => d.name === file)) return;
    const text = await this.text_of(file);
    if (text === null) return;
    this.put({ name: file, text, saved: text, loaded: text });
    this.show(file);
  }

  /** A file that the machine executes and that is not open yet. */
  async follow(file: string): Promise<void> {
    if (!this.open.some((d) => d.name === file)) {
      const text = await this.text_of(file);
      if (text === null) return;
      this.put({ name: file, text, saved: text, loaded: text });
    }
    if (this.current !== file) this.show(file);
  }

  async load_text(): Promise<void> {
    const document = this.document;
    if (!document) return;
    const { name, text } = document;
    if (!(await panel.act('load', { text, name }))) return;
    this.mark_loaded(name);
    notices.say(t('notice.loaded', { name }));
  }

  async save(): Promise<void> {
    const document = this.document;
    if (!document) return;
    const { name, text } = document;
    if (!(await panel.act('write', { name, text }))) return;
    this.change(name, { saved: text });
    notices.say(t('notice.saved', { name }));
    if (panel.operates && !panel.moves && document.loaded !== null && document.loaded !== text) {
      if (await panel.act('load', { program: name })) this.mark_loaded(name);
    }
    await this.refresh();
  }

  async create(name: string, text: string): Promise<void> {
    if (!(await panel.act('write', { name, text }))) return;
    await this.refresh();
    await this.open_and_load(name);
  }

  async upload(files: Iterable<File>): Promise<void> {
    for (const file of files) {
      const wish = { method: 'PUT', body: file };
      const answer = await fetch(library_address(file.name), wish).catch(() => null);
      if (answer?.ok) notices.say(t('notice.uploaded', { name: file.name }));
      else notices.say((await answer?.text()) || t('connection.refused'), 'refused');
    }
    await this.refresh();
  }

  /** The text of the machine, as teaching writes it. */
  taught(name: string, text: string, line: number): void {
    const known = this.open.find((d) => d.name === name);
    this.put({ name, text, saved: known?.saved ?? null, loaded: known?.loaded ?? null });
    this.show(name);
    this.go_to(line);
  }

  /** Another text for the program on the screen; nothing is saved. */
  replace(text: string): void {
    this.edited(text);
    this.revision++;
  }

  renamed(from: string, to: string): void {
    this.open = this.open.map((d) => (d.name === from ? { ...d, name: to } : d));
    if (this.current === from) this.current = to;
  }

  /** By HTTP: however long it is, it does not stand before what the machine says. */
  private async fetched(name: string): Promise<string | null> {
    const answer = await fetch(library_address(name)).catch(() => null);
    if (answer?.ok) return answer.text();
    notices.say((await answer?.text()) || t('connection.refused'), 'refused');
    return null;
  }

  private async asked(name: string, revision: number): Promise<string | null> {
    const answer = await panel.act('read', { name, revision });
    return answer ? String(answer.text) : null;
  }

  private async text_of(name: string): Promise<string | null> {
    if (name === MDI_ENTRY) return null;
    const answer = await panel.ask('read', { name, machine: panel.machine }).catch(() => null);
    return answer ? String(answer.text) : this.fetched(name); // too long for an answer
  }

  private mark_loaded(name: string): void {
    this.open = this.open.map((d) =>
      d.name === name ? { ...d, loaded: d.text } : { ...d, loaded: null },
    );
  }

  private put(document: TextDocument): void {
    const others = this.open.filter((d) => d.name !== document.name);
    this.open = [...others, document].slice(-8);
  }

  private change(name: string, change: Partial<TextDocument>): void {
    this.open = this.open.map((d) => (d.name === name ? { ...d, ...change } : d));
  }
}

const library_address = (name: string): string =>
  `library/${encodeURIComponent(name)}${location.search}`;

export const documents = new Documents();
