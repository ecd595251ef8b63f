/** Colours of the tokens that the server cuts. What is in sight is asked for; until the answer is there a line looks as it did. */
import { EditorState, type Extension, RangeSetBuilder, StateEffect } from '@codemirror/state';
import {
  Decoration,
  type DecorationSet,
  EditorView,
  ViewPlugin,
  type ViewUpdate,
} from '@codemirror/view';
import { type LineTokens, type TextLanguage, TokenStore } from '../logic/token_store';

/** Colour and weight by the kind; of blanks and errors none. */
const LOOKS: Record<string, [string, string?]> = {
  program: ['syntax-keyword', '600'],
  comment: ['syntax-comment'],
  sequence: ['syntax-quiet'],
  command: ['syntax-g', '500'],
  switching: ['syntax-m', '500'],
  dimension: ['syntax-axis'],
  technology: ['syntax-technology'],
  variable: ['syntax-variable'],
  keyword: ['syntax-keyword', '500'],
  function: ['syntax-function'],
  number: ['syntax-axis'],
  text: ['syntax-string'],
  operator: ['syntax-quiet'],
  label: ['syntax-variable', '500'],
  target: ['syntax-axis'],
  skip: ['syntax-m', '600'],
};

const looks = EditorView.theme(
  Object.fromEntries(
    Object.entries(LOOKS).map(([kind, [colour, weight]]) => [
      `.cm-token-${kind}`,
      { color: `var(--${colour})`, fontWeight: weight ?? '400' },
    ]),
  ),
);

// What is typed at the end of a token is of its kind until it is known.
const MARKS = Object.fromEntries(
  Object.keys(LOOKS).map((kind) => [
    kind,
    Decoration.mark({ class: `cm-token-${kind}`, inclusiveEnd: true }),
  ]),
);

const known_now = StateEffect.define();

class Colouring {
  decorations: DecorationSet = Decoration.none;
  private readonly store: TokenStore;

  constructor(
    view: EditorView,
    private readonly language: TextLanguage,
  ) {
    this.store = new TokenStore(language, () => view.dispatch({ effects: known_now.of(null) }));
    this.paint(view);
  }

  update(update: ViewUpdate): void {
    if (update.docChanged) this.decorations = this.decorations.map(update.changes);
    const is_told = update.transactions.some(({ effects }) => effects.some((e) => e.is(known_now)));
    if (update.docChanged || update.viewportChanged || is_told) this.paint(update.view);
  }

  destroy(): void {
    this.store.dispose();
  }

  private paint({ state: { doc }, viewport }: EditorView): void {
    const builder = new RangeSetBuilder<Decoration>();
    const unknown: string[] = [];
    for (let at = viewport.from; at <= viewport.to;) {
      const line = doc.lineAt(at);
      const tokens = this.store.of(line.text);
      if (tokens) this.add(builder, line.from, tokens);
      else {
        unknown.push(line.text);
        this.keep(builder, line.from, line.to);
      }
      at = line.to + 1;
    }
    this.decorations = builder.finish();
    this.store.want(unknown);
  }

  private add(builder: RangeSetBuilder<Decoration>, from: number, tokens: LineTokens): void {
    for (let i = 0, at = from; i < tokens.length; i += 2) {
      const mark = MARKS[this.language.kind(tokens[i])];
      if (mark) builder.add(at, at + tokens[i + 1], mark);
      at += tokens[i + 1];
    }
  }

  private keep(builder: RangeSetBuilder<Decoration>, from: number, to: number): void {
    this.decorations.between(from, to, (begin, end, mark) => {
      if (begin >= from && end <= to && begin < end) builder.add(begin, end, mark);
    });
  }
}

export function colouring(language: TextLanguage): Extension {
  return [
    looks,
    ViewPlugin.define((view) => new Colouring(view, language), {
      decorations: (plugin) => plugin.decorations,
    }),
    EditorState.languageData.of(() => {
      const line = language.line_comment();
      return line ? [{ commentTokens: { line } }] : [];
    }),
  ];
}
