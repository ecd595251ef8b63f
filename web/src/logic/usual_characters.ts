/**
 * How usual the characters are that bytes would stand for in an encoding of two bytes. Each of them has its everyday
 * characters in rows of their own; bytes of another encoding fall into the others as often.
 */

type TwoByteEncoding = 'big5' | 'gbk' | 'shift_jis';

const is_lead: Record<TwoByteEncoding, (byte: number) => boolean> = {
  big5: (byte) => byte >= 0x81 && byte <= 0xfe,
  gbk: (byte) => byte >= 0x81 && byte <= 0xfe,
  shift_jis: (byte) => (byte >= 0x81 && byte <= 0x9f) || (byte >= 0xe0 && byte <= 0xfc),
};

const is_usual: Record<TwoByteEncoding, (lead: number, trail: number) => boolean> = {
  // Punctuation, then the 5,401 characters of the first plane, by strokes.
  big5: (lead) => lead === 0xa1 || (lead >= 0xa4 && lead <= 0xc6),
  // Punctuation and full-width letters, then the 3,755 characters of the first level, by sound.
  gbk: (lead, trail) =>
    trail >= 0xa1 && (lead === 0xa1 || lead === 0xa3 || (lead >= 0xb0 && lead <= 0xd7)),
  // Punctuation, full-width letters, the two kana, then the 2,965 kanji of the first level.
  shift_jis: (lead) => (lead >= 0x81 && lead <= 0x83) || (lead >= 0x88 && lead <= 0x97),
};

/** Of the first rows, in which the words of everyday stand; they decide between encodings that both fit. */
const is_everyday: Record<TwoByteEncoding, (lead: number, trail: number) => boolean> = {
  big5: (lead) => lead >= 0xa4 && lead <= 0xb4,
  gbk: (lead, trail) => trail >= 0xa1 && lead >= 0xb0 && lead <= 0xd7,
  shift_jis: (lead) => lead === 0x82 || lead === 0x83,
};

/** 0 to 1; 0: there are none. Bytes that fit the encoding are a precondition. */
export function usual_share(encoding: TwoByteEncoding, bytes: Uint8Array): number {
  let pairs = 0;
  let points = 0;
  for (let i = 0; i + 1 < bytes.length; i++) {
    if (!is_lead[encoding](bytes[i])) continue;
    const [lead, trail] = [bytes[i], bytes[++i]];
    pairs++;
    if (is_usual[encoding](lead, trail)) points += 0.8;
    if (is_everyday[encoding](lead, trail)) points += 0.2;
  }
  return pairs ? points / pairs : 0;
}
