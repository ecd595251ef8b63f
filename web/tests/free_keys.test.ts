import { defaultKeymap, historyKeymap } from '@codemirror/commands';
import { searchKeymap } from '@codemirror/search';
import { describe, expect, it } from 'vitest';
import { chords_of, free_keys } from '../src/editor/free_keys';
import { BINDINGS, MACHINE_KEYS } from '../src/logic/keymap';

const ALL = [...defaultKeymap, ...historyKeymap, ...searchKeymap];

describe('the keys of the editor', () => {
  it('are written as those of the panel', () => {
    expect(chords_of({ key: 'Mod-Enter' })).toEqual(['Ctrl+Enter']);
    expect(chords_of({ key: 'Alt-ArrowUp', shift: () => true })).toEqual([
      'Alt+ArrowUp',
      'Alt+Shift+ArrowUp',
    ]);
    expect(chords_of({ key: 'Alt-l', mac: 'Ctrl-l' })).toEqual(['Alt+KeyL', 'Ctrl+KeyL']);
    expect(chords_of({ linux: 'Ctrl-Shift-z' })).toEqual(['Ctrl+Shift+KeyZ']);
  });
  it('would take keys of the machine', () => {
    const taken = ALL.flatMap(chords_of).filter((chord) => MACHINE_KEYS.has(chord));
    for (const chord of ['Ctrl+Enter', 'Alt+ArrowUp', 'Alt+ArrowDown', 'Alt+ArrowLeft', 'Alt+KeyL'])
      expect(taken).toContain(chord);
  });
  it('take none of them once they are filtered', () => {
    const left = free_keys(ALL).flatMap(chords_of);
    expect(left.filter((chord) => MACHINE_KEYS.has(chord))).toEqual([]);
  });
  it('are otherwise all there', () => {
    const lost = ALL.filter((binding) => !free_keys(ALL).includes(binding));
    for (const binding of lost)
      expect(chords_of(binding).some((chord) => MACHINE_KEYS.has(chord))).toBe(true);
    expect(free_keys(ALL).flatMap(chords_of)).toEqual(
      expect.arrayContaining(['Ctrl+KeyZ', 'Ctrl+KeyF', 'Enter', 'Backspace']),
    );
  });
});

it('what moves, stops or steps the machine works while a text is written', () => {
  for (const binding of BINDINGS) {
    if (['run', 'step', 'modes', 'switches'].includes(binding.group))
      for (const key of binding.keys) expect(MACHINE_KEYS, key).toContain(key);
  }
});
