/** The bytes of a program as text, and a text as bytes again. Files of older controls and editors are often not UTF-8. */
import { usual_share } from './usual_characters';

export type Encoding = 'utf-8' | 'utf-16le' | 'utf-16be' | LegacyEncoding;
export type LegacyEncoding = 'big5' | 'gbk' | 'shift_jis' | 'windows-1252';

/** How an operator calls them. */
export const ENCODING_NAMES: Record<Encoding, string> = {
  'utf-8': 'UTF-8',
  big5: 'Big5',
  gbk: 'GBK',
  shift_jis: 'Shift-JIS',
  'windows-1252': 'Windows-1252',
  'utf-16le': 'UTF-16 LE',
  'utf-16be': 'UTF-16 BE',
};

/** Those that can be chosen, where the bytes do not tell it. */
export const CHOSEN_ENCODINGS = [
  'utf-8',
  'big5',
  'gbk',
  'shift_jis',
  'windows-1252',
] as const satisfies Encoding[];

export interface Decoded {
  text: string;
  read_as: Encoding;
}

/** Stands in a text for bytes that were no UTF-8, where somebody else has decoded it. */
export const REPLACEMENT = '\ufffd';

/** No control reads UTF-16: such a text goes to the machine, and into the library, as UTF-8. */
export const is_kept = (encoding: Encoding): boolean => !encoding.startsWith('utf-16');

/** Of the bytes, so many may be control characters; in random ones every ninth is. */
const MOST_CONTROLS = 0.03;
/** Of the characters that two bytes stand for, at least so many are usual ones where the guess is right. */
const LEAST_USUAL = 0.6;
const LOOKED_AT = 1 << 20;

/**
 * By the byte order mark, else as UTF-16 if every second byte is 0, as UTF-8 if that is what it is, else as the legacy
 * encoding whose usual characters it has most of, else as Windows-1252, which reads any bytes. The mark of UTF-8 stays in
 * the text: saving writes it again, and columns of the server count it. Null: this is no text.
 */
export function decoded(bytes: Uint8Array): Decoded | null {
  const wide = utf_16_of(bytes);
  if (wide) return { text: new TextDecoder(wide).decode(bytes), read_as: wide };
  if (!is_text(bytes)) return null;
  const utf_8 = decoded_as('utf-8', bytes);
  if (utf_8 !== null) return { text: utf_8, read_as: 'utf-8' };
  const read_as = legacy_encoding_of(bytes);
  return { text: read(read_as, bytes), read_as };
}

/** As the operator says. Bytes that have no meaning in it are shown as U+FFFD. */
export const read = (encoding: Encoding, bytes: Uint8Array): string =>
  new TextDecoder(encoding, { ignoreBOM: true }).decode(bytes);

/** Whether bytes can be a text in any of the encodings; its beginning says it. */
export function is_text(bytes: Uint8Array): boolean {
  if (utf_16_of(bytes)) return true;
  const end = Math.min(bytes.length, LOOKED_AT);
  let controls = 0;
  for (let i = 0; i < end; i++) {
    if (bytes[i] === 0) return false;
    if (bytes[i] < 0x20 && !(bytes[i] >= 0x09 && bytes[i] <= 0x0d)) controls++;
  }
  return controls <= MOST_CONTROLS * end + 4; // a short tape begins and ends with some
}

function utf_16_of(bytes: Uint8Array): 'utf-16le' | 'utf-16be' | null {
  if (bytes[0] === 0xff && bytes[1] === 0xfe) return 'utf-16le';
  if (bytes[0] === 0xfe && bytes[1] === 0xff) return 'utf-16be';
  const end = Math.min(bytes.length, LOOKED_AT) & ~1;
  let even = 0;
  let odd = 0;
  for (let i = 0; i < end; i += 2) {
    if (bytes[i] === 0) even++;
    if (bytes[i + 1] === 0) odd++;
  }
  const most = end / 2;
  if (most === 0) return null;
  if (odd > 0.6 * most && even < 0.05 * most) return 'utf-16le';
  return even > 0.6 * most && odd < 0.05 * most ? 'utf-16be' : null;
}

function legacy_encoding_of(bytes: Uint8Array): LegacyEncoding {
  let best: LegacyEncoding = 'windows-1252';
  let most = LEAST_USUAL;
  for (const encoding of ['big5', 'gbk', 'shift_jis'] as const) {
    if (decoded_as(encoding, bytes) === null) continue;
    const share = usual_share(encoding, bytes);
    if (share > most) {
      best = encoding;
      most = share;
    }
  }
  return best;
}

function decoded_as(encoding: Encoding, bytes: Uint8Array): string | null {
  try {
    return new TextDecoder(encoding, { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    return null;
  }
}

/** What a text is in an encoding; the first character that has no place in it, where there is one. */
export type Encoded = { bytes: Uint8Array<ArrayBuffer> } | { missing: string };

export function encoded(text: string, encoding: Encoding): Encoded {
  if (encoding === 'utf-8' || !is_kept(encoding)) return { bytes: new TextEncoder().encode(text) };
  const codes = codes_of(encoding);
  const bytes = new Uint8Array(2 * text.length);
  let at = 0;
  for (const character of text) {
    const code = character < '\u0080' ? character.charCodeAt(0) : codes.get(character);
    if (code === undefined) return { missing: character };
    if (code > 0xff) bytes[at++] = code >> 8;
    bytes[at++] = code & 0xff;
  }
  return { bytes: bytes.slice(0, at) };
}

const tables = new Map<Encoding, Map<string, number>>();

/** Browsers only read these encodings: what each character is written as is found by reading every code. */
function codes_of(encoding: Encoding): Map<string, number> {
  const known = tables.get(encoding);
  if (known) return known;
  const codes = new Map<string, number>();
  const add = (code: number, bytes: number[]): void => {
    const text = decoded_as(encoding, Uint8Array.from(bytes));
    if (text !== null && [...text].length === 1 && !codes.has(text)) codes.set(text, code);
  };
  for (let byte = 0x80; byte <= 0xff; byte++) add(byte, [byte]);
  if (encoding !== 'windows-1252') {
    for (let lead = 0x81; lead <= 0xfe; lead++)
      for (let trail = 0x40; trail <= 0xfe; trail++) add((lead << 8) | trail, [lead, trail]);
  }
  tables.set(encoding, codes);
  return codes;
}
