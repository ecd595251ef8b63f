/** What each key of the keymap does. */
import { type CommandName, binding_of } from '../logic/keymap';
import type { Colouring } from '../logic/colour_scale';
import { contour_editor } from './contour_editor.svelte';
import { dialogs } from './dialogs.svelte';
import { dock } from './dock.svelte';
import { documents } from './documents.svelte';
import { do_again, take_back } from './edits';
import { editor_keys } from './editor_keys';
import { jog } from './jog';
import { manual } from './manual.svelte';
import {
  cycle_start,
  hold_or_next_problem,
  interrupt,
  reset,
  set_mode,
  set_skip,
  step,
  toggle,
} from './operator';
import { panel } from './panel.svelte';
import { picture_keys } from './picture_keys';
import { part } from './part.svelte';
import { places } from './places';
import { preferences } from './preferences.svelte';
import { problems } from './problems.svelte';
import { question } from './question.svelte';
import { slider } from './slider.svelte';
import { teaching } from './teaching.svelte';

const colourings = (): Colouring[] =>
  panel.definition?.laser ? ['power', 'feed', 'speed'] : ['tool', 'feed', 'speed'];
function next_colouring(): void {
  const choices = colourings();
  preferences.colouring = choices[(choices.indexOf(preferences.colouring) + 1) % choices.length];
}
const SLIDER_STEP_S = 1;

const feed = (by: number): unknown =>
  panel.override('feed', Math.min(200, Math.max(0, panel.state.override.feed + by)));
const look = (view: 'iso' | 'top' | 'front' | 'right') => () => {
  picture_keys.picture?.look(view);
  picture_keys.picture?.fit();
};
const go_to_finding = (way: 1 | -1): void => {
  if (part.findings.length) dock.tab = 'problems';
  part.beside(way);
};
const slide = (by: number): void => slider.move_to((slider.time_s ?? panel.state.time_s) + by);

const ACTIONS: Record<CommandName, () => unknown> = {
  'cycle-start': cycle_start,
  'feed-hold': hold_or_next_problem,
  reset,
  interrupt,
  'feed-up': () => feed(10),
  'feed-down': () => feed(-10),
  'step-over': () => step('over'),
  'step-into': () => step('into'),
  'step-out': () => step('out'),
  'step-back': () => step('back'),
  'run-to-line': () => places.run_to(documents.cursor),
  'start-at-line': () => places.start_at(documents.cursor),
  'toggle-breakpoint': () => places.toggle_breakpoint(documents.cursor),
  'edit-condition': () => places.edit_condition(documents.cursor),
  'mode-edit': () => set_mode('edit'),
  'mode-mdi': () => set_mode('mdi'),
  'mode-auto': () => set_mode('auto'),
  'mode-jog': () => set_mode('jog'),
  'mode-ref': () => set_mode('ref'),
  'mode-teach': () => set_mode('teach'),
  'single-block': () => toggle('single-block'),
  'optional-stop': () => toggle('optional-stop'),
  'block-skip': () => set_skip(panel.state.skip.length ? [] : [1]),
  'dry-run': () => toggle('dry-run'),
  'machine-lock': () => toggle('machine-lock'),
  'jog-x-plus': () => jog.begin('X', 1),
  'jog-x-minus': () => jog.begin('X', -1),
  'jog-y-plus': () => jog.begin('Y', 1),
  'jog-y-minus': () => jog.begin('Y', -1),
  'jog-z-plus': () => jog.begin('Z', 1),
  'jog-z-minus': () => jog.begin('Z', -1),
  'capture-point': () => teaching.capture('point'),
  'view-iso': look('iso'),
  'view-top': look('top'),
  'view-front': look('front'),
  'view-right': look('right'),
  fit: () => picture_keys.picture?.fit_all(),
  colouring: next_colouring,
  'slider-back': () => slide(-SLIDER_STEP_S),
  'slider-forward': () => slide(SLIDER_STEP_S),
  'slider-now': () => slider.now(),
  save: () => documents.save(),
  library: () => dialogs.show('library'),
  'load-text': () => documents.load_text(),
  'undo-edit': take_back,
  'redo-edit': do_again,
  'focus-editor': () => editor_keys.editor?.focus(),
  'focus-picture': () => picture_keys.picture?.canvas.focus(),
  'next-tab': () => dock.turn(1),
  'previous-tab': () => dock.turn(-1),
  'take-operation': () => panel.take(),
  'next-problem': () => problems.beside(1),
  'previous-problem': () => problems.beside(-1),
  'next-finding': () => go_to_finding(1),
  'previous-finding': () => go_to_finding(-1),
  manual: () => manual.help(),
  help: () => dialogs.show('help'),
};

const is_text = (target: EventTarget | null): boolean =>
  target instanceof HTMLElement &&
  (target.isContentEditable || /^(INPUT|TEXTAREA|SELECT)$/.test(target.tagName));

/** Jog keys are only taken where they jog: elsewhere arrows belong to whatever has the focus. */
const may_jog = (): boolean => ['jog', 'teach'].includes(panel.state.mode) && panel.operates;

export function key_down(event: KeyboardEvent): void {
  if (event.defaultPrevented || dialogs.open || question.asked || contour_editor.is_open) return;
  const binding = binding_of(event, is_text(event.target));
  if (!binding || (binding.held && !may_jog())) return;
  event.preventDefault();
  if (binding.held && event.repeat) return;
  editor_keys.editor?.flush();
  void ACTIONS[binding.command]();
}

export function key_up(event: KeyboardEvent): void {
  if (binding_of(event, false)?.held) jog.end();
}
