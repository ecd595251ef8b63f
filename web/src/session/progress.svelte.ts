/** Where the run of the machine is on the path of its preview. */
import type { PathPlace } from '../logic/path_store';
import { is_in_run, progress_of, stop_of, wait_of, type Progress } from '../logic/run_progress';
import { panel } from './panel.svelte';

class RunProgress {
  /** Null: no program runs, or its path has not come so far. */
  place = $derived.by((): PathPlace | null => {
    void panel.path_version;
    const { state, definition, preview } = panel;
    if (!definition || !is_in_run(state)) return null;
    return preview.place_of_motion(state.motion, panel.tip_at(state.joints));
  });
  /** Seconds of the program by itself up to there. */
  path_s = $derived(this.place ? panel.preview.seconds_at(this.place) : null);
  /** When the machine stops on its way; null: it does not. */
  stop_s = $derived(panel.path?.stop?.time_s ?? null);
  /** The alarm that ends the run before its end: how long the program takes is not known then. */
  stop = $derived(stop_of(panel.state, panel.path?.stop ? panel.path.error : null));
  /** Where it waits for an input signal, as the preview has found; null: it does not. */
  wait = $derived(this.stop ? null : wait_of(panel.path?.error ?? null));
  total_s = $derived(
    this.stop || panel.path?.error
      ? null
      : (panel.state.total_s ?? (panel.path?.done ? panel.path.time_s : null)),
  );
  now = $derived.by((): Progress =>
    progress_of(panel.state, this.path_s, this.total_s, panel.path?.motions ?? 0),
  );

  /** Seconds of the path at an instant of the run; of one that was, as if nothing had held it. */
  path_seconds(time_s: number): number {
    if (this.path_s === null) return time_s;
    const behind_now = time_s - this.now.done_s;
    return behind_now > 0 ? this.path_s + behind_now : Math.min(time_s, this.path_s);
  }
}

export const progress = new RunProgress();
