import { describe, expect, it } from 'vitest';
import { free_name, mended_name } from '../src/logic/program_name';

const bytes = (text: string) => new TextEncoder().encode(text).length;

describe('the name of a program', () => {
  it('stays as it is where the library takes it', () => {
    for (const name of ['part.nc', 'O1234', '零件 3.nc', 'a'.repeat(100)])
      expect(mended_name(name)).toBe(name);
  });
  it('loses what the library refuses', () => {
    expect(mended_name('<part>.nc')).toBe('part-.nc');
    expect(mended_name('a/b\\c:d*e?f"g|h.nc')).toBe('a-b-c-d-e-f-g-h.nc');
    expect(mended_name(' .part.nc. ')).toBe('part.nc');
    expect(mended_name('pa\u0007rt.nc')).toBe('part.nc');
    expect(mended_name('...')).toBe('program.nc');
    expect(mended_name('a\u202ecn.exe')).toBe('acn.exe');
    expect(mended_name('--rf')).toBe('rf');
    expect(mended_name('con.nc')).toBe('_con.nc');
    expect(mended_name('console.nc')).toBe('console.nc');
    expect(mended_name('Welle_u\u0308.nc')).toBe('Welle_ü.nc');
    expect(mended_name('x\u0304.nc')).toBe('x.nc');
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
