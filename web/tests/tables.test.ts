import { expect, it } from 'vitest';
import { in_order, row_of } from '../src/logic/modal';
import {
  type WorkOffset,
  by_system,
  empty_tool,
  further_system,
  with_added,
  with_systems,
  zero_here,
} from '../src/logic/offsets';
import { scope_of } from '../src/logic/variables';

it('modal codes have their place, whatever order they come in', () => {
  const code = (name: string) => ({ code: name, title: '', sentence: '', quiet: name === 'G40' });
  const groups = [['G81'], ['G19'], ['G40', 'G41'], ['G54.1']].map((codes, i) => ({
    group: String(i),
    codes: codes.map(code),
  }));
  expect(in_order(groups, ['F200', 'G54.1 P3', 'G41', 'G19', 'G81'])).toEqual([
    'G81',
    'G19',
    'G41',
    'G54.1 P3',
    'F200',
  ]);
  expect(['G40', 'G41', 'H1'].map((text) => row_of(groups, text)?.quiet)).toEqual([
    true,
    false,
    undefined,
  ]);
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

it('a tool that was added has an empty row until the machine tells it', () => {
  const five = {
    number: 5,
    length_geometry: 80,
    length_wear: 0,
    radius_geometry: 4,
    radius_wear: 0,
  };
  const table = with_added([five], [7, 5, 2, 7], empty_tool);
  expect(table.map((tool) => tool.number)).toEqual([2, 5, 7]);
  expect(table[1]).toBe(five);
  expect(table[2].length_geometry).toBe(0);
});

it('a further system has a row where it is looked for, also of 0', () => {
  const systems: WorkOffset[] = [
    { name: 'EXT', values: {} },
    { name: 'G54', values: { X: 1 } },
    { name: 'G54.1 P20', values: { X: 3 } },
  ];
  const table = with_systems(systems, ['G54', 'G54.1 P3', 'G54.1 P20', 'G54.1 P3']);
  expect(table.map(({ name }) => name)).toEqual(['EXT', 'G54', 'G54.1 P3', 'G54.1 P20']);
  expect(table[3]).toBe(systems[2]);
  expect([1, 300, 0, 301, 1.5, NaN].map(further_system)).toEqual([
    'G54.1 P1',
    'G54.1 P300',
    null,
    null,
    null,
    null,
  ]);
});

// The axis stands at 100 of the machine: EXT 10, G54 20, G52 5; the tool is 30 long.
it('an offset makes the place of the axis the zero of its system', () => {
  const ext = { name: 'EXT', values: { Z: 10 } };
  const g54 = { name: 'G54', values: { Z: 20 } };
  const g55 = { name: 'G55', values: { Z: -7 } };
  const reads = 100 - 30 - (10 + 20 + 5);
  expect(zero_here(g54, 'Z', g54, reads)).toBe(100 - 30 - 10 - 5);
  expect(zero_here(g55, 'Z', g54, reads)).toBe(100 - 30 - 10 - 5);
  expect(zero_here(ext, 'Z', g54, reads)).toBe(100 - 30 - 20 - 5);
  expect(zero_here({ name: 'G54', values: {} }, 'X', { name: 'G54', values: {} }, 0.1 + 0.2)).toBe(
    0.3,
  );
});
