/** What a hand does in the plan of a contour: it selects, drags, moves and enlarges the view, by mouse, pen or two fingers. */
import { type Part, type Selected } from '../logic/features/dimensions';
import {
  by_id,
  type Element,
  is_arc,
  length,
  midpoint,
  type Point,
  radius,
} from '../logic/features/elements';
import { type Frame, in_plane, panned, pinched } from '../logic/features/frame';
import { drag_of, type Gesture, radius_through } from '../logic/features/gestures';
import { grid_of, on_grid, snapped, snapped_edge, type SnapScene } from '../logic/features/snap';
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
    if (event.pointerType !== 'mouse')
      this.long = setTimeout(() => this.long_press(at, open_menu), LONG_PRESS_MS);
  }

  /** The frame, where that is another one now. */
  move(event: PointerEvent, at: Point, frame: Frame): Frame | null {
    contour_editor.place = in_plane(frame, at);
    const last = this.fingers.get(event.pointerId);
    if (this.fingers.size > 1) return this.pinch(event.pointerId, at, frame);
    if (last) this.fingers.set(event.pointerId, at);
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
    if (!pressed) return;
    if (event.type === 'pointercancel') contour_editor.call_off();
    else if (contour_editor.drag) contour_editor.let_go();
    else if (!pressed.has_moved && !pressed.target) contour_editor.select(null);
  }

  private pinch_begins(): void {
    this.pressed = null;
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
    const gesture = this.gesture(
      element,
      target.part,
      place,
      { before, from: in_plane(frame, at) },
      frame,
    );
    if (gesture) contour_editor.pull(gesture);
  }

  private gesture(
    element: Element,
    part: Part,
    place: Point,
    { before, from }: { before: Element[]; from: Point },
    frame: Frame,
  ): Gesture | null {
    const { snaps } = contour_editor;
    const scene = this.scene(element, before, part, frame);
    const reach = REACH_PX / frame.scale;
    const { id } = element;
    if (part !== 'element') {
      const { at } = snapped(place, scene, snaps, reach);
      return { kind: 'corner', element: id, at_end: part === 'end', to: at };
    }
    if (!is_arc(element)) {
      const { by } = snapped_edge(element, drag_of(element, from, place), scene, snaps, reach);
      return { kind: 'edge', element: id, by };
    }
    const r = this.radius_at(element, before, place);
    if (r === null) return null;
    return { kind: 'arc', element: id, radius: snaps.has('grid') ? on_grid(r, scene.grid_mm) : r };
  }

  /** A circle of two halves follows the pointer from its middle. */
  private radius_at(element: Element, before: Element[], place: Point): number | null {
    const is_round = before.length === 2 && before.every((e) => Math.abs(e.bulge) === 1);
    if (!is_round) return radius_through(element, place);
    const [a, b] = before.map(midpoint);
    return Math.hypot(place[0] - (a[0] + b[0]) / 2, place[1] - (a[1] + b[1]) / 2);
  }

  private scene(element: Element, before: Element[], part: Part, frame: Frame): SnapScene {
    const moving = part === 'end' ? element.to : element.from;
    const meets = ({ from, to }: Element): boolean =>
      [from, to].some(([x, y]) => x === moving[0] && y === moving[1]);
    const still = before.filter((each) => each.id !== element.id && !meets(each));
    const anchors = before
      .filter(meets)
      .map(({ from, to }) => (from[0] === moving[0] && from[1] === moving[1] ? to : from));
    const { original } = contour_editor;
    return {
      still,
      original: original.flatMap(({ elements }) => elements),
      anchors,
      grid_mm: grid_of(1 / frame.scale),
    };
  }
}

export const contour_hand = new ContourHand();
