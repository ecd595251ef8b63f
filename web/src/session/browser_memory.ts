/**
 * What the browser keeps for this page: of this tab until it is closed, or from one visit to the next. A browser that keeps
 * nothing, or throws, still runs the panel: it begins each time as the first time.
 */
export type Memory = 'tab' | 'browser';

const storage = (memory: Memory): Storage => (memory === 'tab' ? sessionStorage : localStorage);

/** Null: nothing is kept under this key. */
export function kept(key: string, memory: Memory = 'browser'): string | null {
  try {
    return storage(memory).getItem(key);
  } catch {
    return null;
  }
}

export function keep(key: string, text: string, memory: Memory = 'browser'): void {
  try {
    storage(memory).setItem(key, text);
  } catch {
    // Full, or forbidden.
  }
}

/** As it was kept, or what is said otherwise: also where it is no JSON any more. */
export function kept_value<T>(key: string, otherwise: T): T {
  try {
    return (JSON.parse(kept(key) ?? 'null') as T | null) ?? otherwise;
  } catch {
    return otherwise;
  }
}
