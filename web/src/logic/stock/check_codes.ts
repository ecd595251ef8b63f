/** The checks of the part, by their codes, as docs/stock.md lists them: which of them a machine can have. */
import type { MachineDefinition } from '../protocol';

const OF_ANY = ['OT0500', 'OT0501', 'STOCK_ZERO_MOVED', 'STOCK_MISSED', 'CELL_ENLARGED'] as const;
const OF_TOOLS = [
  'RAPID_IN_STOCK', 'SPINDLE_STOPPED', 'SPINDLE_DIRECTION', 'FLUTE_LENGTH', 'SHANK_COLLISION', 'HOLDER_COLLISION',
  'FIXTURE_COLLISION', 'NOT_CENTRE_CUTTING', 'AXIAL_TOOL_SIDEWAYS', 'PROBE_IN_STOCK', 'TAP_WITHOUT_HOLE', 'THREAD_PITCH',
  'FEED_PER_TOOTH', 'CUT_DEPTH', 'CUT_WIDTH', 'CUTTING_SPEED', 'CUTTING_POWER', 'TOOL_LENGTH', 'STOCK_LOOSE', 'TOOL_IMPORT',
] as const; // prettier-ignore
const OF_INSERTS = ['INSERT_COLLISION'] as const;
const OF_DESIGN = ['GOUGE', 'EXCESS'] as const;

export type CheckCode =
  | (typeof OF_ANY)[number]
  | (typeof OF_TOOLS)[number]
  | (typeof OF_INSERTS)[number]
  | (typeof OF_DESIGN)[number];

/** Those that the machine can have, and behind them what is left out though it cannot. */
export function checks_of_machine(
  definition: Pick<MachineDefinition, 'lathe' | 'laser'> | null,
  has_design: boolean,
  left_out: readonly string[],
): string[] {
  const own: string[] = [
    ...(definition?.laser ? [] : OF_TOOLS),
    ...(definition?.lathe ? OF_INSERTS : []),
    ...(has_design ? OF_DESIGN : []),
    ...OF_ANY,
  ];
  return [...own, ...left_out.filter((code) => !own.includes(code))];
}

const ALL: readonly string[] = [...OF_TOOLS, ...OF_INSERTS, ...OF_DESIGN, ...OF_ANY];

/** One that the page has a name for. */
export const is_check = (code: string): code is CheckCode => ALL.includes(code);
