/**
 * Every command of the panel and its keys, in one table: the handler reads it, `?` shows it, tests hold it free of doubles.
 * Keys are those of KeyboardEvent.code without their prefix, so that they stay where they are on any layout.
 */

export type Group = 'run' | 'step' | 'modes' | 'switches' | 'jog' | 'picture' | 'program' | 'panel';

export interface Binding {
  command: string;
  group: Group;
  /** `Shift+F11`, `Alt+Digit1`; several for one command are alternatives. */
  keys: string[];
  /** Also while a text field has the focus. */
  in_text?: boolean;
  /** Held down: begins with the key and ends when it is let go. */
  held?: boolean;
}

export const BINDINGS = [
  { command: 'cycle-start', group: 'run', keys: ['Ctrl+Enter'], in_text: true },
  { command: 'feed-hold', group: 'run', keys: ['F8', 'Pause'], in_text: true },
  { command: 'reset', group: 'run', keys: ['Ctrl+Shift+Backspace'], in_text: true },
  { command: 'interrupt', group: 'run', keys: ['Alt+KeyI'], in_text: true },
  { command: 'feed-up', group: 'run', keys: ['Alt+ArrowUp'], in_text: true },
  { command: 'feed-down', group: 'run', keys: ['Alt+ArrowDown'], in_text: true },
  { command: 'step-over', group: 'step', keys: ['F10'], in_text: true },
  { command: 'step-into', group: 'step', keys: ['F11', 'Alt+F10'], in_text: true },
  { command: 'step-out', group: 'step', keys: ['Shift+F11', 'Shift+F10'], in_text: true },
  { command: 'step-back', group: 'step', keys: ['Ctrl+F10'], in_text: true },
  { command: 'run-to-line', group: 'step', keys: ['F4'], in_text: true },
  { command: 'start-at-line', group: 'step', keys: ['Shift+F4'], in_text: true },
  { command: 'toggle-breakpoint', group: 'step', keys: ['F9'], in_text: true },
  { command: 'edit-condition', group: 'step', keys: ['Shift+F9'], in_text: true },
  { command: 'mode-edit', group: 'modes', keys: ['Alt+Digit1'], in_text: true },
  { command: 'mode-mdi', group: 'modes', keys: ['Alt+Digit2'], in_text: true },
  { command: 'mode-auto', group: 'modes', keys: ['Alt+Digit3'], in_text: true },
  { command: 'mode-jog', group: 'modes', keys: ['Alt+Digit4'], in_text: true },
  { command: 'mode-ref', group: 'modes', keys: ['Alt+Digit5'], in_text: true },
  { command: 'mode-teach', group: 'modes', keys: ['Alt+Digit6'], in_text: true },
  { command: 'single-block', group: 'switches', keys: ['Alt+KeyS'], in_text: true },
  { command: 'optional-stop', group: 'switches', keys: ['Alt+KeyO'], in_text: true },
  { command: 'block-skip', group: 'switches', keys: ['Alt+KeyK'], in_text: true },
  { command: 'dry-run', group: 'switches', keys: ['Alt+KeyY'], in_text: true },
  { command: 'machine-lock', group: 'switches', keys: ['Alt+KeyL'], in_text: true },
  { command: 'jog-x-plus', group: 'jog', keys: ['ArrowRight'], held: true },
  { command: 'jog-x-minus', group: 'jog', keys: ['ArrowLeft'], held: true },
  { command: 'jog-y-plus', group: 'jog', keys: ['ArrowUp'], held: true },
  { command: 'jog-y-minus', group: 'jog', keys: ['ArrowDown'], held: true },
  { command: 'jog-z-plus', group: 'jog', keys: ['PageUp'], held: true },
  { command: 'jog-z-minus', group: 'jog', keys: ['PageDown'], held: true },
  { command: 'capture-point', group: 'jog', keys: ['Alt+KeyP'], in_text: true },
  { command: 'view-iso', group: 'picture', keys: ['Digit0'] },
  { command: 'view-top', group: 'picture', keys: ['Digit1'] },
  { command: 'view-front', group: 'picture', keys: ['Digit2'] },
  { command: 'view-right', group: 'picture', keys: ['Digit3'] },
  { command: 'fit', group: 'picture', keys: ['KeyF'] },
  { command: 'colouring', group: 'picture', keys: ['KeyC'] },
  { command: 'slider-back', group: 'picture', keys: ['Comma'] },
  { command: 'slider-forward', group: 'picture', keys: ['Period'] },
  { command: 'slider-now', group: 'picture', keys: ['KeyN'] },
  { command: 'save', group: 'program', keys: ['Ctrl+KeyS'], in_text: true },
  { command: 'library', group: 'program', keys: ['Ctrl+KeyO'], in_text: true },
  { command: 'load-text', group: 'program', keys: ['F5'], in_text: true },
  { command: 'next-problem', group: 'program', keys: ['Alt+F8'], in_text: true },
  {
    command: 'previous-problem',
    group: 'program',
    keys: ['Shift+F8', 'Alt+Shift+F8'],
    in_text: true,
  },
  { command: 'next-finding', group: 'program', keys: ['F3'], in_text: true },
  { command: 'previous-finding', group: 'program', keys: ['Shift+F3'], in_text: true },
  { command: 'undo-edit', group: 'program', keys: ['Ctrl+KeyZ'] },
  { command: 'redo-edit', group: 'program', keys: ['Ctrl+Shift+KeyZ', 'Ctrl+KeyY'] },
  { command: 'focus-editor', group: 'panel', keys: ['Alt+KeyE'], in_text: true },
  { command: 'focus-picture', group: 'panel', keys: ['Alt+KeyV'], in_text: true },
  { command: 'next-tab', group: 'panel', keys: ['Alt+ArrowRight'], in_text: true },
  { command: 'previous-tab', group: 'panel', keys: ['Alt+ArrowLeft'], in_text: true },
  { command: 'take-operation', group: 'panel', keys: ['Alt+KeyT'], in_text: true },
  { command: 'manual', group: 'panel', keys: ['F1'], in_text: true },
  { command: 'help', group: 'panel', keys: ['?'] },
] as const satisfies readonly Binding[];

