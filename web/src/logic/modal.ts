/** Modal codes in their groups, for the rail: which group a code is of decides where it stands. */
import type { ModalCode, ModalGroup } from './protocol';

/** "G54.1 P3" is G54.1. */
const code_of = (text: string): string => text.split(' ')[0];

/** What the machine says of a code; undefined: it is none of its groups. */
export const row_of = (groups: readonly ModalGroup[], text: string): ModalCode | undefined =>
  groups.flatMap(({ codes }) => codes).find(({ code }) => code === code_of(text));

/** Codes in the order of their groups, so that each has its place whatever order the machine tells them in. */
export function in_order(groups: readonly ModalGroup[], texts: readonly string[]): string[] {
  const place = (text: string): number => {
    const index = groups.findIndex(({ codes }) => codes.some(({ code }) => code === code_of(text)));
    return index < 0 ? groups.length : index;
  };
  return [...texts].sort((a, b) => place(a) - place(b));
}
