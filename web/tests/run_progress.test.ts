import { describe, expect, it } from 'vitest';
import { EMPTY_STATE, MDI_ENTRY, type Alarm, type MachineState } from '../src/logic/protocol';
import { progress_of, stop_of, wait_of } from '../src/logic/run_progress';

const state = (changes: Partial<MachineState>): MachineState => ({
  ...EMPTY_STATE,
  mode: 'auto',
  status: 'running',
  time_s: 12,
  motion: 3,
  ...changes,
});

describe('the progress of a run', () => {
  it('is by the place on the path, so a hold takes nothing from what is left', () => {
    const held = progress_of(state({ status: 'held' }), 5, 20, 8);
    expect(held).toEqual({ done_s: 12, left_s: 15, share: 0.25, motion: 3, motions: 8 });
  });
  it('knows nothing of what is left while the path is still counted', () => {
    expect(progress_of(state({}), 5, null, 8).left_s).toBeNull();
  });
  it('is whole at the end, whatever ends without a path', () => {
    const ended = progress_of(state({ status: 'end' }), 19, 20, 8);
    expect(ended).toEqual({ done_s: 12, left_s: 0, share: 1, motion: 8, motions: 8 });
  });
  it('is none while axes are moved by hand, by an entry, or before the start', () => {
    for (const changes of [{ mode: 'jog' }, { file: MDI_ENTRY }, { status: 'idle' }] as const)
      expect(progress_of(state(changes), 5, 20, 8)).toEqual({
        done_s: 0,
        left_s: 20,
        share: 0,
        motion: 0,
        motions: 8,
      });
  });
});

describe('a run that ends with an alarm', () => {
  const alarm = (line: number, code: string): Alarm => ({
    code,
    line,
    message: '',
    file: 'a.nc',
    column: 1,
    cause: '',
    remedy: '',
  });
  it('is another thing than one that waits for an input', () => {
    expect(wait_of(alarm(4, 'INPUT_WAIT'))?.line).toBe(4);
    expect(wait_of(alarm(4, 'PS0112'))).toBeNull();
    expect(wait_of(null)).toBeNull();
  });
  it('stops at the alarm that stands, else at that of its preview', () => {
    expect(stop_of(state({}), null)).toBeNull();
    expect(stop_of(state({ status: 'idle' }), alarm(32, 'PS0007'))?.line).toBe(32);
    expect(stop_of(state({ alarm: alarm(5, 'PS0112') }), alarm(32, 'PS0007'))?.line).toBe(5);
  });
  it('does not stop at an alarm of an entry in MDI', () => {
    expect(stop_of(state({ file: MDI_ENTRY, alarm: alarm(1, 'PS0010') }), null)).toBeNull();
  });
});
