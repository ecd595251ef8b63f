/** Programs that come to this page: dropped, uploaded, or opened. One is shown, and loaded where it is at home. */
import { is_at_home, machine_for } from '../logic/first_machine';
import type { ProgramLook } from '../logic/protocol';
import { documents } from './documents.svelte';
import { notices } from './notices.svelte';
import { panel } from './panel.svelte';
import { preferences } from './preferences.svelte';
import { slider } from './slider.svelte';
import { t } from './words.svelte';

/** A program that looks to be written for another machine. */
export interface Stranger {
  name: string;
  look: ProgramLook;
  /** The machine of this server that makes such programs; empty: there is none. */
  machine: string;
}

class Arrivals {
  stranger = $state.raw<Stranger | null>(null);

  /** Files from this computer. Of several the library has them all, and none is shown. */
  async take(files: Iterable<File>): Promise<void> {
    const kept = await documents.upload(files);
    if (kept.length === 1) await this.open(kept[0]);
  }

  /** A program of the library. */
  async open(name: string): Promise<void> {
    this.stranger = null;
    const look = await this.look(name);
    const here = panel.machines.find((machine) => machine.name === panel.machine);
    if (!look || is_at_home(here, look.kind)) return this.show(name);
    const machine = machine_for(panel.machines, look.kind, look.usual)?.name ?? '';
    this.stranger = { name, look, machine };
    // Where no machine makes it, this one shows at least what it would do.
    await (machine || look.usual ? documents.read(name) : this.show(name));
  }

  /** On this machine all the same. */
  async stay(): Promise<void> {
    const { name } = this.stranger ?? {};
    this.stranger = null;
    if (name) await this.show(name);
  }

  /** On the machine that makes such programs, which is made where there is none. */
  async go(): Promise<void> {
    const stranger = this.stranger;
    if (!stranger) return;
    const machine = stranger.machine || (await this.make(stranger.look.usual));
    if (!machine) return;
    this.stranger = null;
    slider.now();
    documents.close_all();
    await panel.watch(machine);
    await documents.open_and_load(stranger.name);
  }

  private async make(definition: string): Promise<string> {
    let name = definition;
    for (let n = 2; panel.machines.some((machine) => machine.name === name); n++)
      name = `${definition}-${n}`;
    if (!(await panel.act('create', { name, definition }))) return '';
    await panel.refresh_machines();
    return name;
  }

  private async show(name: string): Promise<void> {
    const { status } = panel.state;
    const may_load = panel.operates && ['idle', 'end', 'alarm'].includes(status);
    if (may_load) return documents.open_and_load(name);
    // Who opens another program than the one that executes wants to see it.
    preferences.follow = false;
    await documents.read(name);
    notices.say(t(panel.operates ? 'arrival.at-work' : 'arrival.watching', { name }));
  }

  /** Null: the server did not say. */
  private async look(name: string): Promise<ProgramLook | null> {
    const answer = await panel.ask('recognise', { name }).catch(() => null);
    return answer as unknown as ProgramLook | null;
  }
}

export const arrivals = new Arrivals();
