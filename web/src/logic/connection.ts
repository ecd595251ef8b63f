/**
 * One WebSocket to the server for as long as the page is open: numbers commands, matches answers, comes back by itself when
 * the server was away. What is behind a broken line is refused, never sent twice: a cycle start that nobody answered must
 * not happen a minute later. A line that hangs is found by pings, and what could move something carries its time.
 */
import { Heartbeat, TICK_MS } from './heartbeat';
import { message_fits } from './message_size';
import { DATED_COMMANDS } from './protocol';

export type Answer = Record<string, unknown> & { ok: true };
export type Command = Record<string, unknown>;
/** Silent: it is open, and nothing comes. */
export type LineState = 'connecting' | 'open' | 'silent' | 'waiting' | 'refused';

/** The part of WebSocket that is used; a test passes its own. */
export interface Socket {
  binaryType: string;
  send(text: string): void;
  close(): void;
  onopen: (() => void) | null;
  onclose: ((event: { code: number; reason: string }) => void) | null;
  onmessage: ((event: { data: unknown }) => void) | null;
}

export interface Clock {
  /** Milliseconds that never go back. */
  now(): number;
  after(milliseconds: number, action: () => void): () => void;
}

export interface Listener {
  line(state: LineState, retry_in_s: number, reason: string): void;
  event(event: Record<string, unknown>): void;
  chunk(bytes: ArrayBuffer): void;
  /** Anything has come. */
  heard?(): void;
}

/** The sentence with which the server, or the line, refuses a command. */
export class Refusal extends Error {
  override name = 'Refusal';

  constructor(
    sentence: string,
    /** Which sentence it is, for who says it in another language. */
    readonly code?: string,
    readonly values: Record<string, string> = {},
  ) {
    super(sentence);
  }
}

interface Waiting {
  resolve(answer: Answer): void;
  reject(reason: Refusal): void;
}

export const FIRST_RETRY_MS = 250;
export const LAST_RETRY_MS = 5000;
/** WebSocket's "policy violation": token or origin are wrong, trying again does not help. */
const POLICY = 1008;

export class Connection {
  private socket: Socket | null = null;
  private waiting = new Map<number, Waiting>();
  private next_id = 1;
  private retry_ms = FIRST_RETRY_MS;
  private open = false;
  private silent = false;
  private cancel_retry: (() => void) | null = null;
  private cancel_tick: (() => void) | null = null;
  private readonly heartbeat = new Heartbeat();

  constructor(
    private readonly make: () => Socket,
    private readonly clock: Clock,
    private readonly listener: Listener,
    private readonly lost_line: () => string = () => 'The line to the server is down.',
    private readonly too_long: () => string = () => 'This is too long for one message.',
  ) {}

  /** What the server's clock shows now; null: it has not told it yet. */
  server_ms(): number | null {
    return this.heartbeat.server_ms(this.clock.now());
  }

  connect(): void {
    this.cancel_retry?.();
    this.cancel_retry = null;
    this.listener.line('connecting', 0, '');
    const socket = this.make();
    this.socket = socket;
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => this.opened();
    socket.onmessage = (message) => this.received(message.data);
    socket.onclose = (event) => this.closed(socket, event.code, event.reason);
  }

  close(): void {
    this.cancel_retry?.();
    this.cancel_tick?.();
    const socket = this.socket;
    this.socket = null;
    this.open = false;
    socket?.close();
    this.refuse_all();
  }

  do(name: string, args: Command = {}): Promise<Answer> {
    if (!this.open || !this.socket || this.silent)
      return Promise.reject(new Refusal(this.lost_line()));
    return this.send(this.socket, name, args);
  }

  private send(socket: Socket, name: string, args: Command): Promise<Answer> {
    const id = this.next_id++;
    const at_ms = DATED_COMMANDS.has(name) ? this.server_ms() : null;
    const frame = JSON.stringify({ id, do: name, ...args, ...(at_ms === null ? {} : { at_ms }) });
    // The server would close the line, and all that is under way with it.
    if (!message_fits(frame)) return Promise.reject(new Refusal(this.too_long()));
    socket.send(frame);
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
  }

  private opened(): void {
    this.open = true;
    this.silent = false;
    this.retry_ms = FIRST_RETRY_MS;
    this.heartbeat.reset();
    this.tick();
    this.listener.line('open', 0, '');
  }

  private tick(): void {
    this.cancel_tick = this.clock.after(TICK_MS, () => this.tick());
    if (this.heartbeat.tick(this.clock.now())) this.ping();
    if (!this.heartbeat.is_silent || this.silent) return;
    this.silent = true;
    this.refuse_all();
    this.listener.line('silent', 0, '');
  }

  private ping(): void {
    const socket = this.socket;
    if (!socket) return;
    this.send(socket, 'ping', {}).then(
      ({ time_ms }) => this.heartbeat.answered(this.clock.now(), Number(time_ms)),
      () => null, // the line says that it is down
    );
  }

  private heard(): void {
    this.heartbeat.heard();
    this.listener.heard?.();
    if (!this.silent) return;
    this.silent = false;
    this.heartbeat.reset(); // its answer to the last ping is not waited for any more
    this.listener.line('open', 0, '');
  }

  private received(data: unknown): void {
    this.heard();
    if (typeof data !== 'string') {
      this.listener.chunk(data as ArrayBuffer);
      return;
    }
    const frame = JSON.parse(data) as Record<string, unknown>;
    if (typeof frame.id === 'number') this.answered(frame.id, frame);
    else this.listener.event(frame);
  }

  private answered(id: number, frame: Record<string, unknown>): void {
    const waiting = this.waiting.get(id);
    this.waiting.delete(id);
    if (!waiting) return;
    if (frame.ok === true) waiting.resolve(frame as Answer);
    else waiting.reject(refusal_of(frame));
  }

  private closed(socket: Socket, code: number, reason: string): void {
    if (socket !== this.socket) return;
    this.open = false;
    this.silent = false;
    this.cancel_tick?.();
    this.socket = null;
    this.refuse_all();
    if (code === POLICY) {
      this.listener.line('refused', 0, reason);
      return;
    }
    const wait = this.retry_ms;
    this.retry_ms = Math.min(LAST_RETRY_MS, wait * 2);
    this.listener.line('waiting', wait / 1000, reason);
    this.cancel_retry = this.clock.after(wait, () => this.connect());
  }

  private refuse_all(): void {
    const refused = [...this.waiting.values()];
    this.waiting.clear();
    for (const waiting of refused) waiting.reject(new Refusal(this.lost_line()));
  }
}

function refusal_of({ error, code, values }: Record<string, unknown>): Refusal {
  const known = typeof code === 'string' ? code : undefined;
  return new Refusal(String(error ?? ''), known, (values ?? {}) as Record<string, string>);
}
