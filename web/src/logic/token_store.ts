/** Tokens of lines by their text: what is not known is asked for, one question at a time, while the page goes on. */

/** Kind and length of each token in turn, as `tokens` answers. */
export type LineTokens = readonly number[];

export interface TokenSource {
  cut(lines: string[]): Promise<LineTokens[]>;
  after(ms: number, action: () => void): () => void;
}

/** What the editor wants to know of the language of a text. */
export interface TextLanguage extends TokenSource {
  /** Name of a kind of tokens. */
  kind(number: number): string;
  /** Undefined: its comments have an end, or it is not known yet. */
  line_comment(): string | undefined;
}

/** Of one question: at most 24,000 bytes with their line feeds. */
const MOST_CHARACTERS = 8_000;
/** A longer line stays as it is. */
export const LONGEST_LINE = 4_000;
const MOST_LINES = 500;
/** At most so often: 20 questions a second. */
const PAUSE_MS = 50;
const RETRY_MS = 1_000;
/** Lines that are kept. */
const MOST_KNOWN = 20_000;

const NOTHING: LineTokens = [];

export class TokenStore {
  private readonly known = new Map<string, LineTokens>();
  private wanted = new Set<string>();
  private is_asking = false;
  private stop_waiting: (() => void) | null = null;
  private is_over = false;

  constructor(
    private readonly source: TokenSource,
    /** Lines are known that were not. */
    private readonly changed: () => void,
  ) {}

  /** Undefined: they are not known yet. */
  of(line: string): LineTokens | undefined {
    return line.length === 0 || line.length > LONGEST_LINE ? NOTHING : this.known.get(line);
  }

  /** What is wanted now; an earlier wish is forgotten. */
  want(lines: Iterable<string>): void {
    this.wanted = new Set(lines);
    if (!this.is_asking && !this.stop_waiting) void this.ask();
  }

  dispose(): void {
    this.is_over = true;
    this.stop_waiting?.();
  }

  private async ask(): Promise<void> {
    const lines = this.next_question();
    if (lines.length === 0) return;
    this.is_asking = true;
    const answer = await this.source.cut(lines).catch(() => null);
    this.is_asking = false;
    if (this.is_over) return;
    this.stop_waiting = this.source.after(answer ? PAUSE_MS : RETRY_MS, () => {
      this.stop_waiting = null;
      void this.ask();
    });
    if (answer) this.take(lines, answer);
  }

  private next_question(): string[] {
    const lines: string[] = [];
    let characters = 0;
    for (const line of this.wanted) {
      if (this.of(line)) continue;
      characters += line.length + 1;
      if (lines.length === MOST_LINES || characters > MOST_CHARACTERS) break;
      lines.push(line);
    }
    return lines;
  }

  private take(lines: string[], answer: LineTokens[]): void {
    lines.forEach((line, i) => this.known.set(line, answer[i] ?? NOTHING));
    for (const oldest of this.known.keys()) {
      if (this.known.size <= MOST_KNOWN) break;
      this.known.delete(oldest);
    }
    this.changed();
  }
}
