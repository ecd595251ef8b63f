/**
 * Whether the other end still answers, and what its clock shows. A ping is sent each second; what counts as silence is time
 * in which this page was awake and waited, so that a page that slept or computed does not take itself for a dead line.
 */

export const PING_MS = 1000;
export const SILENT_MS = 3000;
export const TICK_MS = 200;
/** A tick that comes later than this: the page was not awake in between. */
const AWAKE_MS = 1000;
/** Pings of which the clock of the server is taken. */
const CLOCKS_KEPT = 8;

export class Heartbeat {
  private asked = false;
  private waited_ms = 0;
  private asked_at = -Infinity;
  private ticked_at: number | null = null;
  private leads: number[] = [];

  /** A new line: nothing is known of it. */
  reset(): void {
    this.asked = false;
    this.waited_ms = 0;
    this.asked_at = -Infinity;
    this.ticked_at = null;
    this.leads = [];
  }

  /** True: a ping is to be sent now. To be called each TICK_MS. */
  tick(now_ms: number): boolean {
    const passed = this.ticked_at === null ? 0 : now_ms - this.ticked_at;
    this.ticked_at = now_ms;
    if (this.asked) {
      this.waited_ms += Math.min(passed, AWAKE_MS);
      return false;
    }
    if (now_ms - this.asked_at < PING_MS - TICK_MS / 2) return false;
    this.asked = true;
    this.asked_at = now_ms;
    return true;
  }

  /** Anything has come. */
  heard(): void {
    this.waited_ms = 0;
  }

  answered(now_ms: number, server_ms: number): void {
    this.asked = false;
    this.leads = [...this.leads, server_ms - now_ms].slice(-CLOCKS_KEPT);
  }

  get is_silent(): boolean {
    return this.waited_ms >= SILENT_MS;
  }

  /**
   * At least what the server's clock shows now, as it was read before its answer travelled; the quickest answer says it
   * best. Null: it has not told it yet.
   */
  server_ms(now_ms: number): number | null {
    return this.leads.length ? now_ms + Math.max(...this.leads) : null;
  }
}
