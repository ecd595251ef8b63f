// What a panel has to tell: how to begin, what is wrong, no link, a request, a draft, a question; looked at on each screen.
import { join } from 'node:path';
import { LONG, WRONG } from '../programs.mjs';

const SIZES = [
  [390, 844],
  [820, 1180],
  [1440, 900],
  [1920, 1080],
];

export const panel_states = SIZES.map(([width, height]) => ({
  name: `honest states at ${width}×${height}`,
  needs_shots: true,
  needs_server: true,
  async run({ open, server, shots }) {
    const is_phone = width <= 640;
    const window = { width, height, touch: is_phone };
    const sample = await open();
    await sample.fresh();
    await sample.open_program('flanges.nc');
    await sample.has_path(10);
    await sample.close();
    const greeted = await open({ ...window, newcomer: true });
    await greeted.page.locator('.guide').waitFor();
    await greeted.has_path(1);
    await greeted.page.waitForTimeout(700);
    await greeted.page.screenshot({ path: join(shots, `start-${width}x${height}.png`) });
    await greeted.close();
    const panel = await open(window);
    const pane = async (name) => {
      if (is_phone)
        await panel.page.locator('.panes').getByRole('button', { name, exact: true }).click();
    };
    const take = async (name) => {
      await panel.page.waitForTimeout(500);
      await panel.page.screenshot({ path: join(shots, `${name}-${width}x${height}.png`) });
    };
    await panel.operates();
    await panel.press('Reset');
    await panel.has_status('IDLE');

    await pane('Program');
    await panel.run_text('shown.nc', LONG);
    await panel.press('Cycle start');
    await panel.has_status('RUNNING');
    server.freeze();
    try {
      await panel.page.locator('.line[role="alert"]', { hasText: 'Last known' }).waitFor();
      await pane('Position');
      await take('no-link');
    } finally {
      server.thaw();
    }
    await panel.has_status('RUNNING');
    await panel.press('Reset');
    await panel.has_status('IDLE');

    const second = await open();
    await second.page.locator('header .badge').click();
    await second.page.getByLabel('Your name').fill('Lee');
    await second.page.getByRole('button', { name: /^Ask / }).click();
    await panel.page.locator('.request').waitFor();
    await take('request');
    await panel.page.locator('.request').getByRole('button', { name: 'Keep it' }).click();
    await second.close();

    await pane('Program');
    await panel.run_text('shown-wrong.nc', WRONG);
    await pane('More');
    await panel.tab('Problems');
    await panel.page.locator('#dock-problems tbody tr').first().waitFor();
    await take('problems');
    await pane('Position');
    await panel.page.getByText('stops at line 5 with PS0112').waitFor();
    await take('stops');
    await pane('More');
    await panel.page.getByRole('button', { name: 'Manual: PS0112' }).first().click();
    await panel.page.getByRole('dialog', { name: 'Manual' }).waitFor();
    await take('manual');
    await panel.page.keyboard.press('Escape');
    await pane('Program');
    await panel.go_to_line(2);
    await panel.page.keyboard.type('(E)');
    await panel.page.locator('.file.current .dirty').waitFor();
    await panel.press('Cycle start');
    await panel.page.getByRole('alertdialog').waitFor();
    await take('which-text');
    await panel.page.keyboard.press('Escape');
    await panel.page.getByRole('button', { name: 'Close: shown-wrong.nc' }).click();
    await panel.page.locator('dialog.question').waitFor();
    await take('question');
    await panel.page.keyboard.press('Escape');
    panel.page.once('dialog', (dialog) => dialog.accept());
    await panel.page.reload();
    await panel.is_connected();
    await panel.page.locator('.draft').waitFor({ state: 'attached' });
    await pane('Program');
    await take('draft');
    await pane('More');
    await panel.tab('Messages');
    await panel.press('Cycle start');
    await panel.has_status('ALARM');
    await take('alarm');
    await panel.press('Reset');
    await panel.tab('Offsets');
    const cell = panel.page.getByRole('textbox', { name: 'G55 X', exact: true });
    await cell.click();
    await panel.page.keyboard.type('-4.5');
    await panel.page.locator('.ways').waitFor();
    await take('entry');
    await panel.page.keyboard.press('Escape');
    await pane('Program');
    await panel.page.locator('.draft').getByRole('button', { name: 'Discard' }).click();
    await panel.page.locator('header .badge').click();
    await take('operator');
  },
}));
