import { expect, it } from 'vitest';
import { type Edit, UndoStack } from '../src/logic/undo';

/** An edit whose machine answers some time later. */
function edit(log: string[], what: string, delay_ms = 0): Edit {
  const act = (word: string) => async () => {
    await new Promise((resolve) => setTimeout(resolve, delay_ms));
    log.push(`${word} ${what}`);
  };
  return { what, undo: act('undo'), redo: act('do') };
}
const refuse = async () => {
  throw new Error('the machine moves');
};

it('takes edits back in their order and does them again', async () => {
  const log: string[] = [];
  const stack = new UndoStack();
  await stack.perform(edit(log, '#500'));
  await stack.perform(edit(log, 'G54 X'));
  expect(await stack.undo()).toBe('G54 X');
  expect(await stack.undo()).toBe('#500');
  expect(await stack.undo()).toBeNull();
  expect(await stack.redo()).toBe('#500');
  expect(log).toEqual(['do #500', 'do G54 X', 'undo G54 X', 'undo #500', 'do #500']);
});

it('does what is asked while the machine has not answered yet in its turn', async () => {
  const log: string[] = [];
  const stack = new UndoStack();
  const asked = [
    stack.perform(edit(log, 'a', 9)),
    stack.perform(edit(log, 'b')),
    stack.undo(),
    stack.undo(),
    stack.redo(),
  ];
  expect(await Promise.all(asked)).toEqual([undefined, undefined, 'b', 'a', 'a']);
  expect(log).toEqual(['do a', 'do b', 'undo b', 'undo a', 'do a']);
});

it('forgets what was taken back when something new is changed', async () => {
  const stack = new UndoStack();
  await stack.perform(edit([], 'a'));
  await stack.undo();
  await stack.perform(edit([], 'b'));
  expect(await stack.redo()).toBeNull();
});

it('keeps nothing of an edit that the machine refuses', async () => {
  const stack = new UndoStack();
  await expect(stack.perform({ ...edit([], 'a'), redo: refuse })).rejects.toThrow();
  expect(await stack.undo()).toBeNull();
});

it('keeps an edit that the machine refuses to take back', async () => {
  const stack = new UndoStack();
  const stays: Edit = { ...edit([], 'a'), undo: refuse };
  await stack.perform(stays);
  await expect(stack.undo()).rejects.toThrow();
  stays.undo = async () => null;
  expect(await stack.undo()).toBe('a');
});

it('another machine has edits of its own', async () => {
  const stack = new UndoStack();
  const late = stack.perform(edit([], 'a', 5));
  await Promise.resolve();
  stack.clear();
  await late;
  expect(await stack.undo()).toBeNull();
});
