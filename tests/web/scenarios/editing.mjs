// The program's text: errors while typing, line and path, the library.
import assert from 'node:assert/strict';
import { writeFileSync, mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { LONG } from '../programs.mjs';

export const editing = [
  {
    name: 'an error is underlined while it is typed, and hovering tells the alarm',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('typed.nc', LONG);
      await panel.go_to_line(5);
      await panel.page.keyboard.press('End');
      await panel.page.keyboard.type('5.5');
      const mark = panel.page.locator('.cm-lintRange-error').first();
      await mark.waitFor();
      await panel.page.locator('.program footer .bad', { hasText: 'Errors: 1' }).waitFor();
      await mark.hover();
      await panel.page.locator('.cm-alarm-card', { hasText: 'PS0007' }).waitFor();
      await panel.page.keyboard.press('Control+z');
      await panel.page.locator('.program footer .good').waitFor();
    },
  },
  {
    name: 'the line of the cursor is one of the program that is shown',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('long.nc', LONG);
      await panel.go_to_line(5);
      const foot = panel.page.locator('.program footer');
      await foot.filter({ hasText: /line 5$/ }).waitFor();
      await panel.run_text('short.nc', '%\nM30\n%\n');
      await foot.filter({ hasText: /line 1$/ }).waitFor();
    },
  },
  {
    name: 'a line shows its path, and the path its line',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('long.nc', LONG);
      await panel.has_path(4);
      await panel.go_to_line(5);
      await panel.until(() => Number(document.querySelector('#picture')?.dataset.chosen) === 1);
      const { x, y } = await spot_on_path(panel);
      const told = await panel.page.locator('.hover b').innerText();
      await panel.page.mouse.click(x, y);
      const line = told.split(':')[1];
      await panel.page.locator('.program footer', { hasText: `line ${line}` }).waitFor();
      await panel.page.locator('.cm-chosen').waitFor();
    },
  },
  {
    name: 'an uploaded program is there after the page is loaded again',
    async run({ open }) {
      const file = join(mkdtempSync(join(tmpdir(), 'kerf-upload-')), 'uploaded.nc');
      writeFileSync(file, LONG);
      const panel = await open();
      await panel.fresh();
      await panel.open_library();
      await panel.page.locator('input[type="file"]').setInputFiles(file);
      await panel.says('uploaded.nc is in the library.');
      await panel.page
        .getByRole('dialog')
        .getByRole('button', { name: 'uploaded.nc', exact: true })
        .click();
      await panel.page.locator('header .program', { hasText: 'uploaded.nc' }).waitFor();
      await panel.page.reload();
      await panel.is_connected();
      await panel.page.locator('.file.current', { hasText: 'uploaded.nc' }).waitFor();
      await panel.page.locator('.cm-content', { hasText: 'UP AND DOWN' }).waitFor();
    },
  },
  {
    name: 'a program is written, saved, renamed, its revision read, and deleted',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('draft.nc', LONG);
      await panel.go_to_line(2);
      await panel.page.keyboard.press('End');
      await panel.page.keyboard.type(' (CHANGED)');
      await panel.page.locator('.file.current .dirty').waitFor();
      await panel.page.keyboard.press('Control+s');
      await panel.says('draft.nc is saved.');
      await panel.page.locator('.file.current .dirty').waitFor({ state: 'detached' });
      await panel.open_library();
      const dialog = panel.page.getByRole('dialog');
      await dialog.getByRole('button', { name: 'Rename: draft.nc' }).click();
      await dialog.getByRole('textbox', { name: 'Name of the program' }).last().fill('final.nc');
      await panel.page.keyboard.press('Enter');
      await dialog.getByRole('button', { name: 'final.nc', exact: true }).waitFor();
      await dialog.getByRole('button', { name: 'Revisions: final.nc' }).click();
      await dialog.locator('.revisions .button').last().click();
      await panel.page.locator('.file.current', { hasText: 'final.nc' }).waitFor();
      const text = panel.page.locator('.cm-content', { hasText: 'UP AND DOWN' });
      await text.filter({ hasNotText: 'CHANGED' }).waitFor();
      panel.page.once('dialog', (question) => question.accept());
      await panel.open_library();
      await dialog.getByRole('button', { name: 'Delete: final.nc' }).click();
      await panel.says('final.nc is deleted.');
    },
  },
  {
    name: 'the speed along the path leads to an instant by a click',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('long.nc', LONG);
      await panel.has_path(4);
      await panel.tab('Speed');
      const chart = panel.page.locator('.chart .u-over');
      await chart.waitFor();
      const { width, height } = await chart.boundingBox();
      await chart.click({ position: { x: width / 2, y: height / 2 } });
      await panel.page.locator('.instant').waitFor();
      await panel.page.keyboard.press('n');
      await panel.page.locator('.instant').waitFor({ state: 'detached' });
    },
  },
];

/** A place of the picture where the pointer is on the path: looked for from the middle outwards. */
async function spot_on_path(panel) {
  const box = await panel.page.locator('#picture').boundingBox();
  for (let row = 1; row < 20; row++) {
    for (let column = 1; column < 30; column++) {
      const x = box.x + (box.width * column) / 30;
      const y = box.y + (box.height * row) / 20;
      await panel.page.mouse.move(x, y);
      if (await panel.page.locator('.hover').count()) return { x, y };
    }
  }
  throw new Error('the pointer finds no path in the picture');
}
