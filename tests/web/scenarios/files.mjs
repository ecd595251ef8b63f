// Files of all kinds: encodings, names, what is no text, many of them open; what deleting and an alarm say.
import assert from 'node:assert/strict';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { LONG, WRONG } from '../programs.mjs';

const program = (comment) =>
  Buffer.concat([
    Buffer.from('%\nO0903\n('),
    Buffer.from(comment, 'hex'),
    Buffer.from(')\nM30\n%\n'),
  ]);

const ENCODINGS = [
  ['gbk.nc', 'GBK', '粗铣外形', 'b4d6cfb3cde2d0ce'],
  ['sjis.nc', 'Shift-JIS', '工具交換', '8d488bef8cf08ab7'],
  ['big5s.nc', 'Big5', '工件原點', 'a475a5f3adecc249'],
  ['latin.nc', 'Windows-1252', 'Schlüssel', Buffer.from('Schlüssel', 'latin1').toString('hex')],
];

async function choose_files(panel, ...files) {
  const folder = mkdtempSync(join(tmpdir(), 'kerf-upload-'));
  const paths = files.map(([name, bytes]) => {
    const path = join(folder, name);
    writeFileSync(path, bytes);
    return path;
  });
  if (!(await panel.page.getByRole('dialog').count())) await panel.open_library();
  await panel.page.locator('input[type="file"]').setInputFiles(paths);
}
const question = (panel, text) => panel.page.locator('dialog.question', { hasText: text });
const encoding = (panel) => panel.page.getByRole('combobox', { name: 'Encoding of the file' });

async function save_with(panel, text) {
  await panel.go_to_line(2);
  await panel.page.keyboard.press('End');
  await panel.page.keyboard.type(text);
  await panel.page.locator('.file.current .dirty').waitFor();
  await panel.page.keyboard.press('Control+s');
}

