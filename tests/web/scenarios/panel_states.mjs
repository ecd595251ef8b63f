// What a panel has to tell: how to begin, what is wrong, no link, a request, a draft, a question; looked at on each screen.
import { join } from 'node:path';
import { LONG, WRONG } from '../programs.mjs';

const SIZES = [
  [390, 844],
  [820, 1180],
  [1440, 900],
  [1920, 1080],
];

// The panel at one size of the screen, and its pictures.
class Shown {
  constructor(panel, shots, [width, height]) {
    Object.assign(this, { panel, page: panel.page, shots, width, height, is_phone: width <= 640 });
  }

  async pane(name) {
    if (this.is_phone)
      await this.page.locator('.panes').getByRole('button', { name, exact: true }).click();
  }

  async take(name) {
    await this.page.waitForTimeout(500);
    await this.page.screenshot({
      path: join(this.shots, `${name}-${this.width}x${this.height}.png`),
    });
  }

  escape() {
    return this.page.keyboard.press('Escape');
  }
}

async function has_a_sample(open) {
  const sample = await open();
  await sample.fresh();
  await sample.open_program('flanges.nc');
  await sample.has_path(10);
  await sample.close();
}

async function start(open, window, shots) {
  const greeted = await open({ ...window, newcomer: true });
  await greeted.page.locator('.guide').waitFor();
  await greeted.has_path(1);
  await greeted.page.waitForTimeout(700);
  await greeted.page.screenshot({
    path: join(shots, `start-${window.width}x${window.height}.png`),
  });
  await greeted.close();
}

async function no_link(shown, server) {
  const { panel, page } = shown;
  await shown.pane('Program');
  await panel.run_text('shown.nc', LONG);
  await panel.press('Cycle start');
  await panel.has_status('RUNNING');
  server.freeze();
  try {
    await page.locator('.line[role="alert"]', { hasText: 'Last known' }).waitFor();
    await shown.pane('Position');
    await shown.take('no-link');
  } finally {
    server.thaw();
  }
  await panel.has_status('RUNNING');
  await panel.press('Reset');
  await panel.has_status('IDLE');
}

async function request(shown, open) {
  const second = await open();
  await second.page.locator('header .badge').click();
  await second.page.getByLabel('Your name').fill('Lee');
  await second.page.getByRole('button', { name: /^Ask / }).click();
  await shown.page.locator('.request').waitFor();
  await shown.take('request');
  await shown.page.locator('.request').getByRole('button', { name: 'Keep it' }).click();
  await second.close();
}

async function problems(shown) {
  const { panel, page } = shown;
  await shown.pane('Program');
  await panel.run_text('shown-wrong.nc', WRONG);
  await shown.pane('More');
  await panel.tab('Problems');
  await page.locator('#dock-problems tbody tr').first().waitFor();
  await shown.take('problems');
  await shown.pane('Position');
  await page.getByText('stops at line 5 with PS0112').waitFor();
  await shown.take('stops');
  await shown.pane('More');
  await page.getByRole('button', { name: 'Manual: PS0112' }).first().click();
  await page.getByRole('dialog', { name: 'Manual' }).waitFor();
  await shown.take('manual');
  await shown.escape();
}

async function questions(shown) {
  const { panel, page } = shown;
  await shown.pane('Program');
  await panel.go_to_line(2);
  await page.keyboard.type('(E)');
  await page.locator('.file.current .dirty').waitFor();
  await panel.press('Cycle start');
  await page.getByRole('alertdialog').waitFor();
  await shown.take('which-text');
  await shown.escape();
  await page.getByRole('button', { name: 'Close: shown-wrong.nc' }).click();
  await page.locator('dialog.question').waitFor();
  await shown.take('question');
  await shown.escape();
}

async function draft(shown) {
  const { panel, page } = shown;
  page.once('dialog', (dialog) => dialog.accept());
  await page.reload();
  await panel.is_connected();
  await page.locator('.draft').waitFor({ state: 'attached' });
  await shown.pane('Program');
  await shown.take('draft');
}

async function alarm(shown) {
  const { panel } = shown;
  await shown.pane('More');
  await panel.tab('Messages');
  await panel.press('Cycle start');
  await panel.has_status('ALARM');
  await shown.take('alarm');
  await panel.press('Reset');
}

async function entry(shown) {
  const { panel, page } = shown;
  await panel.tab('Offsets');
  await page.getByRole('textbox', { name: 'G55 X', exact: true }).click();
  await page.keyboard.type('-4.5');
  await page.locator('.ways').waitFor();
  await shown.take('entry');
  await shown.escape();
}

async function operator(shown) {
  await shown.pane('Program');
  await shown.page.locator('.draft').getByRole('button', { name: 'Discard' }).click();
  await shown.page.locator('header .badge').click();
  await shown.take('operator');
}

export const panel_states = SIZES.map(([width, height]) => ({
  name: `honest states at ${width}×${height}`,
  needs_shots: true,
  needs_server: true,
  async run({ open, server, shots }) {
    const window = { width, height, touch: width <= 640 };
    await has_a_sample(open);
    await start(open, window, shots);
    const panel = await open(window);
    await panel.operates();
    await panel.press('Reset');
    await panel.has_status('IDLE');
    const shown = new Shown(panel, shots, [width, height]);
    await no_link(shown, server);
    await request(shown, open);
    await problems(shown);
    await questions(shown);
    await draft(shown);
    await alarm(shown);
    await entry(shown);
    await operator(shown);
  },
}));
