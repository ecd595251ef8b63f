/** What the page and `kerf serve` say to each other, version 1 (docs/panel-protocol.md). Units stand in the keys. */

export type Axes = Record<string, number>;

export type Status = 'idle' | 'running' | 'held' | 'stopped' | 'step' | 'end' | 'alarm';
export type Mode = 'edit' | 'mdi' | 'auto' | 'jog' | 'ref' | 'teach';
export type SwitchName = 'single-block' | 'optional-stop' | 'dry-run' | 'machine-lock';
export type StepHow = 'over' | 'into' | 'out' | 'back';
export type CaptureKind = 'point' | 'line' | 'arc-via' | 'arc-end' | 'circle-end';

export const MODES: readonly Mode[] = ['edit', 'mdi', 'auto', 'jog', 'ref', 'teach'];

export interface AxisDefinition {
  name: string;
  rotary: boolean;
  /** Its positions, offsets and travel are twice the way of the axis. Joints and paths are the way itself. */
  diameter?: boolean;
  /** Travel in machine coordinates; null: turns without end. */
  min: number | null;
  max: number | null;
  unit: string;
  /** Programs name it; a joint of a linkage that only motors know has false. */
  program: boolean;
}

export interface Kinematics {
  kind: 'cartesian' | 'cartesian-step' | 'x-theta-z' | 'head-ac' | 'arm';
  /** Keys of the machine file: r_a, r_c, upper_arm, forearm, x1, theta0_deg, z0 … */
  [length: string]: string | number | boolean;
}

export interface MachineDefinition {
  name: string;
  title: string;
  dialect: string;
  dialects?: string[];
  axes: AxisDefinition[];
  joints: AxisDefinition[];
  kinematics: Kinematics;
  laser: boolean;
  /** Its tools have the offsets of a lathe. */
  lathe: boolean;
  period_s: number;
  rapid_mm_min: Axes;
  /** Of G-code, in the order in which they are shown. */
  modal_groups: ModalGroup[];
}

export interface ModalGroup {
  group: string;
  /** The variable #4000 + number holds its code. */
  number?: number | null;
  codes: ModalCode[];
}

export interface ModalCode {
  code: string;
  title: string;
  sentence: string;
  /** It says that nothing special is on. */
  quiet: boolean;
}

/** A dialect that the server runs, and what there is to know of its language. */
export interface Dialect {
  name: string;
  language: string;
  /** Of its files, the usual one. */
  ending: string;
  /** That alone says that a file is in it. */
  shows_by_ending: boolean;
  /** Marks of a comment; without the second one it goes to the end of its line. */
  comment: [begin: string, end: string];
  /** What a line looks like. */
  example: string;
  /** What a new program begins with. */
  fresh: string;
  /** Its files are bytes, and a text their listing. */
  is_listing: boolean;
}

export interface MachineEntry {
  name: string;
  title: string;
  definition: string;
  status: Status;
  /** What it has loaded. */
  program: string | null;
  operator: string | null;
  clients: number;
  /** The kinds of programs that it makes, as `recognise` tells them. */
  suits: ProgramKind[];
}

/** For which kind of machine a program looks to be written. */
export type ProgramKind =
  'any' | 'mill' | 'lathe' | 'lathe-c' | 'laser' | 'laser-basic' | 'teach' | 'pattern';

/** What a program looks like: `word` in `line` shows it. */
export interface ProgramLook {
  kind: ProgramKind;
  line: number;
  word: string;
  /** The built-in machine for it; empty: there is none. */
  usual: string;
}

export interface Alarm {
  code: string;
  message: string;
  file: string;
  line: number;
  column: number;
  length?: number;
  severity?: Diagnostic['severity'];
  cause: string;
  remedy: string;
}

export interface StackEntry {
  program: string;
  file: string;
  line: number;
  level: number;
}

export interface Spindle {
  /** As it turns now. */
  speed_rpm: number;
  direction: string;
  /** Constant surface speed; 0: the speed is fixed. */
  surface_m_min: number;
  /** Of a surface speed; 0: there is none. */
  limit_rpm: number;
  load: number | null;
}

export interface Overrides {
  feed: number;
  rapid: number;
  spindle: number;
}

