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

/** A row of the tool table, mm. The machine tells those that are not all 0. */
export interface Tool {
  number: number;
  length_geometry: number;
  length_wear: number;
  radius_geometry: number;
  radius_wear: number;
}

const empty_tool = (number: number): Tool => ({
  number,
  length_geometry: 0,
  length_wear: 0,
  radius_geometry: 0,
  radius_wear: 0,
});

/** The table with empty rows for `numbers` that it does not have. */
export function with_added(tools: Tool[], numbers: number[]): Tool[] {
  const missing = [...new Set(numbers)].filter((n) => !tools.some((tool) => tool.number === n));
  return [...tools, ...missing.map(empty_tool)].sort((a, b) => a.number - b.number);
}
