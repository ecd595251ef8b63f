/** Jogging: one axis at a time, for as long as a key is held, or by a step. Whatever ends the holding ends the jog. */
import type { MachineDefinition } from '../logic/protocol';
import { panel } from './panel.svelte';
import { preferences } from './preferences.svelte';

let axis_under_way = '';

export const jog = {
  /** Axes that the keys move: those of programs. */
  axes(definition: MachineDefinition): string[] {
    return definition.axes.filter((axis) => axis.program).map((axis) => axis.name);
  },

  begin(axis: string, way: 1 | -1): void {
    if (axis_under_way) return;
    const speed = preferences.jog_mm_min;
    if (preferences.jog_step > 0) {
      void panel.act('jog', { axis, speed_mm_min: way * speed, distance_mm: preferences.jog_step });
      return;
    }
    axis_under_way = axis;
    void panel.act('jog', { axis, speed_mm_min: way * speed });
  },

  end(): void {
    if (!axis_under_way) return;
    axis_under_way = '';
    void panel.act('jog-stop');
  },
};
