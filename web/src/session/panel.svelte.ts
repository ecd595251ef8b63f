/** The machine that this page watches: what it says, and every command to it. */
import {
  Connection,
  type Answer,
  type Command,
  type LineState,
  Refusal,
  type Socket,
} from '../logic/connection';
import { decode_chunk } from '../logic/chunk';
import { PartStore } from '../logic/stock/part_store';
import { decode_stock_frame, is_stock_frame } from '../logic/stock/stock_frame';
import { first_machine } from '../logic/first_machine';
import { refusal_words } from '../logic/i18n/refusals';
import { tip_of, type Point } from '../logic/kinematics';
import { PathStore } from '../logic/path_store';
import { patched } from '../logic/state_patch';
import {
  EMPTY_STATE,
  MOVING_COMMANDS,
  type Axes,
  type Breakpoint,
  type Dialect,
  type MachineDefinition,
  type MachineEntry,
  type MachineState,
  type Mode,
  type PathEvent,
} from '../logic/protocol';
import { UndoStack } from '../logic/undo';
import { after } from './after';
import { keep, kept } from './browser_memory';
import { languages } from './languages.svelte';
import { link } from './link.svelte';
import { notices } from './notices.svelte';
import { preferences } from './preferences.svelte';
import { t } from './words.svelte';

const FIRST_MACHINE_KEY = 'kerf.machine';
/** Of this browser, beside that of this tab. */
const LAST_MACHINE_KEY = 'kerf.last-machine';

class Panel {
  line = $state.raw<{ state: LineState; retry_in_s: number; reason: string }>({
    state: 'connecting',
    retry_in_s: 0,
    reason: '',
  });
  machines = $state.raw<MachineEntry[]>([]);
  definitions = $state.raw<string[]>([]);
  machine = $state('');
  definition = $state.raw<MachineDefinition | null>(null);
  state = $state.raw<MachineState>(EMPTY_STATE);
  /** How the server calls this page. */
  me = $state('');
  /** Counts the connections: what was known of an earlier one must be asked again. */
  epoch = $state(0);
  /** Counts the commands of this page that make something move. */
  begun = $state(0);
  breakpoints = $state.raw<Breakpoint[]>([]);
  path = $state.raw<PathEvent | null>(null);
  /** Changes with every chunk; the store itself is plain. */
  path_version = $state(0);
  readonly preview = new PathStore();
  /** What of the part has come; changes with every frame and event of it. */
  part_version = $state(0);
  readonly part = new PartStore();
  readonly edits = new UndoStack();
  /** Of what is loaded with its set-up: features that were told for an earlier one hold no more. */
  features_revision = $state(0);

  /** Where the tip is on the path, by the joints: the machine's position has the tool length in it, the path has not. */
  tip_at(joints: Axes): Point {
    return this.definition ? tip_of(this.definition.kinematics, joints) : [0, 0, 0];
  }

  /** By the clock of the day: when anything came last. */
  private heard_at = Date.now();
  private readonly connection = new Connection(
    () => new WebSocket(socket_address()) as Socket,
    { now: () => performance.now(), after },
    {
      line: (state, retry_in_s, reason) => this.on_line(state, retry_in_s, reason),
      event: (event) => this.on_event(event),
      chunk: (bytes) => this.on_chunk(bytes),
      heard: () => (this.heard_at = Date.now()),
    },
    () => t('connection.refused'),
    () => t('connection.too-long'),
  );

  /** The server answers: what is shown is what is, and keys reach the machine. */
  get has_link(): boolean {
    return this.line.state === 'open';
  }
  get operates(): boolean {
    return this.has_link && this.me !== '' && this.state.operator === this.me;
  }
  /** As a client is called: by its person, or by the number of its page. */
  called(client: string): string {
    return this.state.people[client] ?? t('operate.page', { number: client.replace(/\D+/g, '') });
  }
  /** Seconds until the machine is handed over to who asks for it; null: nobody asks. */
  request_left_s(): number | null {
    const now_ms = this.connection.server_ms();
    const { request } = this.state;
    return request && now_ms !== null ? Math.max(0, (request.until_ms - now_ms) / 1000) : null;
  }
  get moves(): boolean {
    return this.state.status === 'running';
  }

  start(): void {
    this.connection.connect();
  }

  /** Sends a command; a refusal is rejected to the caller. */
  ask(name: string, args: Command = {}): Promise<Answer> {
    if (MOVING_COMMANDS.has(name)) this.begun++;
    return this.connection.do(name, args);
  }

  /** Sends a command for the operator: a refusal becomes a notice. Null: refused. */
  async act(name: string, args: Command = {}): Promise<Answer | null> {
    try {
      return await this.ask(name, args);
    } catch (reason) {
      if (reason instanceof Refusal) notices.say(said(reason), 'refused');
      else throw reason;
      return null;
    }
  }

  async watch(machine: string): Promise<void> {
    this.forget_machine();
    const answer = await this.act('watch', { machine });
    if (!answer) return;
    this.machine = machine;
    this.definition = answer.definition as MachineDefinition;
    this.me = String(answer.client);
    this.breakpoints = answer.breakpoints as Breakpoint[];
    this.epoch++;
    keep_machine(machine);
    if (this.state.operator === null) await this.take_quietly();
  }

