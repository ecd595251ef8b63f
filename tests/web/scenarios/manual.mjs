// By hand: MDI, jog, reference point, offsets, teaching, settings.
import assert from 'node:assert/strict';

export const manual = [
  {
    name: 'blocks are executed in MDI',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.press('MDI');
      const entry = panel.page.getByRole('textbox', {
        name: 'Blocks to execute',
      });
      await entry.fill('G90 G53 G01 X-3.5 F2000');
      await entry.press('Enter');
      await panel.page.getByRole('radio', { name: 'Machine' }).click();
      await panel.position_is('X', -3.5);
      assert.equal(await panel.page.locator('.notices p').count(), 0, 'an entry is no file');
      await panel.press('AUTO');
    },
  },
  {
    name: 'an axis jogs while its key is held, and by a step',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.press('JOG');
      const before = await panel.position('X');
      const key = panel.page.getByRole('button', { name: 'Jog X+' });
      await key.hover();
      await panel.page.mouse.down();
      await panel.passes('X', before + 0.5);
      await panel.page.mouse.up();
      await panel.has_status('IDLE', 'END', 'STOPPED');
      const held = await panel.position('X');
      await panel.page.getByLabel('Step, mm').selectOption({ label: '1' });
      await panel.page.getByRole('button', { name: 'Jog X−' }).click();
      await panel.position_is('X', held - 1);
      await panel.page.getByLabel('Step, mm').selectOption({ label: 'continuous' });
      await panel.press('REF');
      await panel.page.getByRole('button', { name: 'Reference', exact: true }).click();
      await panel.page.getByRole('radio', { name: 'Machine' }).click();
      await panel.position_is('X', 0);
      await panel.press('AUTO');
    },
  },
  {
    name: 'two points are taught and driven',
    async run({ open }) {
      const panel = await open({ machine: 'five-axis' });
      await panel.fresh();
      await panel.press('TEACH');
      await panel.tab('Teach');
      const before = await panel.position('Y');
      await panel.teach_two_points('Y');
      await panel.load_taught();
      await panel.press('Cycle start');
      await panel.has_status('END');
      await panel.position_is('Y', before + 10);
    },
  },
  {
    name: 'a work offset is changed and taken back',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.tab('Offsets');
      const cell = panel.page.getByRole('textbox', {
        name: 'G59 X',
        exact: true,
      });
      await cell.fill('8.25');
      await cell.press('Enter');
      await panel.until(
        () => document.querySelector('input[aria-label="G59 X"]')?.value === '8.250',
      );
      await panel.page.locator('h1').click();
      await panel.page.keyboard.press('Control+z');
      await panel.until(
        () => document.querySelector('input[aria-label="G59 X"]')?.value === '0.000',
      );
    },
  },
  {
    name: 'a tool gets its length',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.tab('Tools');
      const name = 'T7 Length';
      const cell = panel.page.getByRole('textbox', { name, exact: true });
      await panel.page.getByRole('textbox', { name: 'Tool', exact: true }).fill('7');
      await panel.page.getByRole('button', { name: 'Add tool' }).click();
      await cell.fill('101.5');
      await cell.press('Enter');
      await panel.page
        .locator('dialog.question')
        .getByRole('button', { name: 'Set 101.500' })
        .click();
      await panel.until(
        (label) => document.querySelector(`input[aria-label="${label}"]`)?.value === '101.500',
        name,
      );
    },
  },
  {
    name: 'the machine file is read, and a wrong one refused in words',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.page.getByRole('button', { name: 'Settings of the machine' }).click();
      const file = panel.page.getByRole('textbox', {
        name: 'Settings of the machine',
      });
      await panel.until(() =>
        document.querySelector('dialog textarea')?.value.includes('[[axis]]'),
      );
      const text = await file.inputValue();
      await file.fill(text.replace('velocity = 24000', 'velocity = -1'));
      await panel.page.getByRole('button', { name: 'Take it' }).click();
      await panel.page.locator('dialog .refused').waitFor();
      await panel.page.keyboard.press('Escape');
    },
  },
];
