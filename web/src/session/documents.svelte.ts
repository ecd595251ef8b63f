/** The program texts that are open: the one to be edited, and those that the machine runs besides. */
import { moved } from '../logic/breakpoints';
import { is_listing } from '../logic/dialects';
import { DatabaseDrafts, DraftKeeper, type Draft } from '../logic/drafts';
import { type LineMap, line_map } from '../logic/line_map';
import { text_fits } from '../logic/message_size';
import { MDI_ENTRY, type Breakpoint, type ProgramEntry } from '../logic/protocol';
import {
  type Decoded,
  encoded,
  ENCODING_NAMES,
  type Encoding,
  is_kept,
  is_text,
  read,
  REPLACEMENT,
} from '../logic/text_bytes';
import { ask_before_closing, refuse_character, tell_reading } from './document_words';
import { languages } from './languages.svelte';
import { get_bytes, get_text, put_file } from './library_files';
import { notices } from './notices.svelte';
import { put_listing } from './pattern_files';
import { panel } from './panel.svelte';
import { upload } from './uploads';
import { t } from './words.svelte';

export interface TextDocument {
  name: string;
  text: string;
  /** As the library has it; null: not in the library. */
  saved: string | null;
  /** As the machine has it; null: not loaded. */
  loaded: string | null;
  /** How the bytes of the library's file were read; saving writes them so, too. */
  read_as: Encoding;
  /** An earlier edit that was not saved: it is restored or discarded before the text can be edited. */
  draft?: Draft | null;
}

/** The text that the machine executes, or would, if a program calls it. */
const machine_text = ({ loaded, saved, text }: TextDocument): string => loaded ?? saved ?? text;
export const is_edited = ({ text, saved, loaded }: TextDocument): boolean =>
  text !== (saved ?? loaded ?? '');

const drafts = new DraftKeeper(new DatabaseDrafts());

class Documents {
  open = $state.raw<TextDocument[]>([]);
  current = $state('');
  programs = $state.raw<ProgramEntry[]>([]);
  /** Changes when the text comes from elsewhere than the editor. */
  revision = $state(0);
  /** A place that the editor is to show. */
  goto = $state.raw<{ line: number; select: boolean; token: number } | null>(null);
  /** The line that the cursor is in. */
  cursor = $state(1);

  get document(): TextDocument | undefined {
    return this.named(this.current);
  }
  get is_dirty(): boolean {
    return this.document !== undefined && is_edited(this.document);
  }
  /** The machine would run another text than the one on the screen. */
  get is_ahead(): boolean {
    const document = this.document;
    return document !== undefined && document.loaded !== null && document.loaded !== document.text;
  }

  edited(text: string): void {
    this.change(this.current, { text });
    const { document } = this;
    if (!document) return;
    const { name } = document;
    drafts.keep(name, is_edited(document) ? { name, text, at: Date.now() } : null);
  }

  /** The page may be gone in a moment: every edit is in the drafts. */
  leave(): void {
    drafts.leave();
  }

  // Lines: those of the machine are of the text that it has, those on the screen of the text as it is edited.

  /** Null: the line is not there any more. */
  text_line(name: string, machine_line: number): number | null {
    return this.map_of(name)?.forth(machine_line) ?? (this.is_open(name) ? null : machine_line);
  }
  /** Null: the machine does not have this line. */
  machine_line(name: string, text_line: number): number | null {
    return this.map_of(name)?.back(text_line) ?? (this.is_open(name) ? null : text_line);
  }
  private is_open(name: string): boolean {
    return this.named(name) !== undefined;
  }
  private named(name: string): TextDocument | undefined {
    return this.open.find((d) => d.name === name);
  }
  private map_of(name: string): LineMap | undefined {
    const document = this.named(name);
    if (!document) return undefined;
    const first = machine_text(document);
    const known = this.maps.get(name);
    if (known?.first === first && known.second === document.text) return known.map;
    const map = line_map(first, document.text);
    this.maps.set(name, { first, second: document.text, map });
    return map;
  }
  private readonly maps = new Map<string, { first: string; second: string; map: LineMap }>();

  /** Where the breakpoints of a program stand on the screen. */
  breakpoints_of(name: string): Breakpoint[] {
    return moved(panel.breakpoints, name, (line) => this.text_line(name, line)).filter(
      (b) => b.file === name,
    );
  }

  /** A place of the text for the machine; null, and told: the machine does not have that line. */
  for_machine(line: number): number | null {
    const at = this.machine_line(this.current, line);
    if (at === null) notices.say(t('program.new-line', { line }), 'refused');
    return at;
  }

  /** To a line as the machine counts it. */
  go_to_machine_line(line: number, select = true): void {
    const at = this.text_line(this.current, line);
    if (at !== null) this.go_to(at, select);
  }

  show(name: string): void {
    this.current = name;
    this.revision++;
  }

  go_to(line: number, select = true): void {
    this.goto = { line, select, token: (this.goto?.token ?? 0) + 1 };
  }

