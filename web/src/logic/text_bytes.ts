/** The bytes of a program as text. Files of older controls and editors are often not UTF-8. */

export type Encoding = 'utf-8' | 'big5' | 'windows-1252';

/** How an operator calls them. */
export const ENCODING_NAMES: Record<Encoding, string> = {
  'utf-8': 'UTF-8',
  big5: 'Big5',
  'windows-1252': 'Windows-1252',
};

export interface Decoded {
  text: string;
  read_as: Encoding;
}

/** Stands in a text for bytes that were no UTF-8, where somebody else has decoded it. */
export const REPLACEMENT = '\ufffd';

/**
 * As UTF-8 if that is what it is, else as Big5, else as Windows-1252, which reads any bytes. A byte order mark stays in the
 * text: saving writes it again, and columns of the server count it.
 */
export function decoded(bytes: Uint8Array): Decoded {
  for (const read_as of ['utf-8', 'big5'] as const) {
    const text = decoded_as(read_as, bytes);
    if (text !== null) return { text, read_as };
  }
  return { text: new TextDecoder('windows-1252').decode(bytes), read_as: 'windows-1252' };
}

function decoded_as(encoding: Encoding, bytes: Uint8Array): string | null {
  try {
    return new TextDecoder(encoding, { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    return null;
  }
}
