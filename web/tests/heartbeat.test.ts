import { describe, expect, it } from 'vitest';
import { Heartbeat, SILENT_MS, TICK_MS } from '../src/logic/heartbeat';

/** Ticks as a timer does; the times at which a ping was wanted. */
function run(beat: Heartbeat, from: number, to: number, answer: boolean): number[] {
  const pings: number[] = [];
  for (let now = from; now <= to; now += TICK_MS) {
    if (!beat.tick(now)) continue;
    pings.push(now);
    if (!answer) continue;
    beat.heard();
    beat.answered(now + 20, now + 5000);
  }
  return pings;
}

describe('a heartbeat', () => {
  it('asks each second', () => {
    expect(run(new Heartbeat(), 0, 4000, true)).toEqual([0, 1000, 2000, 3000, 4000]);
  });

  it('is silent when nothing has come for three seconds, and not before', () => {
    const beat = new Heartbeat();
    run(beat, 0, SILENT_MS - TICK_MS, false);
    expect(beat.is_silent).toBe(false);
    beat.tick(SILENT_MS);
    expect(beat.is_silent).toBe(true);
  });

  it('takes anything for an answer', () => {
    const beat = new Heartbeat();
    run(beat, 0, 2500, false);
    beat.heard();
    run(beat, 3000, 5000, false);
    expect(beat.is_silent).toBe(false);
    beat.heard();
    run(beat, 5500, 9000, false);
    expect(beat.is_silent).toBe(true);
    beat.heard();
    expect(beat.is_silent).toBe(false);
  });

  it('does not count the time in which the page itself slept', () => {
    const beat = new Heartbeat();
    expect(beat.tick(0)).toBe(true);
    expect(beat.tick(60_000)).toBe(false);
    expect(beat.is_silent).toBe(false);
  });

  it('knows the clock of the server from the quickest answer, and is never ahead of it', () => {
    const beat = new Heartbeat();
    expect(beat.server_ms(0)).toBeNull();
    // The server is 100 s ahead; answers take 400, 30 and 900 ms to come back.
    for (const [at, late] of [
      [0, 400],
      [1000, 30],
      [2000, 900],
    ])
      beat.answered(at + late, at + 100_000);
    const told = beat.server_ms(5000)!;
    expect(told).toBe(104_970);
    expect(told).toBeLessThanOrEqual(105_000);
  });

  it('knows nothing of a new line', () => {
    const beat = new Heartbeat();
    run(beat, 0, 3000, true);
    beat.reset();
    expect(beat.server_ms(4000)).toBeNull();
    expect(beat.tick(3100)).toBe(true);
  });
});
