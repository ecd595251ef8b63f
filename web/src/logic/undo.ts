/** Edits of tables that can be taken back: variables, offsets, tools. The editor has its own history. */

export interface Edit {
  /** What the operator changed, for the message: `#500`, `G54 X`. */
  what: string;
  undo(): Promise<unknown>;
  redo(): Promise<unknown>;
}

const DEPTH = 200;

export class UndoStack {
  private done: Edit[] = [];
  private undone: Edit[] = [];

  record(edit: Edit): void {
    this.done.push(edit);
    if (this.done.length > DEPTH) this.done.shift();
    this.undone = [];
  }

  get can_undo(): boolean {
    return this.done.length > 0;
  }
  get can_redo(): boolean {
    return this.undone.length > 0;
  }

  /** Takes the last edit back; when the machine refuses, it stays on the stack. Null: there is none. */
  async undo(): Promise<string | null> {
    return move(this.done, this.undone, (edit) => edit.undo());
  }

  async redo(): Promise<string | null> {
    return move(this.undone, this.done, (edit) => edit.redo());
  }

  clear(): void {
    this.done = [];
    this.undone = [];
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
