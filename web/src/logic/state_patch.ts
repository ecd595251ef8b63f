/** Takes a `state` event over: keys that it leaves out keep their object, so what is drawn from them stays as it is. */
import type { MachineState } from './protocol';

const OF_THE_FRAME = new Set(['event', 'machine']);

export function patched(state: MachineState, event: Record<string, unknown>): MachineState {
  const next: Record<string, unknown> = { ...state };
  for (const key of Object.keys(event)) if (!OF_THE_FRAME.has(key)) next[key] = event[key];
  return next as unknown as MachineState;
}
