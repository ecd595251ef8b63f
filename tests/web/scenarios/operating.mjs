// Opening, running, holding, looking back, two at one machine, languages.
import assert from 'node:assert/strict';
import { LONG, WAITS } from '../programs.mjs';

export const SAMPLES = [
  ['mill', 'O0001'],
  ['laser', 'speed'],
  ['laser-xtz', 'lens'],
  ['five-axis', 'TEACH'],
  ['arm', 'FLOWER'],
];

export const operating = [
  {
    name: 'the first start opens a sample on each kind of machine',
    async run({ open }) {
      for (const [machine, word] of SAMPLES) {
        const panel = await open({ machine });
        await panel.has_program();
        await panel.has_path(10);
        await panel.page.locator('.cm-content', { hasText: word }).waitFor();
        await panel.close();
      }
    },
  },
  {
    name: 'a program runs, holds on its way and goes on',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('long.nc', LONG);
      await panel.press('Cycle start');
      await panel.has_status('RUNNING');
      await panel.passes('X', 0);
      await panel.press('Feed hold');
      await panel.has_status('HOLD');
      const held_at = await panel.position('X');
      assert.ok(held_at > 0 && held_at < 150, `held at X ${held_at}`);
      await panel.page.waitForTimeout(700);
      assert.equal(await panel.position('X'), held_at, 'the axis stands');
      await panel.press('Cycle start');
      await panel.has_status('RUNNING');
      await panel.passes('X', held_at);
      await panel.press('Reset');
      await panel.has_status('IDLE');
    },
  },
  {
    name: 'a program waits for an input, is interrupted, and goes on when the input is given',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('waits.nc', WAITS);
      await panel.press('Cycle start');
      await panel.executes_line(6);
      await panel.page.keyboard.press('Alt+i');
      await panel.position_is('Y', 3);
      const input = panel.page.getByRole('button', { name: 'Input #1003' });
      await input.click();
      await panel.has_status('END');
      await panel.position_is('X', 2);
      assert.equal(await input.getAttribute('aria-pressed'), 'true');
      await input.click();
    },
  },
  {
    name: 'overrides and switches take what is set',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      const feed = panel.page.getByRole('slider', { name: 'Feed override' });
      await feed.focus();
      await panel.page.keyboard.press('ArrowRight');
      await panel.until(
        () => document.querySelector('input[aria-label="Feed override"]')?.value === '110',
      );
      await panel.page.getByTitle('Feed override: back to 100 %').click();
      await panel.until(
        () => document.querySelector('input[aria-label="Feed override"]')?.value === '100',
      );
      for (const name of [
        'Single block',
        'Optional stop',
        'Dry run',
        'Machine lock',
        'Block skip',
      ]) {
        await panel.press(name);
        await panel.page.locator('.key.on', { hasText: name }).waitFor();
        await panel.press(name);
        await panel.page.locator('.key.on', { hasText: name }).waitFor({ state: 'detached' });
      }
    },
  },
  {
    name: 'the time slider goes to an instant and back to now',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('long.nc', LONG);
      await panel.has_path(4);
      const now = await panel.position('X');
      // In the middle of the first cut X is about half way.
      await panel.go_to_instant(15);
      await panel.position_is('X', 75, 3);
      await panel.executes_line(4);
      await panel.page.locator('.slider').getByRole('button', { name: 'Now', exact: true }).click();
      await panel.page.locator('.instant').waitFor({ state: 'detached' });
      await panel.position_is('X', now);
    },
  },
  {
    name: 'what the operator starts brings the displays back to now',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('long.nc', LONG);
      await panel.has_path(4);
      const instant = panel.page.locator('.instant');
      const now = panel.page.locator('.slider').getByRole('button', { name: 'Now', exact: true });
      const button = (name) => panel.page.getByRole('button', { name, exact: true });
      const entry = panel.page.getByRole('textbox', { name: 'Blocks to execute' });
      for (const [mode, start] of [
        ['AUTO', () => panel.press('Over')],
        ['AUTO', () => panel.press('Cycle start')],
        ['JOG', () => button('Jog X+').click()],
        ['REF', () => button('Reference').click()],
        ['MDI', () => entry.fill('G91 G00 X1.').then(() => entry.press('Enter'))],
      ]) {
        await panel.press(mode);
        await panel.go_to_instant(2);
        await start();
        await instant.waitFor({ state: 'detached' });
        assert.equal(await now.getAttribute('aria-pressed'), 'true');
        await panel.press('Reset');
        await panel.has_status('IDLE');
      }
    },
  },
  {
    name: 'a tab that was chosen stays while entered blocks run, and turning the switch opens the entry',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.tab('Offsets');
      await panel.press('MDI');
      const entry = panel.page.getByRole('textbox', { name: 'Blocks to execute' });
      await entry.fill('G91 G01 X60. F600');
      await entry.press('Enter');
      await panel.has_status('RUNNING');
      await panel.tab('Offsets');
      const start = await panel.position('X');
      await panel.passes('X', start + 1); // the machine has told where it is many times by then
      await panel.page.locator('#dock-offsets').waitFor();
      assert.equal(await entry.count(), 0);
      await panel.press('Reset');
      await panel.press('AUTO');
      await panel.press('MDI');
      await entry.waitFor();
      await panel.press('AUTO');
    },
  },
  {
    name: 'while it runs another program can be looked at, and the one that runs can be closed',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('beside.nc', '%\nO0300 (BESIDE)\nM30\n%\n');
      await panel.run_text('long.nc', LONG);
      await panel.has_path(4);
      await panel.press('Cycle start');
      await panel.has_status('RUNNING');
      await panel.executes_line(4);
      const tab = (name) => panel.page.locator('li.file', { hasText: name });
      const moves_on = async () => panel.passes('X', (await panel.position('X')) + 1);
      await tab('beside.nc').getByRole('button').first().click();
      await moves_on(); // the machine has told where it is many times by then
      await panel.page.locator('li.file.current', { hasText: 'beside.nc' }).waitFor();
      await tab('long.nc').getByRole('button', { name: 'Close: long.nc' }).click();
      await moves_on();
      assert.equal(await tab('long.nc').count(), 0);
      assert.equal(await panel.page.locator('li.file.current').innerText(), 'beside.nc');
      await panel.press('Reset');
    },
  },
  {
    name: 'the call stack of an instant is that of the block that moved the axes then',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text(
        'calls.nc',
        '%\nO0400\nG90 G54 G94 F600\nG00 X0.\nM98 P0401\nM30\nO0401\nG01 X50.\nM99\n%\n',
      );
      await panel.has_path(1);
      await panel.tab('Stepping');
      const rows = panel.page.locator('#dock-stepping li .row');
      assert.equal(await rows.count(), 0);
      await panel.go_to_instant(4);
      await rows.first().getByText('O0401').waitFor();
      assert.equal(await rows.count(), 2);
    },
  },
  {
    name: 'two pages share a machine: one operates, control is handed over',
    async run({ open }) {
      const first = await open();
      await first.operates();
      const second = await open();
      await second.page.locator('header .badge', { hasText: 'operates' }).waitFor();
      assert.ok(await second.key('Cycle start').isDisabled(), 'who watches has no cycle start');
      await first.page.locator('header .badge').click();
      await first.page.getByRole('button', { name: /^Hand over to/ }).click();
      await second.operates();
      await second.press('JOG');
      await first.page.locator('.key.on', { hasText: 'JOG' }).waitFor();
      await second.press('AUTO');
      await second.close();
      await first.page.locator('header .badge', { hasText: 'No operator' }).waitFor();
    },
  },
  {
    name: 'the language is the browser’s and can be changed',
    async run({ open }) {
      const panel = await open({ locale: 'zh-TW' });
      await panel.page.getByRole('button', { name: '循環啟動', exact: true }).waitFor();
      assert.equal(await panel.page.getAttribute('html', 'lang'), 'zh-Hant');
      await panel.page.getByRole('combobox', { name: '語言' }).selectOption('en');
      await panel.key('Cycle start').waitFor();
      await panel.page.reload();
      await panel.key('Cycle start').waitFor();
    },
  },
  {
    name: 'light follows the room and can be changed',
    async run({ open }) {
      const panel = await open({ scheme: 'light' });
      assert.equal(await panel.page.getAttribute('html', 'data-scheme'), 'light');
      await panel.page.getByRole('button', { name: 'Dark', exact: true }).click();
      assert.equal(await panel.page.getAttribute('html', 'data-scheme'), 'dark');
    },
  },
];
