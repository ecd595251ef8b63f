import { describe, expect, it } from 'vitest';
import { line_spans, rates, waves } from '../src/logic/waves';

describe('rates', () => {
  it('count the pulses of each column, backwards ones down', () => {
    const edges = [0.05, 1, 0.15, 1, 0.18, 1, 0.35, -1];
    expect([...rates(edges, 0, 0.4, 4)].map(Math.round)).toEqual([10, 20, 0, -10, -10]);
  });
  it('leave out what lies beyond', () => {
    expect([...rates([-1, 1, 5, 1], 0, 1, 2)]).toEqual([0, 0, 0]);
  });
});

describe('waves', () => {
  const made = waves({ X: [0.1, 1, 0.2, 1], Y: [0.6, -1] }, line_spans([[0, 0.5, 12]]), 0, 1, 2);
  it('give each axis a lane of its own, the first on top', () => {
    expect(made.lanes.map(({ name, steps }) => [name, steps])).toEqual([
      ['X', 2],
      ['Y', -1],
    ]);
    expect(made.curves[0].every((v) => v >= 1 && v <= 2)).toBe(true);
    expect(made.curves[1].every((v) => v >= 0 && v <= 1)).toBe(true);
  });
  it('fill a lane with the fastest pulses and rest in its middle', () => {
    expect([...made.curves[0]].slice(0, 2)).toEqual([1.9, 1.5]);
    expect(made.curves[1][0]).toBe(0.5);
    expect(made.curves[1][1]).toBeCloseTo(0.1, 12);
  });
  it('know which line moves when', () => {
    expect(made.lines).toEqual([{ line: 12, from_s: 0, to_s: 0.5 }]);
  });
  it('of axes that do not move are straight', () => {
    const still = waves({ Z: [] }, [], 0, 1, 4);
    expect(new Set(still.curves[0])).toEqual(new Set([0.5]));
  });
});
