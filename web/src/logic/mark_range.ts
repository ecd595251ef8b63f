/** Where a diagnostic is underlined in its line. */
import { bytes_of } from './message_size';

/**
 * From and to, in characters of the line. Columns of the server count bytes of UTF-8, from 1 on. What lies at the end of the
 * line, where there is nothing to underline, marks the last word; only an empty line has no more than a place.
 */
export function mark_range(line: string, column: number, length: number): [number, number] {
  const from = characters(line, column - 1);
  const [first] = line.slice(from);
  if (first) return [from, Math.max(from + first.length, characters(line, column - 1 + length))];
  const word = /\S+(?=\s*$)/.exec(line);
  return word ? [word.index, word.index + word[0].length] : [0, line.length];
}

/** How many characters of the line lie within that many bytes; all of them when it has fewer. */
function characters(line: string, bytes: number): number {
  let count = 0;
  for (const character of line) {
    bytes -= bytes_of(character);
    if (bytes < 0) break;
    count += character.length;
  }
  return count;
}
