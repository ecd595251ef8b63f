import { expect, it } from 'vitest';
import { UndoStack } from '../src/logic/undo';

function edit(log: string[], what: string, refuses = false) {
  const act = (word: string) => async () => {
    if (refuses) throw new Error('the machine moves');
    log.push(`${word} ${what}`);
  };
  return { what, undo: act('undo'), redo: act('redo') };
}

it('takes edits back in their order and does them again', async () => {
  const log: string[] = [];
  const stack = new UndoStack();
  stack.record(edit(log, '#500'));
  stack.record(edit(log, 'G54 X'));
  expect(await stack.undo()).toBe('G54 X');
  expect(await stack.undo()).toBe('#500');
  expect(await stack.undo()).toBeNull();
  expect(await stack.redo()).toBe('#500');
  expect(log).toEqual(['undo G54 X', 'undo #500', 'redo #500']);
});

it('forgets what was taken back when something new is changed', async () => {
  const stack = new UndoStack();
  stack.record(edit([], 'a'));
  await stack.undo();
  stack.record(edit([], 'b'));
  expect(stack.can_redo).toBe(false);
});

it('keeps an edit that the machine refuses to take back', async () => {
  const stack = new UndoStack();
  stack.record(edit([], 'a', true));
  await expect(stack.undo()).rejects.toThrow();
  expect(stack.can_undo).toBe(true);
});
