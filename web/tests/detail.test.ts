import { describe, expect, it } from 'vitest';
import { Detail, FINE, type Level, slices_at_rest } from '../src/logic/detail';

/** Frames one behind the other, each with the cost that its level has; the level of each. */
function frames(count: number, cost_ms: (level: Level) => number, segments = 1_000_000): Level[] {
  const detail = new Detail();
  return Array.from({ length: count }, () => {
    const level = detail.level(segments);
    detail.took(cost_ms(level));
    return level;
  });
}

describe('the detail of a picture that changes', () => {
  it('falls while frames are slow, until they are not', () => {
    const levels = frames(12, ({ slack_px, one_of }) => 600 / slack_px / one_of);
    const last = levels[11];
    expect(600 / last.slack_px / last.one_of).toBeLessThanOrEqual(45);
    expect(last).toBe(levels[10]);
  });

  it('is that of rest where graphics are quick, which is drawn at once', () => {
    expect(frames(12, () => 5)[11]).toBe(FINE);
    expect(slices_at_rest(FINE)).toBe(1);
  });

  it('is that of rest where there is little to leave out', () => {
    expect(frames(12, () => 200, 5000)[11]).toBe(FINE);
  });

  it('has a bound however slow frames are', () => {
    const [before, last] = frames(30, () => 1000).slice(-2);
    expect(last).toBe(before);
    expect(last.one_of).toBe(16);
    expect(slices_at_rest(last)).toBe(16);
  });
});
