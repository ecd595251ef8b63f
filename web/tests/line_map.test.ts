import { describe, expect, it } from 'vitest';
import { hunks_of, line_map } from '../src/logic/line_map';
import { random } from './random';

const text = (...lines: string[]): string => lines.join('\n');

describe('the lines of an edited text', () => {
  it('are its own where nothing was edited', () => {
    const map = line_map('A\nB', 'A\nB');
    expect([map.forth(2), map.back(1)]).toEqual([2, 1]);
  });

  it('move down behind what was put in, and what was put in is new', () => {
    const map = line_map(text('A', 'B', 'C'), text('(1)', '(2)', '(3)', 'A', 'B', 'C'));
    expect([1, 2, 3].map(map.forth)).toEqual([4, 5, 6]);
    expect([1, 2, 3, 4, 6].map(map.back)).toEqual([null, null, null, 1, 3]);
  });

  it('move up behind what was taken out, and what was taken out is gone', () => {
    const map = line_map(text('A', 'B', 'C', 'D'), text('A', 'D'));
    expect([1, 2, 3, 4].map(map.forth)).toEqual([1, null, null, 2]);
  });

  it('stay the same line when they are changed in their place', () => {
    const map = line_map(text('A', 'B', 'C'), text('A', 'B X1.', 'C'));
    expect([map.forth(2), map.back(2)]).toEqual([2, 2]);
  });

  it('are found between several edits', () => {
    const map = line_map(text('A', 'B', 'C', 'D', 'E', 'F'), text('A', 'N', 'B', 'C', 'E', 'F2'));
    expect([1, 2, 3, 4, 5, 6].map(map.forth)).toEqual([1, 3, 4, null, 5, 6]);
  });

  it('know the line ends of the control', () => {
    expect(line_map('A\r\nB\r\n', '(1)\r\nA\r\nB\r\n').forth(2)).toBe(3);
  });

  it('agree with the texts, whatever the edits were', () => {
    const next = random(7);
    const word = () => 'ABCDE'[Math.floor(next() * 5)];
    for (let round = 0; round < 300; round++) {
      const a = Array.from({ length: Math.floor(next() * 14) + 1 }, word);
      const b = [...a];
      for (let i = 0; i < 4; i++) {
        const at = Math.floor(next() * (b.length + 1));
        if (next() < 0.5) b.splice(at, Math.floor(next() * 3));
        else b.splice(at, 0, word());
      }
      // What the hunks say makes the second text of the first.
      const made: string[] = [];
      let at = 0;
      for (const { from, removed, to, added } of hunks_of(a, b)) {
        made.push(...a.slice(at, from), ...b.slice(to, to + added));
        at = from + removed;
      }
      made.push(...a.slice(at));
      expect(made).toEqual(b);
      const map = line_map(a.join('\n'), b.join('\n'));
      for (let line = 1; line <= a.length; line++) {
        const there = map.forth(line);
        if (there !== null) expect(map.back(there)).toBe(line);
      }
    }
  });

  it('are found in a million lines, edited at both ends, at once', () => {
    const lines = Array.from({ length: 1_000_000 }, (_, i) => `X${i % 977}`);
    const second = [...lines];
    second.splice(10, 0, '(A)');
    second.splice(999_990, 1);
    const began = performance.now();
    const map = line_map(lines.join('\n'), second.join('\n'));
    expect([map.forth(11), map.forth(500_000)]).toEqual([12, 500_001]);
    expect(performance.now() - began).toBeLessThan(5000);
  });

  it('give up in a stretch where nearly all is changed, and go on behind it', () => {
    const lines = Array.from({ length: 5000 }, (_, i) => `X${i}`);
    const changed = lines.map((line, i) => (i > 0 && i < 4999 ? `${line} Y1.` : line));
    const map = line_map(lines.join('\n'), ['(NEW)', ...changed].join('\n'));
    expect([map.forth(1), map.forth(5000)]).toEqual([1, 5001]);
  });
});
