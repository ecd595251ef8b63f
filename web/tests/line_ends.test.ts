import { describe, expect, it } from 'vitest';
import { line_end_name, line_ends_of, line_of, lines_of } from '../src/logic/line_ends';
import { random } from './random';

describe('lines are those of the control', () => {
  it.each([
    ['', ['']],
    ['a\nb\n', ['a', 'b', '']],
    ['a\r\nb\r\n', ['a', 'b', '']],
    ['a\rb\r', ['a', 'b', '']],
    ['a\r\rb', ['a', '', 'b']],
    ['a\r\r\nb', ['a', 'b']],
    ['a\n\rb', ['a', '\rb']],
    ['a\n\r\nb', ['a', '', 'b']],
    ['a\rb\nc\r\nd', ['a', 'b', 'c', 'd']],
  ])('of %j', (text, lines) => {
    expect(lines_of(text)).toEqual(lines);
    expect(lines.map((_, i) => line_of(text, i + 1))).toEqual(lines);
    expect(line_of(text, lines.length + 1)).toBe('');
  });
  it('in a long file of nothing but CRs as fast as in another', () => {
    const begin = performance.now();
    expect(lines_of('\r'.repeat(1_000_000))).toHaveLength(1_000_001);
    expect(performance.now() - begin).toBeLessThan(3_000);
  });
});

describe('the ends of the lines', () => {
  it.each(['\n', '\r\n', '\r', '\r\r\n'])('%j make the same bytes again', (end) => {
    const text = ['%', 'O1', '', 'M30', ''].join(end);
    expect(line_ends_of(text)).toEqual({ end, is_mixed: false });
    expect(lines_of(text).join(end)).toBe(text);
  });
  it('may differ: most of them count', () => {
    expect(line_ends_of('a\r\nb\r\nc\n')).toEqual({ end: '\r\n', is_mixed: true });
    expect(line_ends_of('no end')).toEqual({ end: '\n', is_mixed: false });
  });
  it('lose nothing else of a text', () => {
    const next = random(7);
    for (let run = 0; run < 300; run++) {
      const text = Array.from({ length: 12 }, () => '\r\nab'[Math.floor(next() * 4)]).join('');
      const { end, is_mixed } = line_ends_of(text);
      if (!is_mixed) expect(lines_of(text).join(end)).toBe(text);
      expect(lines_of(text).join('').replaceAll('\r', '')).toBe(text.replace(/[\r\n]/g, ''));
    }
  });
  it('have names', () => {
    expect(['\n', '\r\n', '\r'].map(line_end_name)).toEqual(['LF', 'CR LF', 'CR']);
  });
});
