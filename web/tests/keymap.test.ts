import { describe, expect, it } from 'vitest';
import { BINDINGS, GROUPS, binding_of, chord, keys_of, spoken } from '../src/logic/keymap';

const press = (
  code: string,
  held: Partial<Record<'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey', boolean>> = {},
  key = '',
) => ({
  key,
  code,
  ctrlKey: false,
  metaKey: false,
  altKey: false,
  shiftKey: false,
  ...held,
});

describe('the keymap', () => {
  it('gives no key to two commands', () => {
    const keys = BINDINGS.flatMap((b) => [...b.keys] as string[]);
    expect(keys.length).toBe(new Set(keys).size);
  });
  it('has each command once, in a group that is shown', () => {
    const names = BINDINGS.map((b) => b.command);
    expect(names.length).toBe(new Set(names).size);
    for (const binding of BINDINGS) expect(GROUPS).toContain(binding.group);
  });
  it('finds a command by what is pressed', () => {
    expect(binding_of(press('F10'), false)?.command).toBe('step-over');
    expect(binding_of(press('F11', { shiftKey: true }), true)?.command).toBe('step-out');
    expect(binding_of(press('Digit3', { altKey: true }), true)?.command).toBe('mode-auto');
    expect(binding_of(press('Digit3'), false)?.command).toBe('view-right');
  });
  it('knows the question mark wherever a keyboard has it', () => {
    const german = press('Minus', { shiftKey: true }, '?');
    expect(binding_of(german, false)?.command).toBe('help');
    expect(binding_of(german, true)).toBeUndefined();
  });
  it('leaves letters and arrows to text fields', () => {
    expect(binding_of(press('KeyF'), true)).toBeUndefined();
    expect(binding_of(press('ArrowLeft'), true)).toBeUndefined();
    expect(binding_of(press('KeyZ', { ctrlKey: true }), true)).toBeUndefined();
    expect(binding_of(press('KeyF'), false)?.command).toBe('fit');
  });
  it('holds only what is held: jogging', () => {
    for (const binding of BINDINGS) {
      expect('held' in binding && binding.held === true).toBe(/^jog-/.test(binding.command));
    }
  });
});

it('Command counts as Ctrl', () => {
  expect(chord(press('KeyS', { metaKey: true }))).toBe('Ctrl+KeyS');
});

it('keys are spoken as they are written on a keyboard', () => {
  expect(['Ctrl+Shift+Backspace', 'Alt+Digit1', '?', 'ArrowUp', 'Comma'].map(spoken)).toEqual([
    'Ctrl+Shift+⌫',
    'Alt+1',
    '?',
    '↑',
    ',',
  ]);
  expect(keys_of('step-into')).toEqual(['F11', 'Alt+F10']);
});
