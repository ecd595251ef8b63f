/** Modal codes in their groups, for the rail: which group a code is of decides where it stands. */

/** Groups of FANUC's list in the order in which they are shown. */
const GROUPS: [name: string, codes: RegExp][] = [
  ['motion', /^G0?[0-3]$|^G33$|^G7[346]$|^G8[0-9]$/],
  ['plane', /^G1[789]$/],
  ['distance', /^G9[01]$/],
  ['feed', /^G9[345]$/],
  ['unit', /^G2[01]$/],
  ['compensation', /^G4[012]$/],
  ['length', /^G4[349]$/],
  ['system', /^G5[4-9](\.1)?/],
  ['path', /^G6[1-4]$/],
  ['rotation', /^G6[89]$/],
  ['scaling', /^G5[01](\.1)?$/],
  ['return', /^G9[89]$/],
  ['speed', /^G9[67]$/],
  ['macro', /^G6[67](\.1)?$/],
];

/** Codes that say that nothing special is on: drawn quietly. */
const QUIET = new Set(
  'G40 G49 G50 G50.1 G64 G67 G69 G80 G94 G97 G98 G15 G21 G17 G90 G22 G40.1 G160 G13.1'.split(' '),
);

export const is_quiet = (code: string): boolean => QUIET.has(code);

/** Codes in the order of their groups, so that each has its place whatever order the machine tells them in. */
export function in_order(codes: string[]): string[] {
  const place = (code: string) => {
    const index = GROUPS.findIndex(([, expression]) => expression.test(code));
    return index < 0 ? GROUPS.length : index;
  };
  return [...codes].sort((a, b) => place(a) - place(b));
}
