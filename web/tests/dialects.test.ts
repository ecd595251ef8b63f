import { expect, it } from 'vitest';
import { fresh_text, is_listing, line_comment } from '../src/logic/dialects';
import type { Dialect } from '../src/logic/protocol';

const dialect = (name: string, ending: string, change: Partial<Dialect> = {}): Dialect => ({
  name,
  language: name,
  ending,
  shows_by_ending: true,
  comment: [';', ''],
  example: '',
  fresh: '\n',
  is_listing: false,
  ...change,
});

const ALL = [
  dialect('mill', '.nc', { comment: ['(', ')'], fresh: '%\n' }),
  dialect('pulses', '.pat', { is_listing: true }),
];

it('files of bytes show by their ending, whatever its case', () => {
  expect(['a.PAT', 'a.pat', 'a.nc', 'pat'].map((name) => is_listing(ALL, name))).toEqual([
    true,
    true,
    false,
    false,
  ]);
});

it('a new program begins as its ending says', () => {
  expect(['a.nc', 'a.txt', 'a.pat'].map((name) => fresh_text(ALL, name))).toEqual([
    '%\n',
    '\n',
    '\n',
  ]);
});

it('only a comment to the end of its line is put in front of lines', () => {
  expect([...ALL, undefined].map(line_comment)).toEqual([undefined, ';', undefined]);
});
