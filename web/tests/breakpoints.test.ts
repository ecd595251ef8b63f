import { expect, it } from 'vitest';
import {
  at,
  moved,
  toggled,
  unwatching,
  watching,
  with_condition,
  without,
} from '../src/logic/breakpoints';

it('a line has one breakpoint at most, and lists stay in order', () => {
  let list = toggled([], 'b.nc', 9);
  list = toggled(list, 'b.nc', 3);
  list = toggled(list, 'a.nc', 20);
  expect(list.map((b) => `${b.file}:${b.line}`)).toEqual(['a.nc:20', 'b.nc:3', 'b.nc:9']);
  expect(toggled(list, 'b.nc', 3)).toEqual(without(list, 'b.nc', 3));
});

it('a condition replaces the one before; an empty one stops always', () => {
  const list = with_condition(toggled([], 'a', 1), 'a', 1, ' #1 GT 2 ');
  expect(at(list, 'a', 1)?.condition).toBe('#1 GT 2');
  expect(with_condition(list, 'a', 1, '  ')).toEqual([{ file: 'a', line: 1 }]);
});

it('a variable is watched once', () => {
  const list = watching(watching(toggled([], 'a', 1), '#100'), '#100');
  expect(list).toEqual([{ file: 'a', line: 1 }, { variable: '#100' }]);
  expect(unwatching(list, '#100')).toEqual([{ file: 'a', line: 1 }]);
});

it('breakpoints move with their lines and go with them', () => {
  const list = [
    { file: 'a', line: 2 },
    { file: 'a', line: 5 },
    { file: 'b', line: 5 },
  ];
  const next = moved(list, 'a', (line) => (line === 2 ? null : line + 3));
  expect(next).toEqual([
    { file: 'a', line: 8 },
    { file: 'b', line: 5 },
  ]);
});
