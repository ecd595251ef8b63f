// The program's text: errors while typing, line and path, the library.
import assert from 'node:assert/strict';
import { writeFileSync, mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { GROOVE, LONG } from '../programs.mjs';

/** More than a mebibyte, which is as long as a message may be; nearly all of it comments, so that its path is there at once. */
const LARGE = `%
O0900
G90 G54 G01 X10. F6000.
${`(${'LONG COMMENT '.repeat(9)})\n`.repeat(10_000)}X0.
M30
%
`;

export const editing = [
  {
    name: 'words have their colours, and a key puts the comment mark of the language in front',
    async run({ open }) {
      const panel = await open({ machine: 'laser' });
      await panel.fresh();
      await panel.run_text('wait.bas', 'here: wait(1)\nprint "x"\ngoto here\n');
      const { page } = panel;
      const token = (kind, text) =>
        page.locator(`.cm-line .cm-token-${kind}`, { hasText: text }).first().waitFor();
      await token('label', 'here');
      await token('command', 'wait');
      await token('text', '"x"');
      await token('target', 'here');
      await panel.go_to_line(1);
      await page.keyboard.press('Control+/');
      await token('comment', "' here: wait(1)");
      await page.keyboard.press('Control+/');
      await token('command', 'wait');
    },
  },
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
    name: 'an error at the end of a line underlines its last word',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('end.nc', '%\nO0901\n(程式) G01 X[1+\nM30\n%\n');
      await panel.page.locator('.cm-lintRange-error', { hasText: /^X\[1\+$/ }).waitFor();
    },
  },
  {
    name: 'what only running finds is underlined until the text is edited',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('unknown.nc', '%\nO0902\nG54\nG999\nM30\n%\n');
      const mark = panel.page.locator('.cm-lintRange-error', { hasText: 'G999' });
      await mark.waitFor();
      await panel.page.locator('.program footer .bad', { hasText: 'Errors: 1' }).waitFor();
      await mark.hover();
      await panel.page.locator('.cm-alarm-card', { hasText: 'PS0010' }).waitFor();
      await panel.go_to_line(3);
      await panel.page.keyboard.type('(A)');
      await panel.page.locator('.program footer .good').waitFor();
      await mark.waitFor({ state: 'detached' });
      await panel.page.keyboard.press('Control+z');
      await mark.waitFor();
    },
  },
  {
    name: 'a program longer than a message is edited, saved and loaded',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('large.nc', LARGE);
      await panel.has_path(1);
      let lost_lines = 0;
      panel.page.on('websocket', () => lost_lines++);
      const footer = panel.page.locator('.program footer');
      await footer.filter({ hasText: 'Not checked' }).waitFor();
      assert.equal(await footer.locator('.good').count(), 0);

      await type_at_end_of_line(panel, 2, ' (SAVED)');
      await panel.page.keyboard.press('Control+s');
      await panel.says('large.nc is saved.');
      await panel.page.locator('.ahead').waitFor({ state: 'detached' }); // loaded as well
      const saved = LARGE.replace('O0900', 'O0900 (SAVED)');
      assert.equal((await panel.library_bytes('large.nc')).toString(), saved);

      await type_at_end_of_line(panel, 2, ' (LOADED)');
      await panel.page.locator('.ahead').waitFor();
      await panel.page.keyboard.press('F5');
      await panel.says('large.nc is too long for one message: it is saved, and loaded');
      await panel.page.locator('.ahead').waitFor({ state: 'detached' });
      const loaded = saved.replace('(SAVED)', '(SAVED) (LOADED)');
      assert.equal((await panel.library_bytes('large.nc')).toString(), loaded);
      await panel.says_nothing('The line to the server is down');
      assert.equal(lost_lines, 0, 'the line to the server stays');
    },
  },
  {
    name: 'a program in Big5 is read as such, uploaded as it is and saved as it was',
    async run({ open }) {
      const file = join(mkdtempSync(join(tmpdir(), 'kerf-upload-')), 'big5.nc');
      const bytes = Buffer.from('250a4f303930330a28a4a4a4e5290a4d33300a250a', 'hex');
      writeFileSync(file, bytes);
      const panel = await open();
      await panel.fresh();
      await panel.open_library();
      await panel.page.locator('input[type="file"]').setInputFiles(file);
      await panel.says('big5.nc is in the library.');
      assert.deepEqual(await panel.library_bytes('big5.nc'), bytes);
      await panel.page.keyboard.press('Escape');
      await panel.open_program('big5.nc');
      await panel.says('big5.nc is not UTF-8: it is read as Big5, and saved so.');
      await panel.page.locator('.cm-content', { hasText: '(中文)' }).waitFor();
      await panel.page.reload();
      await panel.is_connected();
      await panel.page.locator('.cm-content', { hasText: '(中文)' }).waitFor();
      await type_at_end_of_line(panel, 2, ' (B)');
      await panel.page.keyboard.press('Control+s');
      await panel.says('big5.nc is saved.');
      const saved = bytes.toString('latin1').replace('O0903', 'O0903 (B)');
      assert.equal((await panel.library_bytes('big5.nc')).toString('latin1'), saved);
    },
  },
  {
    name: 'a program with lone CRs has the lines of the control and keeps them',
    async run({ open }) {
      const text = '\ufeff%\rO0904\rG90 G54 G00 X0.\rG01 X5. F600.\rM30\r%\r';
      const panel = await open();
      await panel.fresh();
      await panel.run_text('returns.nc', text);
      assert.equal(await panel.page.locator('.cm-line').count(), 7);
      await type_at_end_of_line(panel, 2, ' (A)');
      await panel.page.keyboard.press('Control+s');
      await panel.says('returns.nc is saved.');
      const saved = (await panel.library_bytes('returns.nc')).toString();
      assert.equal(saved, text.replace('O0904', 'O0904 (A)'));
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
    name: 'the path is picked over a part that is cut, too',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('groove.nc', GROOVE);
      await panel.has_path(4);
      await panel.has_part();
      await panel.shows('Path over the part', true);
      await panel.go_to_line(7);
      const { x, y } = await spot_on_path(panel);
      const told = await panel.page.locator('.hover b').innerText();
      await panel.page.mouse.click(x, y);
      await panel.page
        .locator('.program footer', { hasText: `line ${told.split(':')[1]}` })
        .waitFor();
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
      await panel.open_library();
      await dialog.getByRole('button', { name: 'Delete: final.nc' }).click();
      await panel.page
        .locator('dialog.question')
        .getByRole('button', { name: 'Delete', exact: true })
        .click();
      await panel.says('final.nc is deleted.');
      await panel.page.keyboard.press('Escape');
      await panel.page.getByRole('dialog').waitFor({ state: 'detached' });
      await panel.run_text('long.nc', LONG); // whoever opens the page next is not told of a program that is gone
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

async function type_at_end_of_line(panel, line, text) {
  await panel.go_to_line(line);
  await panel.page.keyboard.press('End');
  await panel.page.keyboard.type(text);
  await panel.page.locator('.file.current .dirty').waitFor();
}

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
