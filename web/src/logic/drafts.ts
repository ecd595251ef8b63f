/** Drafts: texts that are edited and not saved, kept by the browser until they are saved or discarded. */

export interface Draft {
  /** Of the program. */
  name: string;
  text: string;
  /** ms since 1970. */
  at: number;
}

/** Where drafts are kept. What a call of `put` or `remove` begins is kept, even if the page is left right after it. */
export interface DraftStore {
  get(name: string): Promise<Draft | null>;
  put(draft: Draft): Promise<void>;
  remove(name: string): Promise<void>;
}

const DATABASE = 'kerf';
const STORE = 'drafts';

/** In the browser's database, which takes long texts. */
export class DatabaseDrafts implements DraftStore {
  private opened: Promise<IDBDatabase> | null = null;
  private database: IDBDatabase | null = null;

  constructor(private readonly factory: IDBFactory = indexedDB) {}

  async get(name: string): Promise<Draft | null> {
    return (await this.run<Draft | undefined>('readonly', (store) => store.get(name))) ?? null;
  }
  async put(draft: Draft): Promise<void> {
    await this.run('readwrite', (store) => store.put(draft));
  }
  async remove(name: string): Promise<void> {
    await this.run('readwrite', (store) => store.delete(name));
  }

  private async run<T>(
    mode: IDBTransactionMode,
    ask: (store: IDBObjectStore) => IDBRequest,
  ): Promise<T> {
    // Once it is open nothing is waited for: what is asked last, when the page is left, goes out at once.
    const database = this.database ?? (await (this.opened ??= this.open()));
    const transaction = database.transaction(STORE, mode);
    const request = ask(transaction.objectStore(STORE));
    transaction.commit(); // a page that goes takes along what is not committed
    return new Promise((resolve, reject) => {
      transaction.oncomplete = () => resolve(request.result as T);
      transaction.onerror = transaction.onabort = () => reject(transaction.error);
    });
  }

  private open(): Promise<IDBDatabase> {
    const request = this.factory.open(DATABASE, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(STORE, { keyPath: 'name' });
    return new Promise((resolve, reject) => {
      request.onsuccess = () => resolve((this.database = request.result));
      request.onerror = () => reject(request.error);
    });
  }
}

/**
 * Puts what was edited last into a store, soon and in order: an edit while the last one is being written waits, and of
 * several that wait only the newest is written.
 */
export class DraftKeeper {
  private readonly waiting = new Map<string, Draft | null>();
  private writing: Promise<void> | null = null;

  constructor(private readonly store: DraftStore) {}

  /** Null: there is none any more. */
  keep(name: string, draft: Draft | null): void {
    this.waiting.set(name, draft);
    this.writing ??= this.write();
  }

  /** The draft of a program, one that is not written yet included. */
  async of(name: string): Promise<Draft | null> {
    const waits = this.waiting.get(name);
    if (waits !== undefined) return waits;
    await this.written();
    return this.store.get(name).catch(() => null);
  }

  /** The page may be gone in a moment: what waits for a draft that is being written does not wait longer. */
  leave(): void {
    for (const [name, draft] of this.waiting) {
      this.waiting.delete(name);
      void this.put(name, draft);
    }
  }

  async written(): Promise<void> {
    while (this.writing) await this.writing;
  }

  private async write(): Promise<void> {
    await null; // what is kept in one go is written in one go
    for (const [name, draft] of this.waiting) {
      this.waiting.delete(name);
      await this.put(name, draft);
    }
    this.writing = null;
    if (this.waiting.size) this.writing = this.write();
  }

  /** A browser that keeps nothing still runs the panel; leaving the page asks. */
  private async put(name: string, draft: Draft | null): Promise<void> {
    await (draft ? this.store.put(draft) : this.store.remove(name)).catch(() => null);
  }
}
