/** The keys of the contour editor. */
import { ACTION_KEYS } from '../logic/features/actions';
import type { Point } from '../logic/features/elements';
import { contour_editor } from './contour_editor.svelte';
import { contour_hand } from './contour_hand.svelte';

const ARROWS: Record<string, Point> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

const SNAP_KEY = 's';

const step_of = ({ shiftKey, altKey }: KeyboardEvent): number =>
  shiftKey ? 1 : altKey ? 0.01 : 0.1;

/** True: the key was meant for the contour. */
export function contour_key(event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey) return history_key(event);
  const way = ARROWS[event.key];
  if (way) {
    const by = step_of(event);
    contour_editor.nudge([by * way[0], by * way[1]]);
    contour_hand.look_at_place();
    return true;
  }
  if (event.key.toLowerCase() === SNAP_KEY && !event.altKey) {
    contour_hand.snap_next();
    return true;
  }
  const action = ACTION_KEYS[event.key] ?? ACTION_KEYS[event.key.toLowerCase()];
  if (!action || event.altKey) return event.key === 'Enter' && enter();
  contour_editor.act(action);
  return true;
}

function enter(): boolean {
  void contour_editor.apply();
  return true;
}

function history_key(event: KeyboardEvent): boolean {
  const key = event.key.toLowerCase();
  if (key === 'z' && !event.shiftKey) contour_editor.undo();
  else if (key === 'y' || key === 'z') contour_editor.redo();
  else return false;
  return true;
}
