// A slip of the finger never becomes a value: cells of tables.
import assert from 'node:assert/strict';

export const cells = [
  {
    name: 'every cell of every table is edited twice, and what is typed replaces what was there',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('nothing.nc', 'O1\nM30\n'); // no path and no part to be made anew with each offset
      await panel.tab('Offsets');
      await panel.page.getByRole('textbox', { name: 'G59 X' }).waitFor();
      // What stands there is anything; only what is typed counts here.
      await panel.page.getByLabel('Ask about a change of more than').fill('1000000');
      await twice_each(panel, '#dock-offsets');
      await panel.tab('Tools');
      await panel.page.getByRole('textbox', { name: 'Tool', exact: true }).fill('77');
      await panel.page.keyboard.press('Enter');
      await panel.page.getByRole('textbox', { name: 'T77 Length', exact: true }).waitFor();
      await twice_each(panel, '#dock-tools');
      await panel.tab('Variables');
      for (const name of ['#500', '#501', '#502']) await panel.add_variable(name);
      await panel.page.getByRole('textbox', { name: '#502', exact: true }).waitFor();
      await twice_each(panel, '#dock-variables');
    },
  },
  {
    name: 'a tool keeps its row when all of it is set to 0',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      const length = panel.page.getByRole('textbox', { name: 'T66 Length', exact: true });
      await panel.tab('Tools');
      await panel.page.getByRole('textbox', { name: 'Tool', exact: true }).fill('66');
      await panel.page.keyboard.press('Enter');
      await length.waitFor();
      await set_cell(panel, 'T66 Length', '2');
      await shows(panel, 'T66 Length', '2.000');
      await panel.page.reload(); // from now on only the machine tells of it
      await panel.operates();
      await panel.tab('Tools');
      await length.waitFor();
      await set_cell(panel, 'T66 Length', '0');
      await shows(panel, 'T66 Length', '0.000');
      await panel.tab('Offsets');
      await panel.tab('Tools');
      await shows(panel, 'T66 Length', '0.000');
      await panel.page.locator('h1').click();
      await panel.page.keyboard.press('Control+z');
      await shows(panel, 'T66 Length', '2.000');
      await set_cell(panel, 'T66 Length', '0');
      await shows(panel, 'T66 Length', '0.000');

      // Another machine has a table of its own.
      await panel.choose_machine('laser');
      await panel.until(() => !document.querySelector('input[aria-label="T66 Length"]'));
      await panel.choose_machine('mill');
    },
  },
  {
    name: 'the place of an axis becomes the zero of a system, with EXT and the length of the tool in force',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.tab('Tools');
      await panel.page.getByRole('textbox', { name: 'Tool', exact: true }).fill('88');
      await panel.page.keyboard.press('Enter');
      await set_cell(panel, 'T88 Length', '3');
      await shows(panel, 'T88 Length', '3.000');
      await panel.tab('Offsets');
      await set_cell(panel, 'EXT X', '2');
      await set_cell(panel, 'EXT Z', '4');
      await panel.page.getByRole('textbox', { name: 'G54.1 P', exact: true }).fill('3');
      await panel.page.keyboard.press('Enter');
      await set_cell(panel, 'G54.1 P3 X', '5');
      await shows(panel, 'G54.1 P3 X', '5.000');
      await executes(panel, 'G54.1 P3 G90 G43 H88 G01 X9. Z-9. F6000');
      await panel.tab('Offsets');
      await panel.page.locator('tr.current', { hasText: 'G54.1 P3' }).waitFor();
      for (const axis of ['X', 'Z']) {
        await panel.page.getByRole('button', { name: `${axis}0, G54.1 P3:` }).click();
        await panel.position_is(axis, 0);
      }
      // One that is not in force reads 0 there as soon as it is.
      await panel.page.getByRole('button', { name: 'X0, G59:' }).click();
      await executes(panel, 'G59');
      await panel.position_is('X', 0);
      await panel.tab('Offsets');
      for (const name of ['EXT X', 'EXT Z', 'G59 X', 'G54.1 P3 X', 'G54.1 P3 Z']) {
        await set_cell(panel, name, '0');
        await shows(panel, name, '0.000'); // the row stays
      }
    },
  },
  {
    name: 'an entry is set, added, goes to the next row, and is asked about where it is far off',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.tab('Offsets');
      const { keyboard } = panel.page;
      const cell = (name) => panel.page.getByRole('textbox', { name, exact: true });
      const answer = async (choice) => {
        await panel.page.locator('dialog.question').getByRole('button', { name: choice }).click();
        await panel.page.locator('dialog.question').waitFor({ state: 'detached' });
      };
      await set_cell(panel, 'G54 Y', '0');
      await cell('G54 Y').click();
      await keyboard.type('5');
      await keyboard.press('Enter');
      await shows(panel, 'G54 Y', '5.000');
      assert.equal(await focused(panel), 'G55 Y', 'Enter goes to the next row');
      await cell('G54 Y').click();
      await keyboard.type('-0.25');
      await keyboard.press('Shift+Enter');
      await shows(panel, 'G54 Y', '4.750');
      await cell('G54 Y').click();
      await keyboard.type('1');
      await panel.page.getByRole('button', { name: '+INPUT', exact: true }).click();
      await shows(panel, 'G54 Y', '5.750');

      await cell('G54 Y').click();
      await keyboard.type('125000');
      await keyboard.press('Enter');
      await panel.page.locator('dialog.question', { hasText: 'travels' }).waitFor();
      await answer('Leave it');
      await shows(panel, 'G54 Y', '5.750');
      await cell('G54 Y').click();
      await keyboard.type('25.75');
      await keyboard.press('Enter');
      await panel.page.locator('dialog.question', { hasText: 'a change of 20.000' }).waitFor();
      await answer('Set 25.750');
      await shows(panel, 'G54 Y', '25.750');

      await panel.page.getByLabel('Ask about a change of more than').fill('100');
      await cell('G54 Y').click();
      await keyboard.type('0');
      await keyboard.press('Enter');
      await shows(panel, 'G54 Y', '0.000');
      assert.equal(await panel.page.locator('dialog.question').count(), 0);
    },
  },
];