  /** Asks where something would be lost. */
  async close(name: string): Promise<void> {
    const document = this.named(name);
    if (document && is_edited(document)) {
      const answer = await ask_before_closing(name);
      if (answer === null) return;
      if (answer === 'save' && !(await this.write(document))) return;
      drafts.keep(name, null);
    }
    this.open = this.open.filter((d) => d.name !== name);
    if (this.current === name) this.show(this.open[0]?.name ?? '');
  }

  /** What is edited stays as a draft. */
  close_all(): void {
    const names = this.open.filter(is_edited).map((d) => d.name);
    if (names.length) notices.say(t('program.drafts-kept', { names: names.join(', ') }));
    this.open = [];
    this.show('');
  }

  async refresh(): Promise<void> {
    const answer = await panel.act('programs');
    if (answer) this.programs = answer.programs as ProgramEntry[];
  }

  /** Opens a program of the library without loading it. */
  async read(
    name: string,
    revision?: number,
    begins?: (first: Uint8Array) => void,
  ): Promise<boolean> {
    const is_file = revision === undefined && !is_listing(languages.dialects, name);
    const found = is_file ? await get_text(name, begins) : await this.asked(name, revision);
    if (!found) return false;
    const known = this.named(name);
    const saved = revision === undefined ? found.text : (known?.saved ?? null);
    this.put({ name, ...found, saved, loaded: known?.loaded ?? null });
    this.show(name);
    tell_reading(name, found);
    await this.offer_draft(name);
    return true;
  }

  /**
   * Opens a program of the library and loads it into the machine, which need not wait for the whole text. One in UTF-16
   * is loaded as the text that it is, since no control reads such a file.
   */
  async open_and_load(name: string): Promise<void> {
    let loading: Promise<unknown> | null = null;
    const is_read = await this.read(name, undefined, (first) => {
      const is_read_by_machine = is_text(first) && !first.includes(0);
      if (is_read_by_machine) loading = panel.act('load', { program: name });
    });
    if (!is_read) return;
    const text = this.document?.saved ?? '';
    loading ??= panel.act(
      'load',
      is_listing(languages.dialects, name) ? { program: name } : { text, name },
    );
    if (await loading) this.mark_loaded(name, text);
  }

  private async offer_draft(name: string): Promise<void> {
    const draft = await drafts.of(name);
    const document = this.named(name);
    if (!draft || !document || is_edited(document)) return;
    if (draft.text === document.text) drafts.keep(name, null);
    else this.change(name, { draft });
  }

  /** The draft that is offered becomes the text, or goes. */
  answer_draft(is_wanted: boolean): void {
    const { document } = this;
    if (!document?.draft) return;
    const { name, draft } = document;
    this.change(name, { draft: null });
    if (is_wanted) this.replace(draft.text);
    else drafts.keep(name, null);
  }

  /** Reads the file as the operator says; a text that is edited is saved so. */
  async choose_encoding(encoding: Encoding): Promise<void> {
    const { document } = this;
    if (!document) return;
    const { name } = document;
    if (is_edited(document) || document.saved === null) {
      this.change(name, { read_as: encoding });
      notices.say(t('notice.will-write', { name, encoding: ENCODING_NAMES[encoding] }));
      return;
    }
    const bytes = await get_bytes(name);
    if (!bytes) return;
    const text = read(encoding, bytes);
    const loaded = document.loaded === document.saved ? text : document.loaded;
    this.change(name, { text, saved: text, loaded, read_as: encoding });
    this.revision++;
  }

  /** What the machine has loaded, when the page comes to it. */
  async show_what_is_loaded(): Promise<void> {
    const { file } = panel.state;
    if (!file) return;
    if (this.is_open(file)) return this.look_again();
    const { current } = this;
    // Whoever opens another program meanwhile wants to see that.
    if (!(await this.put_what_runs(file, () => this.current === current))) return;
    this.show(file);
    await this.offer_draft(file);
  }

  /** Somebody else may have given the machine another text of a program that is open here. What is edited here stays. */
  async look_again(): Promise<void> {
    const { file } = panel.state;
    const found = this.is_open(file) ? await this.text_of(file) : null;
    const known = this.named(file);
    if (!found || !known || found.text === known.loaded || file !== panel.state.file) return;
    const { text } = found;
    const is_own = is_edited(known);
    this.change(file, is_own ? { loaded: text } : { ...found, saved: text, loaded: text });
    this.mark_loaded(file, text);
    if (!is_own) this.revision++;
  }

  /** A file that the machine executes and that is not open yet. */
  async follow(file: string): Promise<void> {
    if (!this.is_open(file) && !(await this.put_what_runs(file))) return;
    if (this.current !== file) this.show(file);
  }

