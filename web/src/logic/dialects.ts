/** The dialects of the server, by what it says of them. */
import type { Dialect } from './protocol';

const lower = (name: string): string => name.toLowerCase();

/** The library has the bytes of such a program, and this page its listing, which the server makes of them and reads back. */
export const is_listing = (dialects: readonly Dialect[], file: string): boolean =>
  dialects.some((d) => d.is_listing && lower(file).endsWith(d.ending));

/** What a new program of this name begins with. */
export const fresh_text = (dialects: readonly Dialect[], file: string): string =>
  dialects.find((d) => file.endsWith(d.ending))?.fresh ?? '\n';

/** Undefined: comments of the dialect have an end. */
export function line_comment(dialect: Dialect | undefined): string | undefined {
  const [begin, end] = dialect?.comment ?? [undefined, ''];
  return end === '' ? begin : undefined;
}
