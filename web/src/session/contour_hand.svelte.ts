/** What a hand does in the plan of a contour: it selects, drags, moves and enlarges the view, by mouse, pen or two fingers. */
import { type Selected } from '../logic/features/dimensions';
import {
  by_id,
  type Element,
  is_arc,
  length,
  type Point,
  radius,
} from '../logic/features/elements';
import { type Frame, in_plane, panned, pinched } from '../logic/features/frame';
import { edits_of } from '../logic/features/gestures';
import {
  type Grip,
  held_by,
  pulled,
  pulls_of,
  scene_of,
  type Snapping,
  without_grid,
} from '../logic/features/pulls';
import { contour_editor } from './contour_editor.svelte';

const CLICK_PX = 4;
const REACH_PX = 9;
const LONG_PRESS_MS = 550;

interface Press {
  at: Point;
  target: Selected | null;
  /** The elements when the hand came down. */
  before: Element[];
  has_moved: boolean;
  pans: boolean;
}

class ContourHand {
  frame: Frame = { scale: 1, origin: [0, 0] };
  /** Where a finger that holds something covers it, on the screen. */
  finger = $state.raw<Point | null>(null);
  private pressed: Press | null = null;
  private readonly fingers = new Map<number, Point>();
  private long: ReturnType<typeof setTimeout> | null = null;

  /** The dimension beside what is selected. */
  get label(): string {
    const { selected, elements, turned } = contour_editor;
    const element = selected && by_id(elements, selected.element);
    if (!selected || !element) return '';
    const short = (value: number): string => String(Math.round(value * 1000) / 1000);
    if (selected.part === 'element')
      return is_arc(element) ? `R${short(radius(element))}` : short(length(element));
    const [x, y] = selected.part === 'start' ? element.from : element.to;
    return turned ? `Z${short(x)} Ø${short(2 * y)}` : `X${short(x)} Y${short(y)}`;
  }

  press(
    event: PointerEvent,
    at: Point,
    target: Selected | null,
    open_menu: (at: Point) => void,
  ): void {
    this.fingers.set(event.pointerId, at);
    this.end_long_press();
    if (this.fingers.size > 1) return this.pinch_begins();
    const pans = event.button === 1 || (event.button === 0 && target === null);
    if (event.button === 2) return;
    if (target && !pans) contour_editor.select(target);
    const before = contour_editor.elements;
    this.pressed = { at, target, before, has_moved: false, pans };
    if (event.pointerType === 'touch' && target) this.finger = at;
    if (event.pointerType !== 'mouse')
      this.long = setTimeout(() => this.long_press(at, open_menu), LONG_PRESS_MS);
  }

  /** The frame, where that is another one now. */
  move(event: PointerEvent, at: Point, frame: Frame): Frame | null {
    contour_editor.place = in_plane(frame, at);
    const last = this.fingers.get(event.pointerId);
    if (this.fingers.size > 1) return this.pinch(event.pointerId, at, frame);
    if (last) this.fingers.set(event.pointerId, at);
    if (this.finger) this.finger = at;
    const { pressed } = this;
    if (!pressed || !last) return null;
    const far = Math.hypot(at[0] - pressed.at[0], at[1] - pressed.at[1]);
    if (far > CLICK_PX) pressed.has_moved = true;
    if (!pressed.has_moved) return null;
    this.end_long_press();
    if (pressed.pans) return panned(frame, [at[0] - last[0], at[1] - last[1]]);
    this.drag(pressed, in_plane(frame, at), frame);
    return null;
  }

  release(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    this.end_long_press();
    const { pressed } = this;
    this.pressed = null;
    this.finger = null;
    if (!pressed) return;
    if (event.type === 'pointercancel') contour_editor.call_off();
    else if (contour_editor.drag) contour_editor.let_go();
    else if (!pressed.has_moved && !pressed.target) contour_editor.select(null);
  }

  private pinch_begins(): void {
    this.pressed = null;
    this.finger = null;
    if (contour_editor.drag) contour_editor.call_off();
  }

  private pinch(id: number, at: Point, frame: Frame): Frame | null {
    const before = [...this.fingers.values()].slice(0, 2) as [Point, Point];
    this.fingers.set(id, at);
    const now = [...this.fingers.values()].slice(0, 2) as [Point, Point];
    return pinched(frame, before, now);
  }

  private long_press(at: Point, open_menu: (at: Point) => void): void {
    this.pressed = null;
    this.finger = null;
    contour_editor.place = in_plane(this.frame, at);
    open_menu(at);
  }
  private end_long_press(): void {
    if (this.long) clearTimeout(this.long);
    this.long = null;
  }

  private drag({ target, before, at }: Press, place: Point, frame: Frame): void {
    const element = target && by_id(before, target.element);
    if (!target || !element || contour_editor.waits) return;
    const grip = { element, part: target.part, before };
    const pull = pulled(grip, in_plane(frame, at), place, snapping(grip, frame));
    if (!pull) return;
    contour_editor.pull(pull.gesture);
    contour_editor.mark = pull.mark;
  }

  /** Without a hand: what is selected goes to what is nearest, and with the same key again to what comes next. */
  snap_next(): void {
    const { selected } = contour_editor;
    if (!selected || contour_editor.waits) return;
    const merges = `snap ${selected.island} ${selected.element} ${selected.part}`;
    const is_again = contour_editor.steps.done.at(-1)?.merges === merges;
    this.turn = is_again ? this.turn + 1 : 0;
    const before = contour_editor.before(merges);
    const element = by_id(before, selected.element);
    if (!element) return;
    const grip = { element, part: selected.part, before };
    const own = snapping(grip, this.frame);
    const pulls = pulls_of(grip, { ...own, kinds: without_grid(own.kinds) });
    const pull = pulls[this.turn % Math.max(1, pulls.length)];
    if (!pull) return void (contour_editor.finds_nothing = true);
    contour_editor.perform(edits_of(before, pull.gesture), merges);
    contour_editor.mark = pull.mark;
  }
  private turn = 0;

  /** What holds where the keys have moved it to. */
  look_at_place(): void {
    const { selected, elements } = contour_editor;
    const element = selected && by_id(elements, selected.element);
    if (!element) return;
    const grip = { element, part: selected.part, before: elements };
    contour_editor.mark = held_by(grip, snapping(grip, this.frame));
  }
}

function snapping(grip: Grip, { scale }: Frame): Snapping {
  const original = contour_editor.original.flatMap(({ elements }) => elements);
  const scene = scene_of(grip, original, 1 / scale);
  return { scene, kinds: contour_editor.snaps, reach: REACH_PX / scale };
}

export const contour_hand = new ContourHand();