  async refresh_machines(): Promise<void> {
    const answer = await this.act('machines');
    if (!answer) return;
    this.machines = answer.machines as MachineEntry[];
    this.definitions = answer.definitions as string[];
  }

  /** A free machine is taken, one that somebody operates is asked for. */
  take = (): Promise<unknown> => this.act('request-operation', { ask: true });
  withdraw = (): Promise<unknown> => this.act('request-operation', { ask: false });
  answer_request = (grant: boolean): Promise<unknown> => this.act('answer-request', { grant });
  async introduce(person: string): Promise<void> {
    preferences.person = person.trim();
    await this.act('introduce', { name: preferences.person });
  }
  release = (): Promise<unknown> => this.act('operate', { take: false });
  hand_to = (client: string): Promise<unknown> =>
    this.act('operate', { take: false, hand_to: client });

  reset = (): Promise<unknown> => this.act('reset');
  set_input = (input: number, on: boolean): Promise<unknown> =>
    this.act('set-input', { input, value: on ? 1 : 0 });
  set_mode = (mode: Mode): Promise<unknown> => this.act('mode', { mode });
  set_skip = (levels: number[]): Promise<unknown> => this.act('block-skip', { levels });
  override = (which: 'feed' | 'rapid' | 'spindle', percent: number): Promise<unknown> =>
    this.act('override', { [which]: percent });

  async set_breakpoints(list: Breakpoint[]): Promise<void> {
    const before = this.breakpoints;
    this.breakpoints = list;
    const answer = await this.act('breakpoints', { list });
    this.breakpoints = answer ? (answer.list as Breakpoint[]) : before;
  }

  private forget_machine(): void {
    this.state = EMPTY_STATE;
    this.path = null;
    this.preview.clear(-1);
    this.edits.clear();
    this.breakpoints = [];
    this.path_version++;
    this.part.clear();
    this.part_version++;
  }

  /** Free control is taken without a word; that somebody else was quicker is no news. */
  private async take_quietly(): Promise<void> {
    await this.ask('operate', { take: true }).catch(() => null);
  }

  private on_line(state: LineState, retry_in_s: number, reason: string): void {
    const before = this.line.state;
    this.line = { state, retry_in_s, reason };
    link.turned(state, this.heard_at, this.state, this.epoch > 0);
    // Behind a silence the line is the same, and so is all that is known.
    if (state === 'open' && before !== 'silent') void this.begin();
  }

  private async begin(): Promise<void> {
    if (preferences.person) await this.introduce(preferences.person);
    await this.refresh_machines();
    const known = first_machine(this.machines, [this.machine, ...kept_machines()]);
    if (known) await this.watch(known.name);
  }

  private on_event(event: Record<string, unknown>): void {
    if (event.event === 'hello') this.on_hello(event);
    else if (event.event === 'request-refused') notices.say(t('operate.was-refused'), 'refused');
    else if (event.event === 'machines') this.machines = event.machines as MachineEntry[];
    else if (event.event === 'state') this.state = patched(this.state, event);
    else if (event.event === 'stock') this.on_part(event);
    else if (event.event === 'features') this.features_revision = Number(event.revision);
    else if (event.event === 'path') this.on_path(event as unknown as PathEvent);
    else if (event.event === 'definition') this.definition = event.definition as MachineDefinition;
  }

  private on_hello(event: Record<string, unknown>): void {
    languages.hello(event.dialects as Dialect[], event.token_kinds as string[]);
    link.hello(String(event.server), Number(event.began_ms));
  }

  private on_path(event: PathEvent): void {
    if (event.run > this.preview.run) this.preview.clear(event.run);
    this.path = event;
    this.path_version++;
  }

  private on_part(event: Record<string, unknown>): void {
    if (event.machine !== this.machine && this.machine) return;
    this.part.take_event(event);
    this.part_version++;
  }

  private on_chunk(bytes: ArrayBuffer): void {
    if (is_stock_frame(bytes)) {
      if (this.part.take_frame(decode_stock_frame(bytes))) this.part_version++;
      return;
    }
    const chunk = decode_chunk(bytes);
    if (chunk.source === 'preview' && this.preview.add(chunk)) this.path_version++;
  }
}

/** That of this tab, then that of this browser. */
const kept_machines = (): (string | null)[] => [
  kept(FIRST_MACHINE_KEY, 'tab'),
  kept(LAST_MACHINE_KEY),
];

function keep_machine(name: string): void {
  keep(FIRST_MACHINE_KEY, name, 'tab');
  keep(LAST_MACHINE_KEY, name);
}

/** In the language of the page. */
export const said = ({ message, code, values }: Refusal): string =>
  refusal_words(preferences.language, message, code, values);

function socket_address(): string {
  const address = new URL('ws', location.href);
  address.protocol = location.protocol === 'https:' ? 'wss:' : 'ws:';
  address.search = location.search;
  address.hash = '';
  return address.href;
}

export const panel = new Panel();
