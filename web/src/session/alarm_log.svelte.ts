/** The alarms that this page has seen of its machine, the newest first; kept by the browser. */
import type { Alarm } from '../logic/protocol';
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
    this.last = '';
    try {
      this.list = JSON.parse(localStorage.getItem(key_of(machine)) ?? '[]') as Seen[];
    } catch {
      this.list = [];
    }
    // One that stood when the page was left and still stands is the same.
    if (this.list[0]) this.last = JSON.stringify(this.list[0].alarm);
  }

  private add(alarm: Alarm): void {
    this.list = [{ at: Date.now(), alarm }, ...this.list].slice(0, MOST);
    this.keep();
  }

  private keep(): void {
    try {
      localStorage.setItem(key_of(this.machine), JSON.stringify(this.list));
    } catch {
      // A browser that keeps nothing shows those of this visit.
    }
  }
}

export const alarm_log = new AlarmLog();
