/** What is known of the line to the server, in words of time: since when nothing has come, and what was known last. */
import type { LineState } from '../logic/connection';
import type { MachineState } from '../logic/protocol';

interface Known {
  /** ms since 1970, by the clock of this computer. */
  since: number;
  status: MachineState['status'];
  line: number;
}

/** The server that was spoken to is gone, and another run of it answers. */
interface Restart {
  began: number;
  /** What the machine did before; null: nothing that could have been cut off. */
  cut_off: Known | null;
}

const WORKING: ReadonlySet<string> = new Set(['running', 'held', 'stopped', 'step']);

class Link {
  /** Null: the line holds. */
  lost = $state.raw<Known | null>(null);
  restart = $state.raw<Restart | null>(null);
  private server = '';
  private last: Known | null = null;

  /** `heard_at`: when anything came last. */
  turned(state: LineState, heard_at: number, machine: MachineState, was_known: boolean): void {
    if (state === 'open') this.lost = null;
    else if (!this.lost && was_known)
      this.lost = this.last = { since: heard_at, status: machine.status, line: machine.line };
  }

  hello(server: string, began: number): void {
    const is_other = this.server !== '' && server !== this.server;
    this.server = server;
    if (!is_other) return;
    this.restart = {
      began,
      cut_off: this.last && WORKING.has(this.last.status) ? this.last : null,
    };
  }

  dismiss(): void {
    this.restart = null;
  }
}

export const link = new Link();

/** 13:27:04 */
export const clock_time = (ms: number): string =>
  new Date(ms).toLocaleTimeString('en-GB', {
    hour: '2-digit',
    minute: '2-digit',
    second: '2-digit',
  });