/** In MDI, to its end. */
async function executes(panel, blocks) {
  await panel.press('MDI');
  const entry = panel.page.getByRole('textbox', { name: 'Blocks to execute' });
  await entry.fill(blocks);
  await entry.press('Enter');
  // The status before is as good as the one after: the entry is emptied once the machine has taken the blocks.
  await panel.until(() => document.querySelector('#dock-mdi textarea')?.value === '');
  await panel.has_status('END', 'IDLE');
  await panel.press('AUTO');
}
async function set_cell(panel, name, value) {
  const cell = panel.page.getByRole('textbox', { name, exact: true });
  await cell.click();
  await panel.page.keyboard.type(value);
  await panel.page.keyboard.press('Enter');
  const question = panel.page.locator('dialog.question');
  if (await question.count()) await question.getByRole('button').last().click();
}
async function shows(panel, name, value) {
  const late = Date.now() + 20_000;
  let seen;
  do {
    seen = await panel.page
      .getByRole('textbox', { name, exact: true })
      .inputValue()
      .catch(() => '');
    if (seen.replace('\u2212', '-') === value) return;
    await panel.page.waitForTimeout(50);
  } while (Date.now() < late);
  assert.equal(seen, value, name);
}
const focused = (panel) =>
  panel.page.evaluate(() => document.activeElement?.getAttribute('aria-label') ?? '');

/** By the pointer both times, as an operator does it; small values, so that nothing is asked. */
async function twice_each(panel, where) {
  const names = await panel.page
    .locator(`${where} input.cell`)
    .evaluateAll((all) => all.map((cell) => cell.getAttribute('aria-label')));
  assert.ok(names.length >= 3, `${names.length} cells in ${where}`);
  const decimals = where === '#dock-variables' ? 0 : 3;
  for (const name of names) {
    const cell = panel.page.locator(where).getByRole('textbox', { name, exact: true });
    for (const value of ['2.5', '7']) {
      await cell.click();
      await panel.page.keyboard.type(value);
      await panel.page.keyboard.press('Enter');
      await shows(panel, name, decimals ? Number(value).toFixed(3) : value);
    }
    await cell.click();
    await panel.page.keyboard.type('0');
    await panel.page.keyboard.press('Enter');
    await shows(panel, name, decimals ? '0.000' : '0');
  }
}
