import { describe, expect, it } from 'vitest';
import { first_machine, is_at_home, machine_for } from '../src/logic/first_machine';
import type { MachineEntry, ProgramKind } from '../src/logic/protocol';
import { machine_entry } from './machine_entry';

const machine = (
  name: string,
  definition: string,
  suits: ProgramKind[],
  operator: string | null = null,
): MachineEntry => machine_entry(name, definition, { suits, operator });
const ARM = machine('arm', 'arm4', []);
const LASER = machine('laser', 'laser3', ['laser', 'laser-basic']);
const BIG = machine('big', 'mill5', ['mill']);
const MILL = machine('mill', 'mill3', ['mill']);

describe('the machine that a page begins with', () => {
  it('is that of this tab, else that of this browser', () => {
    expect(first_machine([ARM, LASER, MILL], ['laser', 'arm'])?.name).toBe('laser');
    expect(first_machine([ARM, LASER, MILL], ['gone', 'arm'])?.name).toBe('arm');
  });
  it('is the mill where none is known', () => {
    expect(first_machine([ARM, BIG, LASER, MILL], [null, ''])?.name).toBe('mill');
    expect(first_machine([ARM, LASER, BIG], [])?.name).toBe('big');
    expect(first_machine([ARM, LASER], [])?.name).toBe('arm');
    expect(first_machine([], ['mill'])).toBeUndefined();
  });
});

describe('the machine for a program', () => {
  it('makes such programs, is free, and is the usual one', () => {
    const taken = machine('laser', 'laser3', ['laser-basic'], 'client-1');
    const other = machine('laser-xtz', 'laser-xtz', ['laser-basic']);
    const usual = machine('second', 'laser3', ['laser-basic']);
    expect(machine_for([MILL, taken, other, usual], 'laser-basic', 'laser3')?.name).toBe('second');
    expect(machine_for([MILL, taken, other], 'laser-basic', 'laser3')?.name).toBe('laser-xtz');
    expect(machine_for([MILL, taken], 'laser-basic', 'laser3')?.name).toBe('laser');
    expect(machine_for([MILL], 'lathe', 'lathe2')).toBeUndefined();
    const plain = machine('turning', 'lathe2', ['lathe']);
    const with_c = machine('driven', 'lathe3c', ['lathe', 'lathe-c']);
    expect(machine_for([with_c, plain], 'lathe', 'lathe2')?.name).toBe('turning');
    expect(machine_for([with_c, plain], 'lathe-c', 'lathe3c')?.name).toBe('driven');
  });
  it('is any where the program shows nothing', () => {
    expect(is_at_home(ARM, 'any')).toBe(true);
    expect(is_at_home(ARM, 'mill')).toBe(false);
    expect(is_at_home(MILL, 'mill')).toBe(true);
    expect(is_at_home(undefined, 'mill')).toBe(true);
  });
});
