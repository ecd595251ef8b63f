import { describe, expect, it } from 'vitest';
import { scale_colour } from '../src/logic/colour_scale';
import { fill_table } from '../src/logic/stock/owner_colours';
import type { Finding } from '../src/logic/stock/part_store';
import { PartStore } from '../src/logic/stock/part_store';
import {
  asks_for_fine,
  finding_marks,
  verdict_of,
  wanted_time,
} from '../src/logic/stock/part_view';

const finding = (time_s: number, severity: Finding['severity'] = 'error'): Finding => ({
  severity,
  code: 'RAPID_IN_STOCK',
  message: '',
  cause: '',
  remedy: '',
  file: 'a.nc',
  line: 1,
  column: 1,
  length: 1,
  time_s,
  tool: 1,
  motion: 1,
  at: [0, 0, 0],
  depth_mm: 1,
  volume_mm3: 1,
  count: 1,
});

describe('the state of the part that is seen', () => {
  it('is that of the slider before all, then that of the machine', () => {
    expect(wanted_time({ slider_s: 3, path_s: 9, is_over: true })).toBe(3);
    expect(wanted_time({ slider_s: 0, path_s: 9, is_over: false })).toBe(0);
    expect(wanted_time({ slider_s: null, path_s: 9, is_over: false })).toBe(9);
  });
  it('is as it becomes, before the program begins and when it is over', () => {
    expect(wanted_time({ slider_s: null, path_s: null, is_over: false })).toBeNull();
    expect(wanted_time({ slider_s: null, path_s: 9, is_over: true })).toBeNull();
  });
  it('is fine where somebody wants that and a browser can draw it', () => {
    const facts = new PartStore().facts;
    const level = (cells: [number, number]) => ({
      first: [0, 0] as [number, number],
      cell_mm: [1, 1] as [number, number],
      cells,
    });
    const of = (cells: [number, number]) => ({ ...facts, levels: [level([10, 10]), level(cells)] });
    expect(asks_for_fine(of([1000, 600]), true)).toBe(true);
    expect(asks_for_fine(of([1000, 600]), false)).toBe(false);
    expect(asks_for_fine(of([5000, 3000]), true)).toBe(false);
  });
});

describe('findings on the slider', () => {
  it('stand at their times, and those that are close are one mark', () => {
    const marks = finding_marks(
      [finding(10), finding(50, 'warning'), finding(50.01), finding(99)],
      100,
    );
    expect(marks.map(({ share }) => share)).toEqual([0.1, 0.5, 0.99]);
    expect(marks[1].severity).toBe('error');
    expect(marks[1].findings.length).toBe(2);
  });
  it('never lie beside it, and there are none without a time', () => {
    expect(finding_marks([finding(500)], 100)[0].share).toBe(1);
    expect(finding_marks([finding(5)], 0)).toEqual([]);
  });
  it('go with a machine that was held', () =>
    expect(finding_marks([finding(10)], 100, (s) => s + 30)[0].share).toBeCloseTo(0.4, 9));
});

describe('the word in the head', () => {
  const now = { has_program: true, problems: 0, is_stale: false, is_done: true };
  it.each([
    [now, 'clean'],
    [{ ...now, is_done: false }, 'checking'],
    [{ ...now, problems: 3 }, 'findings'],
    [{ ...now, problems: 3, is_done: false }, 'findings'],
    [{ ...now, problems: 3, is_stale: true }, 'stale'],
    [{ ...now, has_program: false }, 'nothing'],
    [{ ...now, has_program: false, problems: 1 }, 'findings'],
  ] as const)('of %o is %s', (state, word) => expect(verdict_of(state)).toBe(word));
});

describe('colours of what was cut', () => {
  const owners = [
    { file: 0, line: 0, tool: 0, engagement_deg: null },
    { file: 0, line: 7, tool: 1, engagement_deg: 180 },
    { file: 0, line: 9, tool: 2, engagement_deg: 0 },
    { file: 1, line: 9, tool: 2, engagement_deg: null },
  ];
  it('are on a scale of engagement, and what is not known keeps that of the stock', () => {
    const table = new Uint8Array(16);
    fill_table(table, owners, 'engagement', 'dark', null);
    const on_scale = (share: number) => scale_colour(share, 'dark').map((c) => Math.round(255 * c));
    expect(row(table, 1).slice(0, 3)).toEqual(on_scale(1));
    expect(row(table, 2).slice(0, 3)).toEqual(on_scale(0));
    expect([table[4 + 3] > 200, table[12 + 3]]).toEqual([true, 0]);
  });
  const row = (table: Uint8Array, i: number) => [...table.slice(4 * i, 4 * i + 4)];
  it('are those of the tools, and the stock keeps its own', () => {
    const table = new Uint8Array(16);
    fill_table(table, owners, 'tool', 'dark', null);
    expect(table[3]).toBe(0);
    expect(row(table, 1)).not.toEqual(row(table, 2));
    expect(row(table, 2)).toEqual(row(table, 3));
  });
  it('let one line of one file stand out', () => {
    const table = new Uint8Array(16);
    fill_table(table, owners, 'line', 'dark', { file: 0, line: 9 });
    expect(table[4 * 2 + 3]).toBeGreaterThan(220);
    expect(table[4 * 3 + 3]).toBeLessThan(80);
    expect(table[4 * 1 + 3]).toBeLessThan(80);
  });
});
