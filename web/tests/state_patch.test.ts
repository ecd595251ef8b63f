import { expect, it } from 'vitest';
import { EMPTY_STATE } from '../src/logic/protocol';
import { patched } from '../src/logic/state_patch';

it('keeps the objects of keys that an event leaves out', () => {
  const next = patched(EMPTY_STATE, { event: 'state', machine: 'mill', line: 12, alarm: null });
  expect(next.line).toBe(12);
  expect(next.position).toBe(EMPTY_STATE.position);
  expect(next).not.toHaveProperty('event');
  expect(EMPTY_STATE.line).toBe(0);
});
