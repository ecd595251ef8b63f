/** The contour editor: one contour of a feature or layer, what has been done to it, and what is selected. Of the server it needs what feature_edit asks. */
import {
  type Action,
  type ActionNumbers,
  edits_of_action,
  FORM_ACTIONS,
  type FormAction,
  lacks,
} from '../logic/features/actions';
import { type Selected } from '../logic/features/dimensions';
import { feature_of, is_turned, type Feature, type FeatureLayer } from '../logic/features/document';
import { type Edit, with_diameters } from '../logic/features/edits';
import { by_id, type Element, elements_of, type Point } from '../logic/features/elements';
import { applied, edits_of, type Gesture, nudge } from '../logic/features/gestures';
import { type Preview, outlines_of } from '../logic/features/preview';
import { type Mark } from '../logic/features/pulls';
import { SNAP_KINDS, type SnapKind } from '../logic/features/snap';
import {
  before_step,
  done_again,
  edits_of_steps,
  NO_STEPS,
  type Outline,
  outlines_of_steps,
  type Steps,
  taken_back,
  with_outlines,
  with_step,
} from '../logic/features/steps';
import { feature_edit } from './feature_edit.svelte';
import { features } from './features.svelte';
import { notices } from './notices.svelte';
import { question } from './question.svelte';
import { t } from './words.svelte';

/** How the other layers follow. */
export type LayerRule = 'rebuild' | 'all' | 'only';

export const PLAN_VIEWS = ['contour', 'part', 'difference'] as const;
export type PlanViewName = (typeof PLAN_VIEWS)[number];

interface Drag {
  edits: Edit[];
  outlines: Outline[];
}

class ContourEditor {
  feature = $state.raw<Feature | null>(null);
  /** Null: all layers of the feature. */
  layer = $state.raw<FeatureLayer | null>(null);
  original = $state.raw<Outline[]>([]);
  steps = $state.raw<Steps>(NO_STEPS);
  /** Of a hand that has not let go yet. */
  drag = $state.raw<Drag | null>(null);
  selected = $state.raw<Selected | null>(null);
  /** Selected before that: a join needs two. */
  other = $state.raw<Selected | null>(null);
  /** Whose numbers are asked for. */
  form = $state<FormAction | null>(null);
  rule = $state<LayerRule>('rebuild');
  snaps = $state.raw<ReadonlySet<SnapKind>>(new Set(SNAP_KINDS));
  /** What the last movement has snapped to. */
  mark = $state.raw<Mark | null>(null);
  /** The key has looked for that, and there is none. */
  finds_nothing = $state(false);
  /** What the plan shows: the contour, the part before and after, or what would differ. */
  view = $state<PlanViewName>('contour');
  /** Of the picture that is before, from 0 to 1. */
  share_before = $state(0.5);
  /** Where the pointer is, or what is in the middle. */
  place = $state.raw<Point>([0, 0]);

  is_open = $derived(this.feature !== null);
  turned = $derived(this.feature !== null && is_turned(this.feature));
  outlines = $derived(this.drag?.outlines ?? outlines_of_steps(this.steps, this.original));
  outline = $derived(this.outline_of(this.outlines, this.selected?.island ?? null));
  elements = $derived<Element[]>(this.outline?.elements ?? []);
  /** Of the outer contour, whatever is selected. */
  elements_shown = $derived<Element[]>(this.outline_of(this.outlines, null)?.elements ?? []);
  is_changed = $derived(this.steps.done.length > 0);
  /** What the last step makes is not known yet: another one would have nothing to begin from. */
  waits = $derived(this.steps.done.at(-1)?.outlines === null);

  /** False: there is nothing that could be edited. */
  open(id: string, layer_number: number | null): boolean {
    const feature = features.document && feature_of(features.document, id);
    if (!feature) return false;
    const layer = feature.layers.find(({ n }) => n === layer_number) ?? null;
    const original = original_of(feature, layer);
    if (!original[0]?.elements.length) return false;
    Object.assign(this, { feature, layer, original, steps: NO_STEPS, drag: null });
    Object.assign(this, { selected: null, other: null, form: null, rule: 'rebuild' });
    Object.assign(this, { mark: null, finds_nothing: false, view: 'contour', share_before: 0.5 });
    feature_edit.forget();
    feature_edit.listens = (answer) => this.heard(answer);
    return true;
  }

  /** Asks where something would be lost. False: it stays open. */
  async close(): Promise<boolean> {
    if (this.is_changed && !(await may_discard())) return false;
    this.end();
    return true;
  }

  async apply(): Promise<void> {
    if (await feature_edit.apply()) this.end();
  }

  /** The program is another one: what was edited is not there any more. */
  program_changed(): void {
    const is_lost = feature_edit.wished.length > 0 && !feature_edit.is_applying;
    if (is_lost) notices.say(t('feature.changed-since'), 'refused');
    if (!feature_edit.is_applying) this.end();
  }

  private end(): void {
    this.feature = null;
    feature_edit.listens = null;
    feature_edit.forget();
  }

  select(selected: Selected | null): void {
    const is_same =
      selected?.element === this.selected?.element && selected?.island === this.selected?.island;
    if (this.selected && !is_same) this.other = this.selected;
    if (!is_same || selected?.part !== this.selected?.part) this.forget_mark();
    this.selected = selected;
  }

  /** While a hand drags: what it makes is seen, and is a step when it lets go. */
  pull(gesture: Gesture): void {
    const edits = edits_of(this.before(''), gesture);
    const outlines = this.made(this.before_outlines(''), edits);
    if (!outlines || !edits.length) return;
    this.drag = { edits, outlines };
    this.want();
  }

