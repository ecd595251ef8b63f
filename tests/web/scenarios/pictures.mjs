// Pictures for the documents that are no states of a machine: training.
import { join } from 'node:path';

const SIZES = [
  [1440, 900],
  [820, 1180],
];

export const pictures = SIZES.map(([width, height]) => ({
  name: `picture of training at ${width}×${height}`,
  needs_shots: true,
  async run({ open, shots }) {
    const panel = await open({ width, height });
    await panel.fresh();
    await panel.begin_exercise('A plate with rounded corners');
    await panel.training_button('Check').click();
    await panel.page.locator('.dock', { hasText: 'of 100 points' }).waitFor();
    await panel.page.waitForTimeout(700);
    await panel.page.mouse.move(0, 0);
    await panel.page.screenshot({ path: join(shots, `training-${width}x${height}.png`) });
  },
}));
