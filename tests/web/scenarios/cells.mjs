// A slip of the finger never becomes a value: cells of tables.
import assert from 'node:assert/strict';

export const cells = [
  {
    name: 'every cell of every table is edited twice, and what is typed replaces what was there',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
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
