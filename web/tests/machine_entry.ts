import type { MachineEntry } from '../src/logic/protocol';

/** A machine that nobody watches and nothing runs on. */
export const machine_entry = (
  name: string,
  definition: string,
  more: Partial<MachineEntry> = {},
): MachineEntry => ({
  name,
  title: '',
  definition,
  status: 'idle',
  program: null,
  operator: null,
  clients: 0,
  suits: [],
  ...more,
});
