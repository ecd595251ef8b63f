/** Short sentences for the operator: what the machine refused, what was done. They go by themselves. */

export interface Notice {
  id: number;
  tone: 'refused' | 'done';
  text: string;
}

const SECONDS = { refused: 9, done: 4 };
const MOST = 4;

class Notices {
  list = $state<Notice[]>([]);
  private next = 1;

  say(text: string, tone: Notice['tone'] = 'done'): void {
    const id = this.next++;
    this.list = [...this.list.filter((n) => n.text !== text), { id, tone, text }].slice(-MOST);
    setTimeout(() => this.dismiss(id), 1000 * SECONDS[tone]);
  }

  dismiss(id: number): void {
    this.list = this.list.filter((notice) => notice.id !== id);
  }
}

export const notices = new Notices();
