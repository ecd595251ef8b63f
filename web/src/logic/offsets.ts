/** Work offsets as the table shows them: a row for each coordinate system. */
import type { Axes } from './protocol';

/** As the server tells them: one axis of one system. */
export interface OffsetRow {
  offset: string;
  axis: string;
  value: number;
}

export interface WorkOffset {
  name: string;
  values: Axes;
}

export function by_system(rows: OffsetRow[]): WorkOffset[] {
  const systems = new Map<string, WorkOffset>();
  for (const { offset, axis, value } of rows) {
    const system = systems.get(offset) ?? { name: offset, values: {} };
    system.values[axis] = value;
    systems.set(offset, system);
  }
  return [...systems.values()];
}

const FURTHER = /^G54\.1 P(\d+)$/;
const MOST_FURTHER = 300;
const rank = ({ name }: WorkOffset): number => Number(FURTHER.exec(name)?.[1] ?? 0);

export const further_system = (number: number): string | null =>
  Number.isInteger(number) && number >= 1 && number <= MOST_FURTHER ? `G54.1 P${number}` : null;

/** The table with rows of 0 for those of the systems G54.1 P… among `names` that it does not have. */
export function with_systems(systems: WorkOffset[], names: string[]): WorkOffset[] {
  const missing = [...new Set(names)].filter(
    (name) => FURTHER.test(name) && !systems.some((system) => system.name === name),
  );
  const rows = missing.map((name): WorkOffset => ({ name, values: {} }));
  return [...systems, ...rows].sort((a, b) => rank(a) - rank(b));
}

/**
 * The value with which `axis` reads 0 in a system where it stands now, mm. `reads` is what it reads in the system that
 * is in force; EXT, the shifts of G52 and G92 and the length of the tool are in that already. To six decimals.
 */
export function zero_here(
  system: WorkOffset,
  axis: string,
  in_force: WorkOffset,
  reads: number,
): number {
  const shifts_all = system.name === 'EXT';
  const lies = (shifts_all ? system : in_force).values[axis] ?? 0;
  return Math.round((lies + reads) * 1e6) / 1e6;
}

/** A row of the tool table, mm. The machine tells those that are not all 0. */
export interface Tool {
  number: number;
  length_geometry: number;
  length_wear: number;
  radius_geometry: number;
  radius_wear: number;
}

export const empty_tool = (number: number): Tool => ({
  number,
  length_geometry: 0,
  length_wear: 0,
  radius_geometry: 0,
  radius_wear: 0,
});

/** The table with empty rows for `numbers` that it does not have. */
export function with_added<Row extends { number: number }>(
  tools: Row[],
  numbers: number[],
  empty: (number: number) => Row,
): Row[] {
  const missing = [...new Set(numbers)].filter((n) => !tools.some((tool) => tool.number === n));
  return [...tools, ...missing.map(empty)].sort((a, b) => a.number - b.number);
}
