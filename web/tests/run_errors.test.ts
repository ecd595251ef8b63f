import { describe, expect, it } from 'vitest';
import type { Alarm } from '../src/logic/protocol';
import { run_errors, together } from '../src/logic/run_errors';

const alarm = (change: Partial<Alarm> = {}): Alarm => ({
  severity: 'error',
  code: 'PS0010',
  message: 'improper g-code',
  file: 'part.nc',
  line: 4,
  column: 1,
  length: 4,
  cause: '',
  remedy: '',
  ...change,
});
const document = { name: 'part.nc', text: 'G999', loaded: 'G999' };

describe('what only running finds', () => {
  it('belongs to the text that the machine has', () => {
    const [found] = run_errors(document, [alarm()]);
    expect(found).toMatchObject({ code: 'PS0010', line: 4, column: 1, length: 4 });
    expect(found.severity).toBe('error');
  });
  it('is no longer told of an edited text', () => {
    expect(run_errors({ ...document, text: 'G01' }, [alarm()])).toEqual([]);
    expect(run_errors({ ...document, loaded: null }, [alarm()])).toEqual([]);
    expect(run_errors(undefined, [alarm()])).toEqual([]);
  });
  it('belongs to its own file and has a line', () => {
    expect(run_errors(document, [alarm({ file: 'other.nc' }), alarm({ line: 0 })])).toEqual([]);
  });
  it('counts once, whoever has found it', () => {
    const of_run = run_errors(document, [alarm(), alarm(), null, undefined]);
    expect(of_run).toHaveLength(1);
    expect(together(of_run, of_run)).toHaveLength(1);
    expect(together(of_run, run_errors(document, [alarm({ line: 5 })]))).toHaveLength(2);
  });
});
