/** The program editor: CodeMirror with everything that an NC program needs, behind a small interface. */
import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import {
  highlightSelectionMatches,
  openSearchPanel,
  search,
  searchKeymap,
} from '@codemirror/search';
import { Compartment, EditorState, type Extension, Text } from '@codemirror/state';
import {
  EditorView,
  type ViewUpdate,
  drawSelection,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
} from '@codemirror/view';
import { line_ends_of, lines_of } from '../logic/line_ends';
import type { TextLanguage } from '../logic/token_store';
import { type Checker, check_again, checking } from './checking';
import { colouring } from './colouring';
import { free_keys } from './free_keys';
import { type GutterWishes, type Marks, marks_extension, show_marks } from './marks';
import { theme } from './theme';

export interface EditorWishes extends GutterWishes {
  edited(text: string): void;
  cursor(line: number): void;
  /** A line was clicked or gone to with the keys. */
  chosen(line: number): void;
}

/** What every text has, whatever its language. */
const OF_ANY_TEXT: Extension = [
  history(),
  drawSelection(),
  highlightActiveLine(),
  highlightActiveLineGutter(),
  highlightSelectionMatches(),
  search({ top: true }),
  keymap.of(free_keys([...defaultKeymap, ...historyKeymap, ...searchKeymap])),
];

const attributes = (label: string): Record<string, string> => ({
  'aria-label': label,
  spellcheck: 'false',
  tabindex: '0',
});

const EDITED_AFTER_MS = 120;
const EDGE_PX = 44;

export class ProgramEditor {
  private readonly view: EditorView;
  private readonly read_only = new Compartment();
  private readonly words = new Compartment();
  private pending: ReturnType<typeof setTimeout> | null = null;
  private line = 0;
  private line_end = '\n';
  private is_read_only = false;

  constructor(
    host: HTMLElement,
    private readonly label: () => string,
    private readonly phrases: () => Record<string, string>,
    private readonly wishes: EditorWishes,
    private readonly checker: Checker,
  ) {
    this.view = new EditorView({ parent: host });
  }

  dispose(): void {
    if (this.pending) clearTimeout(this.pending);
    this.view.destroy();
  }

  /** Another text; its history begins anew. */
  show(text: string, language: TextLanguage): void {
    this.flush();
    this.line = 0;
    this.line_end = line_ends_of(text).end;
    const doc = Text.of(lines_of(text));
    this.view.setState(EditorState.create({ doc, extensions: this.extensions(language) }));
    this.wishes.cursor(1);
  }

  /** Not by CodeMirror's lineSeparator: what is pasted then has to have the same line ends. */
  get text(): string {
    const { doc } = this.view.state;
    return doc.sliceString(0, doc.length, this.line_end);
  }

  /** What is wrong with the text has changed without an edit. */
  check_again(): void {
    check_again(this.view);
  }

  /** The language of the page is another. */
  renew_words(): void {
    this.view.dispatch({
      effects: this.words.reconfigure(EditorState.phrases.of(this.phrases())),
    });
  }

  mark(marks: Marks): void {
    show_marks(this.view, marks);
  }

  set_read_only(on: boolean): void {
    this.is_read_only = on;
    this.view.dispatch({ effects: this.read_only.reconfigure(EditorState.readOnly.of(on)) });
  }

  /** Into the picture, and the cursor there when `select`. */
  go_to(line: number, select: boolean): void {
    const { doc } = this.view.state;
    if (line < 1 || line > doc.lines) return;
    const { from } = doc.line(line);
    this.view.dispatch({
      ...(select ? { selection: { anchor: from } } : {}),
      effects: EditorView.scrollIntoView(from, { y: 'center' }),
    });
  }

  /** Keeps a line in sight without moving more than it must. */
  follow(line: number): void {
    this.view.requestMeasure({
      key: this,
      read: ({ state, scrollDOM }) => {
        if (line > state.doc.lines) return false;
        const block = this.view.lineBlockAt(state.doc.line(line).from);
        const { scrollTop, clientHeight } = scrollDOM;
        return block.top < scrollTop + EDGE_PX || block.bottom > scrollTop + clientHeight - EDGE_PX;
      },
      write: (is_out) => is_out && setTimeout(() => this.go_to(line, false)),
    });
  }

  focus(): void {
    this.view.focus();
  }
  find(): void {
    openSearchPanel(this.view);
  }

  /** Tells an edit that has not been told yet. */
  flush(): void {
    if (!this.pending) return;
    clearTimeout(this.pending);
    this.pending = null;
    this.wishes.edited(this.text);
  }

  private extensions(language: TextLanguage): Extension {
    return [
      lineNumbers(),
      marks_extension(this.wishes),
      OF_ANY_TEXT,
      colouring(language),
      checking(this.checker),
      theme,
      this.words.of(EditorState.phrases.of(this.phrases())),
      this.read_only.of(EditorState.readOnly.of(this.is_read_only)),
      EditorView.contentAttributes.of(attributes(this.label())),
      EditorView.updateListener.of((update) => this.follow_update(update)),
    ];
  }

  private follow_update({ docChanged, selectionSet }: ViewUpdate): void {
    if (docChanged) this.tell_later();
    if (selectionSet || docChanged) this.tell_cursor(docChanged);
  }

  private tell_later(): void {
    if (this.pending) clearTimeout(this.pending);
    this.pending = setTimeout(() => this.flush(), EDITED_AFTER_MS);
  }

  private tell_cursor(by_typing: boolean): void {
    const { state } = this.view;
    const line = state.doc.lineAt(state.selection.main.head).number;
    if (line === this.line) return;
    this.line = line;
    this.wishes.cursor(line);
    if (!by_typing) this.wishes.chosen(line);
  }
}
