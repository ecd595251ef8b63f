/** What is possible where an edit is refused, as far as one more member of the edits file is enough. */
import type { Edit } from './edits';

export type Offer = 'scope-all' | 'unroll' | 'argument';

const OF_CODE: Record<string, Offer> = {
  EDIT_SHARED: 'scope-all',
  EDIT_IN_LOOP: 'unroll',
  EDIT_EXPRESSION: 'argument',
};

/** `has_call`: a call is known that hands the number over; without one an expression can only be written out. */
export function offer_of(code: string, has_call: boolean): Offer | null {
  const offer = OF_CODE[code] ?? null;
  return offer === 'argument' && !has_call ? 'unroll' : offer;
}

/** The edits with the offer taken. */
export function with_offer(edits: readonly Edit[], offer: Offer): Edit[] {
  if (offer === 'argument') return [...edits];
  const more = offer === 'scope-all' ? { scope: 'all' as const } : { unroll: true };
  return edits.map((edit) => ({ ...edit, ...more }));
}
