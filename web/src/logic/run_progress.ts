/** How far a run has come, and how long it still takes: from the place on the path, whatever holds and overrides did. */
import { MDI_ENTRY, type Alarm, type MachineState } from './protocol';

export interface Progress {
  /** Seconds since the run began, holds included. */
  done_s: number;
  /** Seconds that the rest takes at 100 %; null: not known yet. */
  left_s: number | null;
  /** 0 to 1. */
  share: number;
  motion: number;
  motions: number;
}

/** The alarm that ends the run: the one that stands, else the one that the preview has come to. */
export function stop_of(state: MachineState, of_path: Alarm | null): Alarm | null {
  return state.alarm && state.file !== MDI_ENTRY && state.alarm.line > 0 ? state.alarm : of_path;
}

/** What the preview ends in where the program only goes on when an input signal changes. */
export const INPUT_WAIT = 'INPUT_WAIT';

/** Where the preview waits for an input signal; null: it does not. */
export const wait_of = (of_path: Alarm | null): Alarm | null =>
  of_path?.code === INPUT_WAIT ? of_path : null;

/** Whether what the machine tells of time and motion is that of the program, not of a jog or of an entry in MDI. */
export function is_in_run(state: MachineState): boolean {
  const { status, mode, file } = state;
  return status !== 'idle' && (mode === 'auto' || mode === 'edit') && file !== MDI_ENTRY;
}

/**
 * `path_s`: when the program by itself would be where the tool stands; null: there is no path yet. `total_s`: when it would
 * end; null: not known yet.
 */
export function progress_of(
  state: MachineState,
  path_s: number | null,
  total_s: number | null,
  motions: number,
): Progress {
  if (!is_in_run(state)) return { done_s: 0, left_s: total_s, share: 0, motion: 0, motions };
  const done_s = state.time_s;
  if (state.status === 'end') return { done_s, left_s: 0, share: 1, motion: motions, motions };
  const at_s = path_s ?? 0;
  return {
    done_s,
    left_s: total_s === null ? null : Math.max(0, total_s - at_s),
    share: total_s ? Math.min(1, at_s / total_s) : 0,
    motion: state.motion,
    motions: Math.max(motions, state.motion),
  };
}
