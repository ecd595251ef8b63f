/** Errors while typing: the machine's own check, with alarm text, cause and remedy on hover. */
import { linter, lintGutter, type Diagnostic as Mark } from '@codemirror/lint';
import { type Extension, StateEffect, type Text } from '@codemirror/state';
import { type EditorView, tooltips, type ViewUpdate } from '@codemirror/view';
import { mark_range } from '../logic/mark_range';
import { MOST_TEXT_BYTES } from '../logic/message_size';
import type { Diagnostic } from '../logic/protocol';

const DELAY_MS = 350;
const other_errors = StateEffect.define();

export interface Checker {
  /** All that is wrong with the text; null: it is longer than what the server checks. */
  check(text: string | null): Promise<Diagnostic[]>;
  /** Message, cause and remedy in the language of the page. */
  words(diagnostic: Diagnostic): { message: string; cause: string; remedy: string };
  remedy_caption(): string;
  manual_caption(): string;
  /** Where the manual explains it. */
  open_manual(diagnostic: Diagnostic): void;
}

export function checking(checker: Checker): Extension {
  const source = linter((view) => marks_of(view, checker), { delay: DELAY_MS, needsRefresh });
  return [source, lintGutter(), tooltips({ tooltipSpace: below_the_bars })];
}

async function marks_of({ state }: EditorView, checker: Checker): Promise<Mark[]> {
  const { doc } = state;
  const found = await checker.check(doc.length <= MOST_TEXT_BYTES ? state.sliceDoc() : null);
  return found.map((diagnostic) => mark(doc, diagnostic, checker));
}

const needsRefresh = ({ transactions }: ViewUpdate): boolean =>
  transactions.some(({ effects }) => effects.some((effect) => effect.is(other_errors)));

/** A card stands in the text, below its line: the buttons above it and below it stay free. */
function below_the_bars(view: EditorView) {
  const { top, bottom } = view.scrollDOM.getBoundingClientRect();
  return { top, bottom, left: 0, right: innerWidth };
}

/** Something else than an edit has changed what is wrong with the text. */
export function check_again(view: EditorView): void {
  view.dispatch({ effects: other_errors.of(null) });
}

function mark(doc: Text, diagnostic: Diagnostic, checker: Checker): Mark {
  const line = doc.line(Math.min(Math.max(1, diagnostic.line), doc.lines));
  const [from, to] = mark_range(line.text, diagnostic.column, diagnostic.length);
  return {
    from: line.from + from,
    to: line.from + to,
    severity: diagnostic.severity === 'note' ? 'info' : diagnostic.severity,
    message: `${diagnostic.code} ${diagnostic.message}`,
    renderMessage: () => card(diagnostic, checker),
  };
}

function card(diagnostic: Diagnostic, checker: Checker): HTMLElement {
  const words = checker.words(diagnostic);
  const element = document.createElement('div');
  element.className = 'cm-alarm-card';
  add(element, 'b', diagnostic.code).append(' ', book(diagnostic, checker));
  add(element, 'p', words.message).className = 'message';
  if (words.cause) add(element, 'p', words.cause);
  if (words.remedy) add(element, 'p', `${checker.remedy_caption()} ${words.remedy}`);
  return element;
}

function book(diagnostic: Diagnostic, checker: Checker): HTMLButtonElement {
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = checker.manual_caption();
  button.onclick = () => checker.open_manual(diagnostic);
  return button;
}

function add(parent: HTMLElement, tag: string, text: string): HTMLElement {
  const child = document.createElement(tag);
  child.textContent = text;
  parent.append(child);
  return child;
}
