/** Edits of tables that can be taken back: variables, offsets, tools. The editor has its own history. */

export interface Edit {
  /** What the operator changed, for the message: `#500`, `G54 X`. */
  what: string;
  redo(): Promise<unknown>;
  undo(): Promise<unknown>;
}

const DEPTH = 200;

/**
 * Each change waits for the one before it: keys are faster than a machine answers, and what was asked first must be the
 * first to be done. A change that the machine refuses leaves the stack as it was.
 */
export class UndoStack {
  private done: Edit[] = [];
  private undone: Edit[] = [];
  private last: Promise<unknown> = Promise.resolve();

  /** Does the edit, which can be taken back from then on. Rejected: the machine refused. */
  perform(edit: Edit): Promise<void> {
    return this.in_turn(async () => {
      const { done } = this;
      await edit.redo();
      done.push(edit);
      if (done.length > DEPTH) done.shift();
      this.undone = [];
    });
  }

  /** Takes the last edit back. Null: there is none. */
  undo(): Promise<string | null> {
    return this.in_turn(() => move(this.done, this.undone, (edit) => edit.undo()));
  }

  redo(): Promise<string | null> {
    return this.in_turn(() => move(this.undone, this.done, (edit) => edit.redo()));
  }

  clear(): void {
    this.done = [];
    this.undone = [];
  }

  private in_turn<T>(act: () => Promise<T>): Promise<T> {
    const now = this.last.then(act);
    this.last = now.catch(() => null);
    return now;
  }
}

async function move(
  from: Edit[],
  to: Edit[],
  act: (edit: Edit) => Promise<unknown>,
): Promise<string | null> {
  const edit = from.at(-1);
  if (!edit) return null;
  await act(edit);
  from.pop();
  to.push(edit);
  return edit.what;
}
