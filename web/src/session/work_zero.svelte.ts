/** Of a lathe: where the zero of its work lies in the picture, and places as its position in the work would show them. */
import { counted, letter_of, way_of } from '../logic/diameters';
import { fixed } from '../logic/format';
import type { AxisDefinition } from '../logic/protocol';
import { panel } from './panel.svelte';

const GRAIN = 1e4;

const axis_named = (name: string): AxisDefinition | undefined =>
  panel.definition?.axes.find((axis) => axis.name === name);

class Zero {
  /** Null: this is no lathe. Both places are of one state of the machine. */
  readonly place = $derived.by(() => {
    const { definition, state } = panel;
    if (!definition?.lathe) return null;
    const [x, , z] = panel.tip_at(state.joints);
    const from = (way: number, name: string): number =>
      Math.round((way - way_of(axis_named(name), state.position.work[name] ?? 0)) * GRAIN) / GRAIN;
    return { x: from(x, 'X'), z: from(z, 'Z') };
  });

  /** A place of the path in words; on other machines the plain numbers. */
  words_of(at: number[]): string {
    const { place } = this;
    if (!place) return at.map((value) => fixed(value, 2)).join('  ');
    const ways = { X: at[0] - place.x, Y: at[1], Z: at[2] - place.z };
    return Object.entries(ways)
      .map(([name, way]) => ({ way, axis: axis_named(name) }))
      .flatMap(({ axis, way }) =>
        axis ? [`${letter_of(axis)} ${fixed(counted(axis, way), 2)}`] : [],
      )
      .join('  ');
  }
}

export const work_zero = new Zero();