export const files = [
  {
    name: 'a program keeps the encoding in which it was written',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      for (const [name, words, comment, hex] of ENCODINGS) {
        await panel.upload(name, program(hex));
        await panel.open_program(name);
        await panel.says(`${name} is not UTF-8: it is read as ${words}`);
        await panel.page.locator('.cm-content', { hasText: comment }).waitFor();
        assert.equal(await encoding(panel).locator('option:checked').innerText(), words);
        await save_with(panel, ' (A)');
        await panel.says(`${name} is saved.`);
        const wanted = Buffer.from(
          program(hex).toString('latin1').replace('O0903', 'O0903 (A)'),
          'latin1',
        );
        assert.deepEqual(await panel.library_bytes(name), wanted, name);
        await panel.page.locator('.ahead').waitFor({ state: 'detached' });
      }
    },
  },
  {
    name: 'the encoding can be chosen, and a character that it does not have is told before saving',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      const [name, , comment, hex] = ENCODINGS[0];
      await panel.upload(name, program(hex));
      await panel.open_program(name);
      await encoding(panel).selectOption('windows-1252');
      await panel.page.locator('.cm-content', { hasText: '´ÖÏ³' }).waitFor();
      await encoding(panel).selectOption('gbk');
      await panel.page.locator('.cm-content', { hasText: comment }).waitFor();
      await save_with(panel, ' (é ä 中)');
      await panel.says('GBK has no character ä');
      await encoding(panel).selectOption('utf-8');
      await panel.says('will be saved in UTF-8');
      await panel.page.keyboard.press('Control+s');
      await panel.says(`${name} is saved.`);
      assert.match((await panel.library_bytes(name)).toString(), /\(é ä 中\)\n\(粗铣外形\)/);
    },
  },
  {
    name: 'UTF-16 is read, loaded and saved as a text that a control reads',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      const bytes = Buffer.concat([Buffer.from([0xff, 0xfe]), Buffer.from(LONG, 'utf16le')]);
      await panel.upload('wide.nc', bytes);
      await panel.open_program('wide.nc');
      await panel.says('wide.nc is UTF-16 LE, which no control reads');
      await panel.page.locator('.cm-content', { hasText: 'UP AND DOWN' }).waitFor();
      await panel.has_path(4);
      await panel.page.locator('.program footer .good').waitFor();
      await save_with(panel, '(8)');
      await panel.says('wide.nc is saved.');
      assert.match(
        (await panel.library_bytes('wide.nc')).toString(),
        /^%\nO0200 \(UP AND DOWN\)\(8\)\n/,
      );
    },
  },
  {
    name: 'what is no text is no program, whether it is uploaded or opened',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('before.nc', LONG);
      let state = 1;
      const noise = Buffer.alloc(200_000).map(() => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return state >>> 24;
      });
      await choose_files(panel, ['noise.bin', noise]);
      await panel.says('noise.bin is no text');
      assert.equal(
        await panel.page.getByRole('button', { name: 'noise.bin', exact: true }).count(),
        0,
      );
      await panel.page.keyboard.press('Escape');
      await panel.upload('noise.nc', noise);
      await panel.open_library();
      await panel.page
        .getByRole('dialog')
        .getByRole('button', { name: 'noise.nc', exact: true })
        .click();
      await panel.says('noise.nc is no text');
      await panel.page.locator('header .program', { hasText: 'before.nc' }).waitFor();
      assert.equal(await panel.page.locator('li.file', { hasText: 'noise.nc' }).count(), 0);
    },
  },
  {
    name: 'an upload over a program asks, and a name that the library refuses is mended',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.upload('twice.nc', LONG);
      await choose_files(panel, ['twice.nc', LONG]); // the same bytes: nothing to ask
      await panel.says('twice.nc is in the library.');
      await choose_files(panel, ['twice.nc', WRONG]);
      await question(panel, 'twice.nc is in the library already')
        .getByRole('button', { name: 'Leave it' })
        .click();
      assert.equal((await panel.library_bytes('twice.nc')).toString(), LONG);
      await choose_files(panel, ['twice.nc', WRONG]);
      await question(panel, 'twice.nc')
        .getByRole('button', { name: /^Save as twice-\d+\.nc$/ })
        .click();
      await panel.says('twice-2.nc is in the library.');
      assert.equal((await panel.library_bytes('twice.nc')).toString(), LONG);
      await choose_files(panel, ['twice.nc', WRONG]);
      await question(panel, 'twice.nc').getByRole('button', { name: 'Replace it' }).click();
      await panel.says('twice.nc is in the library.');
      assert.equal((await panel.library_bytes('twice.nc')).toString(), WRONG);

      await choose_files(panel, ['<bad>.nc', LONG]);
      await question(panel, 'does not take the name <bad>.nc')
        .getByRole('button', { name: 'Upload as bad-.nc' })
        .click();
      await panel.says('bad-.nc is in the library.');
      // Any ending, and none.
      await choose_files(panel, ['O1234', LONG], ['part.MIN', LONG], ['part.EIA', LONG]);
      for (const name of ['O1234', 'part.MIN', 'part.EIA'])
        await panel.says(`${name} is in the library.`);
      assert.equal(await panel.page.locator('input[type="file"]').getAttribute('accept'), null);
    },
  },
  {
    name: 'deleting says what stays, and which machine has the program',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('doomed.nc', LONG);
      await panel.open_library();
      const remove = panel.page.getByRole('button', { name: 'Delete: doomed.nc' });
      await remove.click();
      const asked = question(panel, 'Delete doomed.nc?');
      await asked.filter({ hasText: 'mill has doomed.nc loaded' }).waitFor();
      await asked.filter({ hasText: 'Its revisions stay' }).waitFor();
      await asked.getByRole('button', { name: 'Leave it' }).click();
      await panel.page.locator('dialog .name', { hasText: 'doomed.nc' }).waitFor();
      await remove.click();
      await asked.getByRole('button', { name: 'Delete' }).click();
      await panel.says('doomed.nc is deleted.');
      await panel.page.keyboard.press('Escape');
      await panel.upload('doomed.nc', WRONG);
      await panel.open_library();
      await panel.page.getByRole('button', { name: 'Revisions: doomed.nc' }).click();
      await panel.until(() => document.querySelectorAll('.revisions .button').length === 2);
    },
  },
  {
    name: 'the tab of the program on the screen is in sight, the others are in a list',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      for (let i = 1; i <= 8; i++) await panel.run_text(`a-rather-long-name-${i}.nc`, LONG);
      const in_sight = async (name) => {
        const tab = panel.page.locator('li.file.current', { hasText: name });
        await tab.waitFor();
        await panel.until((text) => {
          const strip = document.querySelector('.files').getBoundingClientRect();
          const current = document.querySelector('li.file.current');
          const at = current.getBoundingClientRect();
          return (
            current.textContent.includes(text) &&
            at.left >= strip.left &&
            at.right <= strip.right + 1
          );
        }, name);
      };
      await in_sight('a-rather-long-name-8.nc');
      const list = panel.page.locator('.tabs .opener');
      await list.click();
      await panel.page
        .locator('.all')
        .getByRole('button', { name: 'a-rather-long-name-2.nc' })
        .click();
      await in_sight('a-rather-long-name-2.nc');
      await panel.page.locator('li.file.current').click({ button: 'middle' });
      await panel.page
        .locator('li.file', { hasText: 'a-rather-long-name-2.nc' })
        .waitFor({ state: 'detached' });
      await panel.until(() => document.querySelectorAll('li.file').length === 7);
    },
  },
  {
    name: 'a run that ends with an alarm never looks like one that is done, before the start and after it',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('stops-early.nc', WRONG);
      const time = panel.page.locator('section', { has: panel.page.getByRole('progressbar') });
      const looks_stopped = async () => {
        await time.filter({ hasText: 'stops at line 5 with PS0112' }).waitFor();
        const left = time.locator('div', { hasText: /^Left/ }).locator('dd');
        assert.equal((await left.innerText()).trim(), '–');
        const bar = time.locator('.bar.stops');
        assert.match(await bar.evaluate((e) => getComputedStyle(e).backgroundImage), /gradient/);
      };
      await looks_stopped();
      await panel.press('Cycle start');
      await panel.has_status('ALARM');
      await looks_stopped();
      await panel.tab('Messages');
      const history = panel.page.locator('.alarms');
      await history
        .locator('li.stands', { hasText: 'PS0112' })
        .filter({ hasText: 'stops-early.nc:5' })
        .waitFor();
      assert.match(await history.innerText(), /\d\d:\d\d:\d\d/);
      await panel.press('Reset');
      await panel.has_status('IDLE');
      await history.locator('li', { hasText: 'PS0112' }).first().waitFor();
      assert.equal(await history.locator('li.stands').count(), 0);
      await panel.page.reload();
      await panel.is_connected();
      await panel.tab('Messages');
      await history.locator('li', { hasText: 'PS0112' }).first().waitFor();
    },
  },
];
