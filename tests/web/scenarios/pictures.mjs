// Pictures of the panel for the documents: each kind of machine at work, and what else a panel shows, on a desk and on a tablet.
import { join } from 'node:path';
import { WRONG } from '../programs.mjs';

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

const at_work = STATES.flatMap(([machine, sample, seconds, tab, scheme, instant_s]) =>
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

/** What else is to be seen: each brings the mill into a state. */
const MOMENTS = {
  async held(panel) {
    await panel.open_program('flanges.nc');
    await panel.press('Cycle start');
    await panel.page.waitForTimeout(4000);
    await panel.press('Feed hold');
    await panel.has_status('HOLD');
  },
  async step(panel) {
    await panel.open_program('flanges.nc');
    for (let i = 0; i < 12; i++) {
      await panel.press('Into');
      await panel.has_status('STEP');
    }
    await panel.tab('Stepping');
  },
  async alarm(panel) {
    await panel.run_text('wrong.nc', WRONG);
    await panel.press('Cycle start');
    await panel.has_status('ALARM');
  },
  async jog(panel) {
    await panel.press('JOG');
    await panel.tab('Offsets');
  },
  async training(panel) {
    await panel.tab('Training');
    const begin = panel.page.getByRole('button', { name: 'Begin', exact: true });
    const check = panel.page.getByRole('button', { name: 'Check', exact: true });
    await begin.or(check).first().waitFor();
    if (await begin.count()) await begin.click();
    await check.click();
    await panel.page.locator('.dock', { hasText: 'of 100 points' }).waitFor();
  },
};

const moments = Object.entries(MOMENTS).flatMap(([moment, bring]) =>
  SIZES.map(([width, height]) => ({
    name: `picture of ${moment} at ${width}×${height}`,
    needs_shots: true,
    async run({ open, shots }) {
      const panel = await open({ width, height });
      await panel.fresh();
      await bring(panel);
      await panel.page.waitForTimeout(1000);
      await panel.page.mouse.move(0, 0);
      await panel.page.screenshot({ path: join(shots, `panel-${moment}-${width}x${height}.png`) });
      await panel.press('Reset');
      await panel.press('AUTO');
    },
  })),
);

export const pictures = [...at_work, ...moments];
