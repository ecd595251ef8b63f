/** Which machine a page begins with, and which one a program may go to. */
import type { MachineEntry, ProgramKind } from './protocol';

/** The first of the names that there is, else a mill: to most people the least surprising machine. */
export function first_machine(
  machines: readonly MachineEntry[],
  wishes: readonly (string | null)[],
): MachineEntry | undefined {
  for (const wish of wishes) {
    const found = wish ? machines.find(({ name }) => name === wish) : undefined;
    if (found) return found;
  }
  return (
    machines.find(({ name, suits }) => name === 'mill' && suits.includes('mill')) ??
    machines.find(({ suits }) => suits.includes('mill')) ??
    machines[0]
  );
}

/** A machine of this server that makes such programs: one that nobody operates, and of those one of the usual kind, first. */
export function machine_for(
  machines: readonly MachineEntry[],
  kind: ProgramKind,
  usual: string,
): MachineEntry | undefined {
  const rank = ({ operator, definition }: MachineEntry) =>
    (operator === null ? 0 : 2) + (definition === usual ? 0 : 1);
  return machines.filter(({ suits }) => suits.includes(kind)).sort((a, b) => rank(a) - rank(b))[0];
}

/** Whether a program of this kind is at home on a machine; one that shows nothing is so everywhere. */
export const is_at_home = (machine: MachineEntry | undefined, kind: ProgramKind): boolean =>
  kind === 'any' || !machine || machine.suits.includes(kind);
