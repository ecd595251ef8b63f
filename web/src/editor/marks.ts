/** What lies over the text: the block that executes, the line that is chosen, the breakpoints. */
import {
  type Extension,
  RangeSet,
  RangeSetBuilder,
  StateEffect,
  StateField,
  type Text,
  type Transaction,
} from '@codemirror/state';
import { type BlockInfo, Decoration, EditorView, GutterMarker, gutter } from '@codemirror/view';
import type { Breakpoint } from '../logic/protocol';

export interface Marks {
  executing: number;
  chosen: number;
  breakpoints: Breakpoint[];
  /** Lines that belong together: of a feature. */
  range: [first: number, last: number] | null;
}

/** A longer range is marked so far. */
const MOST_MARKED = 20_000;

const set_marks = StateEffect.define<Marks>();

const marks = StateField.define<Marks>({
  create: () => ({ executing: 0, chosen: 0, breakpoints: [], range: null }),
  update(value, transaction) {
    for (const effect of transaction.effects) if (effect.is(set_marks)) return effect.value;
    return transaction.docChanged ? carried(value, transaction) : value;
  },
  provide: (field) =>
    EditorView.decorations.from(field, (value) => (view) => lines(view.state.doc, value)),
});

/** Until the session says where the lines are now: where their first characters went. */
function carried(
  { executing, chosen, breakpoints, range }: Marks,
  transaction: Transaction,
): Marks {
  const line_of = (line: number): number => line_behind(transaction, line) ?? 0;
  return {
    executing: line_of(executing),
    chosen: line_of(chosen),
    breakpoints: breakpoints.map((b) => ({ ...b, line: line_of(b.line ?? 0) })),
    range: range && [line_of(range[0]), line_of(range[1])],
  };
}

/** Null: the line is gone. */
function line_behind({ startState, newDoc, changes }: Transaction, line: number): number | null {
  if (line < 1 || line > startState.doc.lines) return null;
  const { from, to } = startState.doc.line(line);
  const is_gone = changes.touchesRange(from, to) === 'cover' && to > from;
  return is_gone ? null : newDoc.lineAt(changes.mapPos(from, 1)).number;
}

const executing_line = Decoration.line({ class: 'cm-executing' });
const chosen_line = Decoration.line({ class: 'cm-chosen' });
const line_of_range = Decoration.line({ class: 'cm-of-feature' });

function marked_range(range: Marks['range']): [number, Decoration][] {
  if (!range) return [];
  const [first, last] = range;
  const length = Math.max(0, Math.min(MOST_MARKED, last - first + 1));
  return Array.from({ length }, (_, i) => [first + i, line_of_range]);
}

function lines(doc: Text, { executing, chosen, range }: Marks) {
  const builder = new RangeSetBuilder<Decoration>();
  const wanted: [number, Decoration][] = [
    ...marked_range(range),
    [chosen, chosen_line],
    [executing, executing_line],
  ];
  wanted.sort((a, b) => a[0] - b[0]);
  for (const [line, decoration] of wanted) {
    if (line >= 1 && line <= doc.lines)
      builder.add(doc.line(line).from, doc.line(line).from, decoration);
  }
  return builder.finish();
}

class Dot extends GutterMarker {
  constructor(
    readonly condition: string,
    readonly executing: boolean,
    readonly is_set: boolean,
  ) {
    super();
  }
  override eq(other: Dot): boolean {
    return (
      other.condition === this.condition &&
      other.executing === this.executing &&
      other.is_set === this.is_set
    );
  }
  override toDOM(): HTMLElement {
    const mark = document.createElement('span');
    mark.className = `cm-dot${this.is_set ? ' set' : ''}${this.condition ? ' conditional' : ''}${this.executing ? ' here' : ''}`;
    mark.title = this.condition;
    mark.textContent = this.is_set ? (this.condition ? '◆' : '●') : this.executing ? '▶' : '';
    return mark;
  }
}

function dots(doc: Text, value: Marks): RangeSet<GutterMarker> {
  const by_line = new Map<number, Dot>();
  for (const b of value.breakpoints) {
    if (b.line) by_line.set(b.line, new Dot(b.condition ?? '', b.line === value.executing, true));
  }
  if (value.executing && !by_line.has(value.executing))
    by_line.set(value.executing, new Dot('', true, false));
  const builder = new RangeSetBuilder<GutterMarker>();
  for (const line of [...by_line.keys()].sort((a, b) => a - b)) {
    if (line <= doc.lines)
      builder.add(doc.line(line).from, doc.line(line).from, by_line.get(line)!);
  }
  return builder.finish();
}

export interface GutterWishes {
  toggle(line: number): void;
  condition(line: number): void;
}

export function marks_extension(wishes: GutterWishes): Extension {
  return [
    marks,
    gutter({
      class: 'cm-breakpoints',
      markers: (view) => dots(view.state.doc, view.state.field(marks)),
      lineMarkerChange: (update) => update.startState.field(marks) !== update.state.field(marks),
      initialSpacer: () => new Dot('', false, false),
      domEventHandlers: { mousedown: pressed(wishes), contextmenu: prevented },
    }),
  ];
}

type GutterHandler = (view: EditorView, block: BlockInfo, event: Event) => boolean;

const pressed =
  (wishes: GutterWishes): GutterHandler =>
  (view, block, event) => {
    const line = view.state.doc.lineAt(block.from).number;
    const mouse = event as MouseEvent;
    if (mouse.button === 2 || mouse.shiftKey) wishes.condition(line);
    else wishes.toggle(line);
    return prevented(view, block, event);
  };

const prevented: GutterHandler = (_view, _block, event) => {
  event.preventDefault();
  return true;
};

export function show_marks(view: EditorView, value: Marks): void {
  const before = view.state.field(marks);
  const same =
    before.executing === value.executing &&
    before.chosen === value.chosen &&
    before.breakpoints === value.breakpoints &&
    String(before.range) === String(value.range);
  if (!same) view.dispatch({ effects: set_marks.of(value) });
}
