/** What is done at a line of the program on the screen. The machine is told where that is in the text that it has. */
import { toggled } from '../logic/breakpoints';
import { condition } from './condition.svelte';
import { documents } from './documents.svelte';
import { begin_as_seen } from './operator';
import { panel } from './panel.svelte';

const at = (line: number, act: (machine_line: number) => unknown): void => {
  const machine_line = documents.for_machine(line);
  if (machine_line !== null) void act(machine_line);
};

export const places = {
  toggle_breakpoint: (line: number): void =>
    at(line, (there) =>
      panel.set_breakpoints(toggled(panel.breakpoints, documents.current, there)),
    ),
  edit_condition: (line: number): void =>
    at(line, (there) => condition.edit(documents.current, there)),
  run_to: (line: number): Promise<void> =>
    begin_as_seen('cycle-start', () =>
      at(line, (there) => panel.act('run-to', { file: documents.current, line: there })),
    ),
  start_at: (line: number): Promise<void> =>
    begin_as_seen('cycle-start', () => at(line, (there) => panel.act('start-at', { line: there }))),
};
