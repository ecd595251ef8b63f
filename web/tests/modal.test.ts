import { expect, it } from 'vitest';
import { group_of, in_order, is_quiet } from '../src/logic/modal';
import { by_system } from '../src/logic/offsets';
import { scope_of } from '../src/logic/variables';

it('modal codes have their group and their place, whatever order they come in', () => {
  expect(['G01', 'G81', 'G19', 'G54.1 P3', 'G41', 'F200'].map(group_of)).toEqual([
    'motion',
    'motion',
    'plane',
    'system',
    'compensation',
    'other',
  ]);
  expect(in_order(['F200', 'G54', 'G17', 'G01'])).toEqual(['G01', 'G17', 'G54', 'F200']);
  expect([is_quiet('G40'), is_quiet('G41')]).toEqual([true, false]);
});

it('work offsets come together by their system', () => {
  const rows = [
    { offset: 'EXT', axis: 'X', value: 0 },
    { offset: 'G54', axis: 'X', value: 1 },
    { offset: 'G54', axis: 'Z', value: -2 },
  ];
  expect(by_system(rows)).toEqual([
    { name: 'EXT', values: { X: 0 } },
    { name: 'G54', values: { X: 1, Z: -2 } },
  ]);
});

it('a variable belongs where the server says, or where its number lies', () => {
  const variable = (name: string) => ({ name, value: 0, level: null, changed: false });
  expect(['#1', '#33', '#100', '#499', '#500', 'COUNT'].map((n) => scope_of(variable(n)))).toEqual([
    'local',
    'local',
    'common',
    'common',
    'permanent',
    'program',
  ]);
  expect(scope_of({ ...variable('#1'), scope: 'program' })).toBe('program');
});
