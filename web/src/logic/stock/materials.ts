/** Groups of materials, and what cutting them takes, as docs/stock.md has it: specific force kc1.1, N/mm², and its exponent. */
export const MATERIALS = {
  P: { kc11: 1700, mc: 0.25 },
  M: { kc11: 2000, mc: 0.21 },
  K: { kc11: 1100, mc: 0.28 },
  N: { kc11: 600, mc: 0.25 },
  S: { kc11: 2600, mc: 0.25 },
  H: { kc11: 4000, mc: 0.25 },
} as const;

export type MaterialGroup = keyof typeof MATERIALS;
export const MATERIAL_GROUPS = Object.keys(MATERIALS) as MaterialGroup[];
export const is_group = (word: string): word is MaterialGroup => Object.hasOwn(MATERIALS, word);
