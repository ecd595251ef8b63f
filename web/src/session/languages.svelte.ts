/** What the server says of languages, and of the text that is in the editor. */
import { line_comment } from '../logic/dialects';
import type { Dialect } from '../logic/protocol';
import type { LineTokens, TextLanguage } from '../logic/token_store';
import { after } from './after';

type Ask = (name: string, args: Record<string, unknown>) => Promise<Record<string, unknown>>;

/** So much of a text is looked at to recognise it. */
const HEAD = 4_096;

class Languages {
  dialects = $state.raw<Dialect[]>([]);
  private kinds: string[] = [];

  hello(dialects: Dialect[], kinds: string[]): void {
    this.dialects = dialects;
    this.kinds = kinds;
  }

  find(name: string): Dialect | undefined {
    return this.dialects.find((dialect) => dialect.name === name);
  }

  /** Of a text as it is opened; its dialect is asked for with its first lines. */
  of_text(ask: Ask, name: string, text: string): TextLanguage {
    // Half a character at the end is no text.
    const head = text.slice(0, HEAD).replace(/[\ud800-\udbff]$/, '');
    let dialect = '';
    return {
      kind: (number) => this.kinds[number] ?? '',
      line_comment: () => line_comment(this.find(dialect)),
      after,
      cut: async (lines) => {
        dialect ||= String((await ask('dialect', { name, text: head })).dialect);
        const answer = await ask('tokens', { dialect, lines: lines.join('\n') });
        return answer.tokens as LineTokens[];
      },
    };
  }
}

export const languages = new Languages();