export type CommandName = (typeof BINDINGS)[number]['command'];

export const GROUPS: readonly Group[] = [
  'run',
  'step',
  'modes',
  'switches',
  'jog',
  'picture',
  'program',
  'panel',
];

export interface KeyPress {
  key: string;
  code: string;
  ctrlKey: boolean;
  metaKey: boolean;
  altKey: boolean;
  shiftKey: boolean;
}

/** `Ctrl+Shift+KeyZ`, wherever that stands on a keyboard; Command on a Mac counts as Ctrl. `?` is the letter. */
export function chord(press: KeyPress): string {
  if (press.key === '?') return '?';
  const parts: string[] = [];
  if (press.ctrlKey || press.metaKey) parts.push('Ctrl');
  if (press.altKey) parts.push('Alt');
  if (press.shiftKey) parts.push('Shift');
  parts.push(press.code.replace(/^Numpad(Enter)$/, '$1'));
  return parts.join('+');
}

const BY_CHORD = new Map<string, Binding & { command: CommandName }>();
for (const binding of BINDINGS) {
  for (const key of binding.keys) BY_CHORD.set(key, binding);
}

export function binding_of(press: KeyPress, in_text: boolean) {
  const binding = BY_CHORD.get(chord(press));
  return binding && (!in_text || binding.in_text) ? binding : undefined;
}

/** Keys that the editor must leave to the machine. */
export const MACHINE_KEYS: ReadonlySet<string> = new Set(
  BINDINGS.flatMap((binding: Binding) => (binding.in_text ? binding.keys : [])),
);

export const keys_of = (command: CommandName): string[] =>
  [...(BINDINGS.find((b) => b.command === command)?.keys ?? [])].map(spoken);

const NAMES: Record<string, string> = {
  ArrowUp: '\u2191',
  ArrowDown: '\u2193',
  ArrowLeft: '\u2190',
  ArrowRight: '\u2192',
  PageUp: 'Page Up',
  PageDown: 'Page Down',
  Comma: ',',
  Period: '.',
  Backspace: '\u232b',
};

/** How a key is written on a keyboard: `Ctrl+S`, `?`. */
export function spoken(key: string): string {
  return key
    .split('+')
    .map((part) => NAMES[part] ?? part.replace(/^(Key|Digit)/, ''))
    .join('+');
}
