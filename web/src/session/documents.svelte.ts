/** The program texts that are open: the one to be edited, and those that the machine runs besides. */
import { line_end_name, line_ends_of } from '../logic/line_ends';
import { text_fits } from '../logic/message_size';
import { MDI_ENTRY, type Diagnostic, type ProgramEntry } from '../logic/protocol';
import {
  type Decoded,
  decoded,
  ENCODING_NAMES,
  type Encoding,
  REPLACEMENT,
} from '../logic/text_bytes';
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
  /** How the bytes of the library's file were read; saving writes UTF-8. */
  read_as: Encoding;
}

/** Left out: the text is too long for the check, or the server has not answered. */
export type CheckState = 'under-way' | 'done' | 'left-out';

class Documents {
  open = $state.raw<TextDocument[]>([]);
  current = $state('');
  programs = $state.raw<ProgramEntry[]>([]);
  /** What the check of the text on the screen has found. */
  checked = $state.raw<Diagnostic[]>([]);
  check_state = $state<CheckState>('under-way');
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

  begin_check(): void {
    this.checked = [];
    this.check_state = 'under-way';
  }

  /** Null: it was not checked. */
  take_check(found: Diagnostic[] | null): void {
    this.checked = found ?? [];
    this.check_state = found ? 'done' : 'left-out';
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
    const found =
      revision === undefined ? await this.fetched(name) : await this.asked(name, revision);
    if (!found) return false;
    const { text, read_as } = found;
    const known = this.open.find((d) => d.name === name);
    this.put({
      name,
      text,
      saved: revision === undefined ? text : (known?.saved ?? null),
      loaded: known?.loaded ?? null,
      read_as,
    });
    this.show(name);
    tell_reading(name, found);
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
    if (await this.put_what_runs(file)) this.show(file);
  }

  /** A file that the machine executes and that is not open yet. */
  async follow(file: string): Promise<void> {
    if (!this.open.some((d) => d.name === file) && !(await this.put_what_runs(file))) return;
    if (this.current !== file) this.show(file);
  }

  async load_text(): Promise<void> {
    const document = this.document;
    if (!document) return;
    const { name, text } = document;
    if (!text_fits(text)) return this.load_by_name(document);
    if (!(await panel.act('load', { text, name }))) return;
    this.mark_loaded(name, text);
    notices.say(t('notice.loaded', { name }));
  }

  /** A text that does not fit into a command: the machine reads it in the library, so it is saved before. */
  private async load_by_name({ name, text, saved }: TextDocument): Promise<void> {
    if (saved !== text && !(await this.write(name, text))) return;
    if (!(await panel.act('load', { program: name }))) return;
    this.mark_loaded(name, text);
    notices.say(t(saved === text ? 'notice.loaded' : 'notice.saved-and-loaded', { name }));
  }

  async save(): Promise<void> {
    const document = this.document;
    if (!document) return;
    const { name, text } = document;
    if (!(await this.write(name, text))) return;
    notices.say(t('notice.saved', { name }));
    if (panel.operates && !panel.moves && document.loaded !== null && document.loaded !== text) {
      if (await panel.act('load', { program: name })) this.mark_loaded(name, text);
    }
  }

  async create(name: string, text: string): Promise<void> {
    if (await this.write(name, text)) await this.open_and_load(name);
  }

  /** Into the library. The names of those that it has taken. */
  async upload(files: Iterable<File>): Promise<string[]> {
    const kept: string[] = [];
    for (const file of files) {
      if (!(await put_file(file.name, file))) continue;
      kept.push(file.name);
      notices.say(t('notice.uploaded', { name: file.name }));
    }
    await this.refresh();
    return kept;
  }

  /** The text of the machine, as teaching writes it. */
  taught(name: string, text: string, line: number): void {
    const known = this.open.find((d) => d.name === name);
    const { saved, loaded } = known ?? { saved: null, loaded: null };
    this.put({ name, text, saved, loaded, read_as: 'utf-8' });
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

  /** Saves a text, a long one by HTTP; both make a revision. False: it was refused. */
  private async write(name: string, text: string): Promise<boolean> {
    const is_kept = text_fits(text)
      ? (await panel.act('write', { name, text })) !== null
      : await put_file(name, text);
    if (!is_kept) return false;
    this.change(name, { saved: text, read_as: 'utf-8' });
    await this.refresh();
    return true;
  }

  /** By HTTP: however long it is, it does not stand before what the machine says. */
  private async fetched(name: string): Promise<Decoded | null> {
    const answer = await fetch(library_address(name)).catch(() => null);
    if (answer?.ok) return decoded(new Uint8Array(await answer.arrayBuffer()));
    notices.say((await answer?.text()) || t('connection.refused'), 'refused');
    return null;
  }

  private async asked(name: string, revision: number): Promise<Decoded | null> {
    const answer = await panel.act('read', { name, revision });
    return answer ? { text: String(answer.text), read_as: 'utf-8' } : null;
  }

  private async text_of(name: string): Promise<Decoded | null> {
    if (name === MDI_ENTRY) return null;
    const answer = await panel.ask('read', { name, machine: panel.machine }).catch(() => null);
    const text = answer ? String(answer.text) : null;
    // Too long for an answer, or not UTF-8: its bytes come by HTTP.
    if (text === null || text.includes(REPLACEMENT)) return this.fetched(name);
    return { text, read_as: 'utf-8' };
  }

  private async put_what_runs(name: string): Promise<boolean> {
    const found = await this.text_of(name);
    if (!found) return false;
    this.put({ name, saved: found.text, loaded: found.text, ...found });
    tell_reading(name, found);
    return true;
  }

  private mark_loaded(name: string, text?: string): void {
    this.open = this.open.map((d) =>
      d.name === name ? { ...d, loaded: text ?? d.text } : { ...d, loaded: null },
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

/** Into the library as it is, byte by byte. False: refused, and the sentence is told. */
async function put_file(name: string, body: File | string): Promise<boolean> {
  const answer = await fetch(library_address(name), { method: 'PUT', body }).catch(() => null);
  if (answer?.ok) return true;
  notices.say((await answer?.text()) || t('connection.refused'), 'refused');
  return false;
}

/** What saving would change in a file beside what is edited. */
function tell_reading(name: string, { text, read_as }: Decoded): void {
  const { end, is_mixed } = line_ends_of(text);
  const encoding = ENCODING_NAMES[read_as];
  if (read_as !== 'utf-8') notices.say(t('notice.read-as', { name, encoding }), 'refused');
  else if (text.includes(REPLACEMENT)) notices.say(t('notice.damaged', { name }), 'refused');
  if (is_mixed) notices.say(t('notice.mixed-ends', { name, end: line_end_name(end) }), 'refused');
}

const library_address = (name: string): string =>
  `library/${encodeURIComponent(name)}${location.search}`;

export const documents = new Documents();