  /** The machine has another revision of a program of the library, which this page has not given it. */
  async take_loaded(name: string): Promise<void> {
    if (await this.read(name)) this.mark_loaded(name, this.document?.saved ?? '');
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
  private async load_by_name(document: TextDocument): Promise<void> {
    const { name, text, saved } = document;
    if (saved !== text && !(await this.write(document))) return;
    if (!(await panel.act('load', { program: name }))) return;
    this.mark_loaded(name, text);
    notices.say(t(saved === text ? 'notice.loaded' : 'notice.saved-and-loaded', { name }));
  }

  async save(): Promise<void> {
    const document = this.document;
    if (!document) return;
    const { name } = document;
    if (!(await this.write(document))) return;
    const text = this.document?.saved ?? document.text;
    notices.say(t('notice.saved', { name }));
    if (panel.operates && !panel.moves && document.loaded !== null && document.loaded !== text) {
      if (await panel.act('load', { program: name })) this.mark_loaded(name, text);
    }
  }

  async create(typed: string, text: string): Promise<void> {
    const name = typed.normalize('NFC');
    const fresh = { name, text, saved: null, loaded: null, read_as: 'utf-8' } as const;
    if (await this.write(fresh)) await this.open_and_load(name);
  }

  /** Into the library. The names of those that it has taken. */
  async upload(files: Iterable<File>): Promise<string[]> {
    const kept: string[] = [];
    await this.refresh();
    for (const file of files) {
      const name = await upload(file, this.programs);
      if (!name) continue;
      kept.push(name);
      await this.refresh();
    }
    return kept;
  }

  /** The text of the machine, as teaching writes it. */
  taught(name: string, text: string, line: number): void {
    const known = this.named(name);
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
    void drafts.of(from).then((draft) => {
      drafts.keep(from, null);
      if (draft) drafts.keep(to, { ...draft, name: to });
    });
  }

  /** Saves a text in its encoding, by HTTP where a command cannot carry it. False: it was refused, and told. */
  private async write({ name, text, read_as }: TextDocument): Promise<boolean> {
    if (is_listing(languages.dialects, name))
      return this.keep(name, text, await put_listing(name, text));
    const made = encoded(text, read_as);
    if ('missing' in made) return refuse_character(made.missing, read_as);
    const is_utf_8 = read_as === 'utf-8' || !is_kept(read_as);
    const is_written =
      is_utf_8 && text_fits(text)
        ? (await panel.act('write', { name, text })) !== null
        : await put_file(name, new Blob([made.bytes]));
    if (!is_written) return false;
    this.rebase(name, { read_as: is_utf_8 ? 'utf-8' : read_as });
    return this.keep(name, text, text);
  }

  /** The library has what it could keep of a text, null: nothing. Whoever has not edited on since sees that. */
  private async keep(name: string, text: string, saved: string | null): Promise<boolean> {
    if (saved === null) return false;
    this.rebase(name, { saved });
    if (saved !== text && this.named(name)?.text === text) {
      this.change(name, { text: saved });
      this.revision++;
    }
    drafts.keep(name, null);
    await this.refresh();
    return true;
  }

  private async asked(name: string, revision?: number): Promise<Decoded | null> {
    const answer = await panel.act('read', { name, revision });
    return answer ? { text: String(answer.text), read_as: 'utf-8' } : null;
  }

  private async text_of(name: string): Promise<Decoded | null> {
    if (name === MDI_ENTRY) return null;
    const answer = await panel.ask('read', { name, machine: panel.machine }).catch(() => null);
    const text = answer ? String(answer.text) : null;
    // Too long for an answer, or not UTF-8: its bytes come by HTTP.
    const is_whole = text !== null && !text.includes(REPLACEMENT) && !text.includes('\0');
    if (!is_whole && !is_listing(languages.dialects, name)) return get_text(name);
    if (text === null) return null;
    return { text, read_as: 'utf-8' };
  }

  private async put_what_runs(name: string, is_wanted = (): boolean => true): Promise<boolean> {
    const found = await this.text_of(name);
    if (!found || !is_wanted()) return false;
    this.put({ name, saved: found.text, loaded: found.text, ...found });
    tell_reading(name, found);
    return true;
  }

  private mark_loaded(name: string, text?: string): void {
    const document = this.named(name);
    this.rebase(name, { loaded: text ?? document?.text ?? null });
    this.open = this.open.map((d) => (d.name === name ? d : { ...d, loaded: null }));
  }

  /** The machine has another text of a program: its breakpoints move with their lines. */
  private rebase(name: string, change: Partial<TextDocument>): void {
    const before = this.named(name);
    this.change(name, change);
    const now = this.named(name);
    if (!before || !now || !panel.operates) return;
    const map = line_map(machine_text(before), machine_text(now));
    const list = moved(panel.breakpoints, name, map.forth);
    if (JSON.stringify(list) !== JSON.stringify(panel.breakpoints))
      void panel.set_breakpoints(list);
  }

  private put(document: TextDocument): void {
    const others = this.open.filter((d) => d.name !== document.name);
    this.open = [...others, document].slice(-8);
  }

  private change(name: string, change: Partial<TextDocument>): void {
    this.open = this.open.map((d) => (d.name === name ? { ...d, ...change } : d));
  }
}

export const documents = new Documents();
