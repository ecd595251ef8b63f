import { beforeEach, describe, expect, it } from 'vitest';
import {
  Connection,
  FIRST_RETRY_MS,
  LAST_RETRY_MS,
  Refusal,
  type Socket,
} from '../src/logic/connection';
import { SILENT_MS, TICK_MS } from '../src/logic/heartbeat';
import { DATED_COMMANDS, MOVING_COMMANDS } from '../src/logic/protocol';

class FakeSocket implements Socket {
  binaryType = '';
  sent: Record<string, unknown>[] = [];
  pings: number[] = [];
  onopen: Socket['onopen'] = null;
  onclose: Socket['onclose'] = null;
  onmessage: Socket['onmessage'] = null;
  send(text: string): void {
    const frame = JSON.parse(text);
    if (frame.do === 'ping') this.pings.push(frame.id);
    else this.sent.push(frame);
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
let ticks: { ms: number; action: () => void }[];
let now_ms: number;
let heard: string[];
let connection: Connection;
const last = () => sockets[sockets.length - 1];

beforeEach(() => {
  sockets = [];
  waits = [];
  ticks = [];
  now_ms = 0;
  heard = [];
  connection = new Connection(
    () => {
      sockets.push(new FakeSocket());
      return last();
    },
    {
      now: () => now_ms,
      after: (ms, action) => {
        const wait = { ms, action };
        const list = ms === TICK_MS ? ticks : waits;
        list.push(wait);
        return () => list.includes(wait) && list.splice(list.indexOf(wait), 1);
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
      { id: 2, do: 'mode', mode: 'jog' },
      { id: 3, do: 'machines' },
    ]);
    last().says({ id: 3, ok: true, machines: [] });
    last().says({ id: 2, ok: false, error: 'the machine moves' });
    await expect(second).resolves.toMatchObject({ machines: [] });
    await expect(first).rejects.toThrow(new Refusal('the machine moves'));
    const third = connection.do('home');
    last().says({ id: 4, ok: false, error: 'E', code: 'no-axis', values: { axis: 'U' } });
    await expect(third).rejects.toMatchObject({
      message: 'E',
      code: 'no-axis',
      values: { axis: 'U' },
    });
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

/** Time passes, and the connection ticks in it. */
function wait(ms: number): void {
  for (const until = now_ms + ms; now_ms < until;) {
    now_ms += TICK_MS;
    ticks.shift()?.action();
  }
}
const answer_pings = (time_ms: number): void => {
  for (const id of last().pings.splice(0)) last().says({ id, ok: true, time_ms });
};

describe('a line that hangs', () => {
  it('is found after three seconds; what waits is refused, and nothing more is sent', async () => {
    const start = connection.do('cycle-start');
    wait(SILENT_MS - TICK_MS);
    expect(heard).toEqual(['connecting', 'open']);
    wait(TICK_MS);
    expect(heard.at(-1)).toBe('silent');
    await expect(start).rejects.toThrow('down');
    last().sent = [];
    await expect(connection.do('cycle-start')).rejects.toThrow('down');
    expect(last().sent).toEqual([]);
  });

  it('is open again as soon as anything comes, and pings go on', async () => {
    wait(SILENT_MS);
    last().says({ event: 'state' });
    expect(heard.slice(-2)).toEqual(['open', 'event state']);
    last().pings = [];
    wait(1000);
    expect(last().pings.length).toBeGreaterThan(0);
    const asked = connection.do('machines');
    last().says({ id: last().sent.at(-1)!.id, ok: true });
    await expect(asked).resolves.toBeTruthy();
  });

  it('is not one that answers', async () => {
    for (let second = 0; second < 10; second++) {
      wait(1000);
      answer_pings(now_ms);
      await Promise.resolve();
    }
    expect(heard).toEqual(['connecting', 'open']);
  });
});

describe('a command that must not come late', () => {
  it('carries the time at which it was given, by the clock of the server', async () => {
    answer_pings(70_000);
    await Promise.resolve();
    await Promise.resolve();
    now_ms = 250;
    void connection.do('cycle-start').catch(() => null);
    void connection.do('feed-hold').catch(() => null);
    void connection.do('jog-stop').catch(() => null);
    void connection.do('reset').catch(() => null);
    expect(last().sent.map(({ at_ms }) => at_ms)).toEqual([
      70_250,
      undefined,
      undefined,
      undefined,
    ]);
  });

  it('is every one that moves, and none that stops', () => {
    for (const name of MOVING_COMMANDS) expect(DATED_COMMANDS).toContain(name);
    for (const name of ['feed-hold', 'reset', 'jog-stop'])
      expect(DATED_COMMANDS).not.toContain(name);
  });
});