  let_go(): void {
    const { drag, mark } = this;
    this.drag = null;
    if (drag) this.step(drag.edits, drag.outlines);
    this.mark = mark;
  }

  call_off(): void {
    this.drag = null;
    this.forget_mark();
    this.want();
  }

  /** Dimensions that were typed, and what else is no drag. */
  perform(edits: Edit[], merges = ''): void {
    if (!edits.length || this.waits) return;
    this.step(edits, this.made(this.before_outlines(merges), edits), merges);
  }

  act(action: Action): void {
    if (lacks(action, this.situation) !== null) return;
    if (is_form(action)) this.form = action;
    else this.do(action, {});
  }

  do(action: Action, numbers: ActionNumbers): void {
    this.form = null;
    this.perform(edits_of_action(action, numbers, this.situation));
    if (action === 'delete') this.selected = null;
  }

  get situation() {
    const { elements, selected, other, place } = this;
    return { elements, selected, other, place };
  }

  /** A key, again and again: one step, from what was before the first of them. */
  nudge(way: Point): void {
    const { selected } = this;
    if (!selected || this.waits) return;
    const merges = `nudge ${selected.island} ${selected.element} ${selected.part}`;
    const sum = this.nudged?.merges === merges ? this.nudged.sum : ([0, 0] as Point);
    const whole: Point = [sum[0] + way[0], sum[1] + way[1]];
    const before = this.before(merges);
    const gesture = nudge(before, selected.element, selected.part, whole);
    const edits = gesture ? edits_of(before, gesture) : [];
    if (!edits.length) return;
    this.perform(edits, merges);
    this.nudged = { merges, sum: whole };
  }
  private nudged: { merges: string; sum: Point } | null = null;

  undo(): void {
    this.nudged = null;
    this.forget_mark();
    this.steps = taken_back(this.steps);
    this.want();
  }
  redo(): void {
    this.nudged = null;
    this.forget_mark();
    this.steps = done_again(this.steps);
    this.want();
  }

  set_rule(rule: LayerRule): void {
    this.rule = rule;
    this.want();
  }

  toggle_snap(kind: SnapKind): void {
    const snaps = new Set(this.snaps);
    if (!snaps.delete(kind)) snaps.add(kind);
    this.snaps = snaps;
  }

  private forget_mark(): void {
    this.mark = null;
    this.finds_nothing = false;
  }

  private step(edits: Edit[], outlines: Outline[] | null, merges = ''): void {
    if (merges === '') this.nudged = null;
    this.forget_mark();
    const island = this.selected?.island ?? null;
    const of_island = edits[0].op === 'add-island' || island === null ? {} : { island };
    const own = edits.map((edit) => ({ ...edit, ...of_island }));
    this.steps = with_step(this.steps, { edits: own, outlines, merges });
    this.want();
  }

  private before_outlines(merges: string): Outline[] {
    return before_step(this.steps, merges, this.original);
  }
  /** The contour as it was before steps that belong together. */
  before(merges: string): Element[] {
    const island = this.selected?.island ?? null;
    return this.outline_of(this.before_outlines(merges), island)?.elements ?? [];
  }

  /** With the outline of what is selected as the edits make it; null: only the server knows. */
  private made(outlines: Outline[], edits: Edit[]): Outline[] | null {
    const old = this.outline_of(outlines, this.selected?.island ?? null);
    const elements = old && applied(old.elements, edits);
    return elements ? outlines.map((o) => (o === old ? { ...o, elements } : o)) : null;
  }

  private outline_of(outlines: Outline[], island: number | null): Outline | undefined {
    return outlines.find((outline) => outline.island === island);
  }

  private want(): void {
    const { feature, layer, turned, rule } = this;
    if (!feature) return;
    const island = this.selected?.island ?? null;
    const dragged = (this.drag?.edits ?? []).map((edit) =>
      island === null ? edit : { ...edit, island },
    );
    const edits = [...edits_of_steps(this.steps), ...dragged];
    const target = {
      feature: feature.id,
      ...(layer ? { layer: layer.n } : {}),
      ...(rule === 'rebuild' ? {} : { layers: rule }),
    };
    feature_edit.want(edits.map((e) => ({ ...(turned ? with_diameters(e) : e), ...target })));
  }

  /** What the server makes of all steps is what is drawn from then on. */
  private heard(answer: Preview): void {
    if (this.drag || !this.feature || !this.steps.done.length) return;
    const { id } = this.feature;
    const outlines = outlines_of(answer, id, this.layer?.n ?? null, this.turned);
    if (outlines) this.steps = with_outlines(this.steps, this.steps.done.length, outlines);
    // What could not be done at all leaves the contour as it was.
    else if (this.waits)
      this.steps = with_outlines(
        this.steps,
        this.steps.done.length,
        outlines_of_steps(this.steps, this.original),
      );
    const { selected } = this;
    if (selected && !by_id(this.elements, selected.element)) this.selected = null;
  }
}

const is_form = (action: Action): action is FormAction =>
  (FORM_ACTIONS as readonly string[]).includes(action);

function original_of(feature: Feature, layer: FeatureLayer | null): Outline[] {
  const from = layer ?? feature;
  const turned = is_turned(feature);
  const outer = turned ? feature.contour : (from.nominal ?? []);
  return [
    { island: null, is_closed: !turned, elements: elements_of(outer, !turned, turned) },
    ...(from.nominal_islands ?? []).map((told, island) => ({
      island,
      is_closed: true,
      elements: elements_of(told, true),
    })),
  ];
}

const may_discard = async (): Promise<boolean> =>
  (await question.ask(t('feature.discard-title'), t('feature.discard-why'), [
    { answer: 'discard', label: t('feature.discard'), tone: 'danger' },
  ])) === 'discard';

export const contour_editor = new ContourEditor();
