/** Names that the library takes, and the nearest such name to one that it refuses. The server checks them again. */

const MOST_BYTES = 100;
const FORBIDDEN = /[/\\:*?"<>|]/g;
// Control characters and halves of surrogates are no text.
const NO_TEXT = /[\u0000-\u001f\u007f-\u009f\ud800-\udfff\u2028\u2029]/gu;

// Directions of writing and what joins or parts letters: two names that look the same would not be.
const UNSEEN =
  /[\u00ad\u061c\u180e\u200b-\u200f\u202a-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb\u{e0000}-\u{e0fff}]/gu;
// Accents that no letter has in it.
const ACCENTS = /[\u0300-\u036f\u3099\u309a\u1100-\u11ff]/g;
const DEVICE = /^(con|prn|aux|nul|(com|lpt)[1-9]) *(\.|$)/i;

const bytes_in = (text: string): number => new TextEncoder().encode(text).length;

/** The same name where the library takes it. */
export function mended_name(name: string): string {
  const seen = name.normalize('NFC').replace(NO_TEXT, '').replace(UNSEEN, '').replace(ACCENTS, '');
  const plain = seen.replace(FORBIDDEN, '-').replace(/^[-. ]+|[. ]+$/g, '');
  const short = shortened(DEVICE.test(plain) ? `_${plain}` : plain);
  return short || 'program.nc';
}

/** The ending stays: it says the language. */
function shortened(name: string): string {
  const dot = name.lastIndexOf('.');
  const ending = dot > 0 && name.length - dot <= 8 ? name.slice(dot) : '';
  let stem = [...name.slice(0, name.length - ending.length)];
  while (stem.length && bytes_in(stem.join('') + ending) > MOST_BYTES) stem = stem.slice(0, -1);
  return (stem.join('') + ending).replace(/[. ]+$/, '');
}

/** part.nc, part-2.nc, part-3.nc: the first that is free. */
export function free_name(name: string, taken: readonly string[]): string {
  const dot = name.lastIndexOf('.');
  const [stem, ending] = dot > 0 ? [name.slice(0, dot), name.slice(dot)] : [name, ''];
  for (let number = 2; ; number++) {
    const found = mended_name(`${stem}-${number}${ending}`);
    if (!taken.includes(found)) return found;
  }
}
