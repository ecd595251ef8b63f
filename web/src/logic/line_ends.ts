/**
 * Lines as the control counts them: a line ends with LF, with any number of CRs and LF, or with a CR that no LF follows. CRs
 * behind an LF are blanks of the next line.
 */

export interface LineEnds {
  /** What ends the lines of a text, most of them where they differ. */
  end: string;
  is_mixed: boolean;
}

interface Line {
  text: string;
  /** Empty: the text ends here. */
  end: string;
}

export function lines_of(text: string): string[] {
  if (!text.includes('\r')) return text.split('\n');
  return Array.from(split(text), (line) => line.text);
}

/** From 1 on; empty where there is no such line. */
export function line_of(text: string, number: number): string {
  let at = 0;
  for (const line of split(text)) if (++at === number) return line.text;
  return '';
}

export function line_ends_of(text: string): LineEnds {
  if (!text.includes('\r')) return { end: '\n', is_mixed: false };
  const counts = new Map<string, number>();
  for (const { end } of split(text)) if (end) counts.set(end, (counts.get(end) ?? 0) + 1);
  const by_count = [...counts].sort((a, b) => b[1] - a[1]);
  return { end: by_count[0]?.[0] ?? '\n', is_mixed: by_count.length > 1 };
}

/** CR LF */
export const line_end_name = (end: string): string =>
  [...end].map((c) => (c === '\r' ? 'CR' : 'LF')).join(' ');

function* split(text: string): Generator<Line> {
  let begin = 0;
  // One run of CRs at a time, whatever follows it: a file of nothing but CRs takes no longer than another.
  for (const { 0: found, index } of text.matchAll(/\r+\n?|\n/g)) {
    if (found.endsWith('\n')) {
      yield { text: text.slice(begin, index), end: found };
      begin = index + found.length;
    } else if (text[index - 1] !== '\n') {
      for (let i = 0; i < found.length; i++) {
        yield { text: text.slice(begin, index + i), end: '\r' };
        begin = index + i + 1;
      }
    }
  }
  yield { text: text.slice(begin), end: '' };
}
