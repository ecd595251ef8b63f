// Pictures of the panel for the documents: each kind of machine, at work, on a desk and on a tablet.
import { join } from 'node:path';

const SIZES = [
  [1440, 900],
  [820, 1180],
];
/** Machine, its sample, seconds of work before the picture, tab, light, and the instant that the slider then shows. */
const STATES = [
  ['mill', 'flanges.nc', 9, 'Variables', 'dark'],
  ['laser', 'cardioid.bas', 3, 'Pulses', 'dark'],
  ['five-axis', 'tube.tch', 8, 'Speed', 'light'],
  ['arm', 'flower.nc', 14, 'Stepping', 'light', 400],
];

export const pictures = STATES.flatMap(([machine, sample, seconds, tab, scheme, instant_s]) =>
  SIZES.map(([width, height]) => ({
    name: `picture of ${machine} at ${width}×${height}`,
    needs_shots: true,
    async run({ open, shots }) {
      const panel = await open({ machine, width, height, scheme });
      await panel.fresh();
      await panel.open_program(sample);
      await panel.has_path(10);
      await panel.tab(tab);
      await panel.press('Cycle start');
      await panel.page.waitForTimeout(1000 * seconds);
      if (instant_s) await panel.go_to_instant(instant_s);
      await panel.page.mouse.move(0, 0);
      await panel.page.screenshot({
        path: join(shots, `panel-${machine}-${width}x${height}.png`),
      });
      await panel.press('Reset');
    },
  })),
);
