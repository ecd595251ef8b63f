/** Which dialog is open; at most one. */
export type DialogName = 'library' | 'settings' | 'help' | 'new-machine' | 'condition' | 'manual';

class Dialogs {
  open = $state<DialogName | null>(null);
  show(name: DialogName): void {
    this.open = name;
  }
  close(): void {
    this.open = null;
  }
}

export const dialogs = new Dialogs();
