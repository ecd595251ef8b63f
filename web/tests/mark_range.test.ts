import { describe, expect, it } from 'vitest';
import { mark_range } from '../src/logic/mark_range';

const marked = (line: string, column: number, length: number) =>
  line.slice(...mark_range(line, column, length));

describe('a diagnostic underlines', () => {
  it('its place', () => {
    expect(marked('G01 X[1+] F5', 9, 1)).toBe(']');
    expect(marked('G01 G999', 5, 4)).toBe('G999');
  });
  it('one character where it has no length', () => {
    expect(marked('G01 X5', 5, 0)).toBe('X');
  });
  it('the last word where it is at the end of the line', () => {
    expect(marked('G01 X[1+', 9, 0)).toBe('X[1+');
    expect(marked('G01 X[1+  ', 11, 0)).toBe('X[1+');
    expect(marked('G01 X[1+', 40, 3)).toBe('X[1+');
  });
  it('nothing in an empty line', () => {
    expect(mark_range('', 1, 0)).toEqual([0, 0]);
  });
  it('by bytes, as the server counts', () => {
    expect(marked('(程式) G01 X[1+] F5', 18, 1)).toBe(']');
    expect(marked('(程式)', 2, 0)).toBe('程');
    expect(marked('(😀) X', 8, 1)).toBe('X');
  });
});
