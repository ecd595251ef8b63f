/** Errors while typing: the machine's own check, with alarm text, cause and remedy on hover. */
import { linter, lintGutter, type Diagnostic as Mark } from '@codemirror/lint';
import type { Extension, Text } from '@codemirror/state';
import type { Diagnostic } from '../logic/protocol';

/** Longer texts are checked when they are loaded, not at every key. */
export const MOST_CHECKED_CHARACTERS = 2_000_000;
const DELAY_MS = 350;

export interface Checker {
  check(text: string): Promise<Diagnostic[]>;
  /** Message, cause and remedy in the language of the page. */
  words(diagnostic: Diagnostic): { message: string; cause: string; remedy: string };
  remedy_caption(): string;
}

export function checking(checker: Checker): Extension {
  const source = linter(
    async (view) => {
      const { doc } = view.state;
      if (doc.length === 0 || doc.length > MOST_CHECKED_CHARACTERS) return [];
      const found = await checker.check(view.state.sliceDoc());
      return found.map((diagnostic) => mark(doc, diagnostic, checker));
    },
    { delay: DELAY_MS },
  );
  return [source, lintGutter()];
}

function mark(doc: Text, diagnostic: Diagnostic, checker: Checker): Mark {
  const line = doc.line(Math.min(Math.max(1, diagnostic.line), doc.lines));
  const from = Math.min(line.from + Math.max(0, diagnostic.column - 1), line.to);
  const to = Math.min(from + Math.max(1, diagnostic.length), line.to);
  return {
    from: Math.min(from, to),
    to: Math.max(from, to),
    severity: diagnostic.severity,
    message: `${diagnostic.code} ${diagnostic.message}`,
    renderMessage: () => card(diagnostic, checker),
  };
}

function card(diagnostic: Diagnostic, checker: Checker): HTMLElement {
  const words = checker.words(diagnostic);
  const element = document.createElement('div');
  element.className = 'cm-alarm-card';
  add(element, 'b', diagnostic.code);
  add(element, 'p', words.message).className = 'message';
  if (words.cause) add(element, 'p', words.cause);
  if (words.remedy) add(element, 'p', `${checker.remedy_caption()} ${words.remedy}`);
  return element;
}

function add(parent: HTMLElement, tag: string, text: string): HTMLElement {
  const child = document.createElement(tag);
  child.textContent = text;
  parent.append(child);
  return child;
}
