/** The list of breakpoints: at most one a line, variables beside them. Lists are values; each change makes a new one. */
import type { Breakpoint } from './protocol';

export const at = (list: Breakpoint[], file: string, line: number): Breakpoint | undefined =>
  list.find((b) => b.file === file && b.line === line);

export function toggled(list: Breakpoint[], file: string, line: number): Breakpoint[] {
  return at(list, file, line) ? without(list, file, line) : sorted([...list, { file, line }]);
}

export const without = (list: Breakpoint[], file: string, line: number): Breakpoint[] =>
  list.filter((b) => b.file !== file || b.line !== line);

/** An empty condition makes the breakpoint unconditional. */
export function with_condition(
  list: Breakpoint[],
  file: string,
  line: number,
  condition: string,
): Breakpoint[] {
  const text = condition.trim();
  const place: Breakpoint = text ? { file, line, condition: text } : { file, line };
  return sorted([...without(list, file, line), place]);
}

export function watching(list: Breakpoint[], variable: string): Breakpoint[] {
  const name = variable.trim();
  if (!name || list.some((b) => b.variable === name)) return list;
  return sorted([...list, { variable: name }]);
}

export const unwatching = (list: Breakpoint[], variable: string): Breakpoint[] =>
  list.filter((b) => b.variable !== variable);

/** Lines move with the text while it is edited. */
export function moved(
  list: Breakpoint[],
  file: string,
  new_line: (line: number) => number | null,
): Breakpoint[] {
  const next: Breakpoint[] = [];
  for (const b of list) {
    if (b.file !== file || b.line === undefined) next.push(b);
    else {
      const line = new_line(b.line);
      if (line !== null && !at(next, file, line)) next.push({ ...b, line });
    }
  }
  return sorted(next);
}

function sorted(list: Breakpoint[]): Breakpoint[] {
  const key = (b: Breakpoint) => `${b.variable ? 1 : 0}${b.file ?? ''}`;
  return [...list].sort((a, b) => key(a).localeCompare(key(b)) || (a.line ?? 0) - (b.line ?? 0));
}
