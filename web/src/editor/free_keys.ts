/** The editor's own keys without those that belong to the machine: a cycle start that puts in a line would be a lie. */
import type { KeyBinding } from '@codemirror/view';
import { MACHINE_KEYS } from '../logic/keymap';

const PLATFORMS = ['key', 'mac', 'win', 'linux'] as const;

export function free_keys(bindings: readonly KeyBinding[]): KeyBinding[] {
  return bindings.filter((binding) => !chords_of(binding).some((chord) => MACHINE_KEYS.has(chord)));
}

/** As `chord` of the keymap writes them, on any computer; one with `shift` is two. */
export function chords_of(binding: KeyBinding): string[] {
  const keys = PLATFORMS.flatMap((platform) => binding[platform] ?? []);
  return keys.flatMap((key) => {
    const chord = chord_of(key);
    return binding.shift ? [chord, chord_of(`Shift-${key}`)] : [chord];
  });
}

/** Of several strokes, as Ctrl-k Ctrl-u, the first is the one that is taken. */
function chord_of(key: string): string {
  const parts = key.split(' ')[0].split(/-(?!$)/);
  const last = parts.pop() ?? '';
  const held = new Set(parts.map((part) => part.toLowerCase()));
  const has = (...names: string[]): boolean => names.some((name) => held.has(name));
  return [
    ...(has('mod', 'ctrl', 'c', 'cmd', 'meta', 'm') ? ['Ctrl'] : []),
    ...(has('alt', 'a') ? ['Alt'] : []),
    ...(has('shift', 's') || /^[A-Z]$/.test(last) ? ['Shift'] : []),
    code_of(last),
  ].join('+');
}

function code_of(key: string): string {
  if (/^[a-z]$/i.test(key)) return `Key${key.toUpperCase()}`;
  if (/^\d$/.test(key)) return `Digit${key}`;
  return key;
}
