import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { free_name, mended_name } from '../src/logic/program_name';

const bytes = (text: string) => new TextEncoder().encode(text).length;

describe('the name of a program', () => {
  it('is mended to one that the library takes', () => {
    // tests/unit/server_library_test.cpp holds the server to the same table.
    const file = join(__dirname, '../../tests/program_names.json');
    const table = JSON.parse(readFileSync(file, 'utf8')) as [string, string][];
    for (const [wanted, mended] of table) expect(mended_name(wanted)).toBe(mended);
    expect(mended_name('a'.repeat(100))).toBe('a'.repeat(100));
  });
  it('is cut to a hundred bytes between two characters, and keeps its ending', () => {
    const long = mended_name(`${'零件'.repeat(40)}.nc`);
    expect(bytes(long)).toBeLessThanOrEqual(100);
    expect(long).toMatch(/^[零件]+\.nc$/u);
  });
  it('has a number behind it where another has it', () => {
    expect(free_name('part.nc', ['part.nc'])).toBe('part-2.nc');
    expect(free_name('part.nc', ['part.nc', 'part-2.nc'])).toBe('part-3.nc');
    expect(free_name('O1234', [])).toBe('O1234-2');
  });
});
