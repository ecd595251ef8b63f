/** The alarms that this page has seen of its machine, the newest first; kept by the browser. */
import type { Alarm } from '../logic/protocol';
import { keep, kept_value } from './browser_memory';
import { panel } from './panel.svelte';

export interface Seen {
  /** ms since 1970. */
  at: number;
  alarm: Alarm;
}

const MOST = 100;
const key_of = (machine: string): string => `kerf.alarms.${machine}`;

class AlarmLog {
  list = $state.raw<Seen[]>([]);
  private machine = '';
  private last = '';

  /** To be called whenever the machine's alarm may be another. */
  look(): void {
    const { machine, state } = panel;
    if (machine !== this.machine) this.open(machine);
    const now = state.alarm ? JSON.stringify(state.alarm) : '';
    if (state.alarm && now !== this.last) this.add(state.alarm);
    this.last = now;
  }

  clear(): void {
    this.list = [];
    this.keep();
  }

  private open(machine: string): void {
    this.machine = machine;
    this.list = kept_value<Seen[]>(key_of(machine), []);
    // One that stood when the page was left and still stands is the same.
    this.last = this.list[0] ? JSON.stringify(this.list[0].alarm) : '';
  }

  private add(alarm: Alarm): void {
    this.list = [{ at: Date.now(), alarm }, ...this.list].slice(0, MOST);
    this.keep();
  }

  private keep(): void {
    keep(key_of(this.machine), JSON.stringify(this.list));
  }
}

export const alarm_log = new AlarmLog();
