import { describe, expect, it } from 'vitest';
import { LONGEST_LINE, type LineTokens, TokenStore } from '../src/logic/token_store';

/** A server that answers when it is told to, and a clock that stands. */
class Server {
  readonly questions: string[][] = [];
  private answers: ((tokens: LineTokens[] | null) => void)[] = [];
  private waits: (() => void)[] = [];

  cut = (lines: string[]): Promise<LineTokens[]> => {
    this.questions.push(lines);
    return new Promise((yes, no) => this.answers.push((tokens) => (tokens ? yes(tokens) : no())));
  };
  after = (_ms: number, action: () => void): (() => void) => {
    this.waits.push(action);
    return () => (this.waits = this.waits.filter((wait) => wait !== action));
  };
  async answer(): Promise<void> {
    this.answers.shift()!(this.questions.at(-1)!.map((line) => [1, line.length]));
    await settled();
  }
  async refuse(): Promise<void> {
    this.answers.shift()!(null);
    await settled();
  }
  pass_time(): void {
    const waits = this.waits;
    this.waits = [];
    for (const wait of waits) wait();
  }
  get is_waited_for(): boolean {
    return this.waits.length > 0;
  }
}

const settled = (): Promise<void> => new Promise((done) => setTimeout(done));

function fresh(): { server: Server; store: TokenStore; told: () => number } {
  const server = new Server();
  let count = 0;
  return { server, store: new TokenStore(server, () => count++), told: () => count };
}

describe('tokens of lines', () => {
  it('are known by the text of the line, once', async () => {
    const { server, store, told } = fresh();
    store.want(['G01', 'X1', 'G01']);
    expect(server.questions).toEqual([['G01', 'X1']]);
    await server.answer();
    expect([store.of('G01'), store.of('X1'), store.of('X2')]).toEqual([[1, 3], [1, 2], undefined]);
    expect(told()).toBe(1);
    server.pass_time();
    store.want(['X1']);
    expect(server.questions.length).toBe(1);
  });

  it('are asked for one question at a time, and only the newest wish is next', async () => {
    const { server, store } = fresh();
    store.want(['X1']);
    store.want(['X12']);
    store.want(['X123']);
    expect(server.questions).toEqual([['X1']]);
    await server.answer();
    expect(server.questions.length).toBe(1);
    server.pass_time();
    expect(server.questions).toEqual([['X1'], ['X123']]);
  });

  it('come in questions that a command can hold', async () => {
    const { server, store } = fresh();
    const lines = Array.from({ length: 2_000 }, (_, i) => `${i}${'X'.repeat(96)}`);
    store.want(lines);
    for (let i = 0; i < 30 && store.of(lines.at(-1)!) === undefined; i++) {
      await server.answer();
      server.pass_time();
    }
    expect(lines.every((line) => store.of(line))).toBe(true);
    for (const question of server.questions)
      expect(question.join('\n').length).toBeLessThanOrEqual(8_000);
  });

  it('of an empty line or one without an end are none', () => {
    const { server, store } = fresh();
    expect(store.of('')).toEqual([]);
    store.want(['X'.repeat(LONGEST_LINE + 1)]);
    expect(server.questions).toEqual([]);
  });

  it('are asked for again when the server did not answer, until nobody wants them', async () => {
    const { server, store, told } = fresh();
    store.want(['X1']);
    await server.refuse();
    expect([told(), server.is_waited_for]).toEqual([0, true]);
    server.pass_time();
    expect(server.questions).toEqual([['X1'], ['X1']]);
    store.dispose();
    await server.refuse();
    expect(server.is_waited_for).toBe(false);
  });
});
