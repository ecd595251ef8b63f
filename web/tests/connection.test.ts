import { beforeEach, describe, expect, it } from 'vitest';
import {
  Connection,
  FIRST_RETRY_MS,
  LAST_RETRY_MS,
  Refusal,
  type Socket,
} from '../src/logic/connection';

class FakeSocket implements Socket {
  binaryType = '';
  sent: Record<string, unknown>[] = [];
  onopen: Socket['onopen'] = null;
  onclose: Socket['onclose'] = null;
  onmessage: Socket['onmessage'] = null;
  send(text: string): void {
    this.sent.push(JSON.parse(text));
  }
  close(): void {
    this.onclose?.({ code: 1000, reason: '' });
  }
  says(frame: unknown): void {
    this.onmessage?.({
      data:
        typeof frame === 'object' && !(frame instanceof ArrayBuffer)
          ? JSON.stringify(frame)
          : frame,
    });
  }
}

let sockets: FakeSocket[];
let waits: { ms: number; action: () => void }[];
let heard: string[];
let connection: Connection;
const last = () => sockets[sockets.length - 1];

beforeEach(() => {
  sockets = [];
  waits = [];
  heard = [];
  connection = new Connection(
    () => {
      sockets.push(new FakeSocket());
      return last();
    },
    {
      after: (ms, action) => {
        const wait = { ms, action };
        waits.push(wait);
        return () => waits.splice(waits.indexOf(wait), 1);
      },
    },
    {
      line: (state, retry) => heard.push(retry ? `${state} ${retry}` : state),
      event: (event) => heard.push(`event ${String(event.event)}`),
      chunk: (bytes) => heard.push(`chunk ${bytes.byteLength}`),
    },
    () => 'down',
    () => 'too long',
  );
  connection.connect();
  last().onopen?.();
});

describe('a connection', () => {
  it('gives each command its own answer, in whatever order they come', async () => {
    const first = connection.do('mode', { mode: 'jog' });
    const second = connection.do('machines');
    expect(last().sent).toEqual([
      { id: 1, do: 'mode', mode: 'jog' },
      { id: 2, do: 'machines' },
    ]);
    last().says({ id: 2, ok: true, machines: [] });
    last().says({ id: 1, ok: false, error: 'the machine moves' });
    await expect(second).resolves.toMatchObject({ machines: [] });
    await expect(first).rejects.toThrow(new Refusal('the machine moves'));
  });

  it('tells events and chunks apart', () => {
    last().says({ event: 'state' });
    last().says(new ArrayBuffer(8));
    expect(heard).toEqual(['connecting', 'open', 'event state', 'chunk 8']);
  });

  it('refuses what was under way when the line breaks, and sends nothing twice', async () => {
    const start = connection.do('cycle-start');
    last().onclose?.({ code: 1006, reason: '' });
    await expect(start).rejects.toThrow('down');
    await expect(connection.do('feed-hold')).rejects.toThrow('down');
    waits[0].action();
    last().onopen?.();
    expect(last().sent).toEqual([]);
  });

  it('comes back by itself, waiting twice as long each time up to a limit', () => {
    const waited: number[] = [];
    for (let i = 0; i < 8; i++) {
      last().onclose?.({ code: 1006, reason: '' });
      const wait = waits[waits.length - 1];
      waited.push(wait.ms);
      wait.action();
    }
    expect(waited).toEqual(
      [1, 2, 4, 8, 16, 20, 20, 20].map((k) => Math.min(LAST_RETRY_MS, k * FIRST_RETRY_MS)),
    );
    last().onopen?.();
    last().onclose?.({ code: 1006, reason: '' });
    expect(waits[waits.length - 1].ms).toBe(FIRST_RETRY_MS);
  });

  it('stays away when the server does not admit the page', () => {
    last().onclose?.({ code: 1008, reason: 'the origin is another one' });
    expect(heard[heard.length - 1]).toBe('refused');
    expect(waits).toEqual([]);
  });

  it('takes no notice of a socket that it has given up', () => {
    const old = last();
    old.onclose?.({ code: 1006, reason: '' });
    waits[0].action();
    last().onopen?.();
    const before = heard.length;
    old.onclose?.({ code: 1006, reason: '' });
    expect(heard.length).toBe(before);
  });

  it('refuses what is longer than the server takes, and the line stays', async () => {
    const refused = connection.do('write', { text: 'x'.repeat(1_048_576) });
    await expect(refused).rejects.toThrow('too long');
    expect(last().sent).toEqual([]);
    const answered = connection.do('programs');
    last().says({ id: last().sent[0].id, ok: true });
    expect((await answered).ok).toBe(true);
  });
});
