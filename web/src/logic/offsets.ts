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
