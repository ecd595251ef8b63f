import { describe, expect, it } from 'vitest';
import {
  count_errors,
  problem_beside,
  problems_of,
  type ProblemSources,
} from '../src/logic/problems';
import type { Alarm, Diagnostic } from '../src/logic/protocol';

const alarm = (line: number, code = 'PS0007', file = 'a.nc'): Alarm => ({
  severity: 'error',
  code,
  message: 'wrong',
  file,
  line,
  column: 1,
  cause: '',
  remedy: '',
});
const mark = (line: number, code: string, severity: Diagnostic['severity'] = 'error') => ({
  severity,
  code,
  message: 'wrong',
  line,
  column: 1,
  length: 1,
  cause: '',
  remedy: '',
});
const sources = (change: Partial<ProblemSources> = {}): ProblemSources => ({
  checked: { file: 'a.nc', found: [] },
  path: null,
  alarm: null,
  edited: new Set(),
  ...change,
});
const path = (...findings: Alarm[]) => ({ findings, error: findings[0] ?? null });
const told = (s: ProblemSources) => problems_of(s).map((p) => `${p.file}:${p.line} ${p.code}`);

describe('all that is wrong', () => {
  it('is of the text, of the run and of the machine, by file and line', () => {
    const all = sources({
      checked: { file: 'a.nc', found: [mark(9, 'PS0004')] },
      path: path(alarm(5), alarm(2, 'PS0010', 'b.nc'), alarm(3)),
      alarm: alarm(1, 'MC3001'),
    });
    expect(told(all)).toEqual([
      'a.nc:1 MC3001',
      'a.nc:3 PS0007',
      'a.nc:5 PS0007',
      'a.nc:9 PS0004',
      'b.nc:2 PS0010',
    ]);
  });
  it('counts what was found twice once, and keeps that the control stops there', () => {
    const both = sources({
      checked: { file: 'a.nc', found: [mark(5, 'PS0007')] },
      path: path(alarm(5), alarm(7)),
      alarm: alarm(5),
    });
    const found = problems_of(both);
    expect(found.map((p) => [p.line, p.stops])).toEqual([
      [5, true],
      [7, false],
    ]);
  });
  it('marks the first alarm of the run, wherever its line stands', () => {
    const found = problems_of(sources({ path: path(alarm(8), alarm(2)) }));
    expect(found.find((p) => p.stops)?.line).toBe(8);
  });
  it('does not say that the control stops where it only waits', () => {
    const waits = { ...alarm(4, 'INPUT_WAIT'), severity: 'warning' as const };
    const found = problems_of(sources({ path: { findings: [], error: waits } }));
    expect(found.map((p) => [p.code, p.stops])).toEqual([['INPUT_WAIT', false]]);
  });
  it('leaves out what the run has met in a text that was edited since', () => {
    const edited = sources({
      checked: { file: 'a.nc', found: [mark(4, 'PS0004')] },
      path: path(alarm(5), alarm(2, 'PS0010', 'b.nc')),
      alarm: alarm(5),
      edited: new Set(['a.nc']),
    });
    expect(told(edited)).toEqual(['a.nc:4 PS0004', 'b.nc:2 PS0010']);
  });
  it('has the error of a preview that has no findings', () => {
    expect(told(sources({ path: { findings: [], error: alarm(0, 'DISK', '') } }))).toEqual([
      ':0 DISK',
    ]);
  });
  it('counts errors without warnings', () => {
    const both = [mark(1, 'A'), mark(2, 'B', 'warning')];
    expect(count_errors(problems_of(sources({ checked: { file: 'a.nc', found: both } })))).toBe(1);
  });
});

describe('from one problem to the next', () => {
  const list = problems_of(
    sources({ path: path(alarm(5), alarm(9), alarm(2, 'PS0010', 'b.nc'), alarm(0, 'X', 'c.nc')) }),
  );
  const beside = (file: string, line: number, way: 1 | -1) => {
    const found = problem_beside(list, file, line, way);
    return found && `${found.file}:${found.line}`;
  };
  it('goes on within the file, then to the next one, then around', () => {
    expect(beside('a.nc', 1, 1)).toBe('a.nc:5');
    expect(beside('a.nc', 5, 1)).toBe('a.nc:9');
    expect(beside('a.nc', 9, 1)).toBe('b.nc:2');
    expect(beside('b.nc', 2, 1)).toBe('a.nc:5');
  });
  it('goes back likewise', () => {
    expect(beside('a.nc', 9, -1)).toBe('a.nc:5');
    expect(beside('a.nc', 5, -1)).toBe('b.nc:2');
    expect(beside('b.nc', 2, -1)).toBe('a.nc:9');
  });
  it('begins at the first from a file without any', () => {
    expect(beside('other.nc', 7, 1)).toBe('a.nc:5');
  });
  it('has nowhere to go where there is none', () => {
    expect(problem_beside([], 'a.nc', 1, 1)).toBeNull();
  });
});