export interface MachineState {
  status: Status;
  mode: Mode;
  program: string;
  file: string;
  line: number;
  text: string;
  time_s: number;
  total_s: number | null;
  motion: number;
  motions: number | null;
  position: { machine: Axes; work: Axes; distance: Axes };
  joints: Axes;
  modal: string[];
  /** `programmed_mm_rev` is 0 where the feed counts minutes. */
  feed: { programmed_mm_min: number; actual_mm_min: number; programmed_mm_rev: number };
  spindle: Spindle;
  tool: number;
  /** Of a lathe: the number that T has brought. */
  tool_offset: number;
  coolant: string;
  power_percent: number | null;
  beam: boolean;
  override: Overrides;
  switches: Partial<Record<SwitchName, boolean>>;
  skip: number[];
  alarm: Alarm | null;
  messages: string[];
  stack: StackEntry[];
  operator: string | null;
  clients: string[];
  /** What those are called who have said it. */
  people: Record<string, string>;
  /** Who asks to operate the machine, and when he gets it, by the clock of the server. */
  request: { client: string; until_ms: number } | null;
  variables_revision: number;
  printed: string;
  /** INPUT of the program waits for a line of the operator. */
  waits_for_input: boolean;
  /** Signals from outside: bits #1000 to #1015, words #1033 to #1035. */
  inputs: number[];
  /** Why the machine does not work at all. */
  fault: string | null;
  /** Why the memory of the machine cannot be written to the server's disk. */
  unsaved: string | null;
  breakpoint: BreakpointHit | null;
}

/** A place to stop at: a line, perhaps with a condition, or any writing of a variable. */
export interface Breakpoint {
  file?: string;
  line?: number;
  condition?: string;
  variable?: string;
}

/** The breakpoint that has stopped the program. */
export interface BreakpointHit extends Breakpoint {
  /** Of a variable's: the line that has written it, and its values. */
  written_line?: number;
  before?: number | null;
  after?: number | null;
  /** Why the condition has no value. */
  trouble?: string;
}

export interface Diagnostic {
  severity: 'error' | 'warning' | 'note';
  code: string;
  message: string;
  line: number;
  column: number;
  length: number;
  cause: string;
  remedy: string;
}

export interface Variable {
  name: string;
  value: number | null;
  /** Level of the call stack that it belongs to; null: common to all. */
  level: number | null;
  changed: boolean;
  /** A name that the program gave it. */
  title?: string;
  scope?: 'local' | 'common' | 'permanent' | 'program';
}

export interface PathEvent {
  event: 'path';
  machine: string;
  run: number;
  done: boolean;
  motions: number;
  time_s: number;
  bounds: { min: number[]; max: number[] } | null;
  files: string[];
  /** Of the program. */
  dialect: string;
  error: Alarm | null;
  /** All that the run has met, also behind `error`, at which a machine stops. */
  findings: Alarm[];
  /** The last motion that a machine would make, and when it rests behind that; null: it does not stop. */
  stop: { motion: number; time_s: number } | null;
  /** Behind the stop not everything was looked at. */
  cut_short: boolean;
}

/** The state at an instant of the run, with the variables of then. */
export type Instant = MachineState & { variables: Variable[] };

export interface ProgramEntry {
  name: string;
  bytes: number;
  modified: string;
}

export interface Revision {
  revision: number;
  bytes: number;
  modified: string;
  /** Its text is still there. */
  kept: boolean;
}

/** Commands that make the program go on or an axis move: whoever gives one wants to see what happens now. */
export const MOVING_COMMANDS: ReadonlySet<string> = new Set([
  'cycle-start',
  'home',
  'jog',
  'mdi',
  'run-to',
  'start-at',
  'step',
]);

/** Commands that must not be carried out late: those, and what changes how they come out. */
export const DATED_COMMANDS: ReadonlySet<string> = new Set([
  ...MOVING_COMMANDS,
  'block-skip',
  'enter',
  'interrupt',
  'mode',
  'override',
  'set-input',
  'measure-offset',
  'set-offset',
  'set-tool',
  'set-variable',
  'switch',
]);

/** The file of a state while an entry in MDI executes: it is in no library. */
export const MDI_ENTRY = 'MDI';

/** A state before the first one has come: nothing is known, nothing moves. */
export const EMPTY_STATE: MachineState = {
  status: 'idle',
  mode: 'auto',
  program: '',
  file: '',
  line: 0,
  text: '',
  time_s: 0,
  total_s: null,
  motion: 0,
  motions: null,
  position: { machine: {}, work: {}, distance: {} },
  joints: {},
  modal: [],
  feed: { programmed_mm_min: 0, actual_mm_min: 0, programmed_mm_rev: 0 },
  spindle: { speed_rpm: 0, direction: 'stop', surface_m_min: 0, limit_rpm: 0, load: null },
  tool: 0,
  tool_offset: 0,
  coolant: 'off',
  power_percent: null,
  beam: false,
  override: { feed: 100, rapid: 100, spindle: 100 },
  switches: {},
  skip: [],
  alarm: null,
  messages: [],
  stack: [],
  operator: null,
  clients: [],
  people: {},
  request: null,
  variables_revision: 0,
  printed: '',
  waits_for_input: false,
  inputs: [0, 0, 0, 0],
  fault: null,
  unsaved: null,
  breakpoint: null,
};
