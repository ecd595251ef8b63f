/** What the check of the text on the screen has found. */
import type { Diagnostic } from '../logic/protocol';

/** Left out: the text is too long for the check, or the server has not answered. */
export type CheckState = 'under-way' | 'done' | 'left-out';

class TextCheck {
  found = $state.raw<Diagnostic[]>([]);
  state = $state<CheckState>('under-way');
  /** Diagnostics besides those that it tells. */
  more = $state(0);

  begin(): void {
    this.found = [];
    this.more = 0;
    this.state = 'under-way';
  }

  /** Null: it was not checked. */
  take(found: Diagnostic[] | null, more = 0): void {
    this.found = found ?? [];
    this.more = more;
    this.state = found ? 'done' : 'left-out';
  }
}

export const text_check = new TextCheck();
