// The training mode: begin an exercise, check it, mend it, be right.
import assert from 'node:assert/strict';

const REST = `G03 X60. Y8. R8.
G01 Y32.
G03 X52. Y40. R8.
G01 X8.
G03 X0. Y32. R8.
G01 Y8.
G03 X8. Y0. R8.
`;

const result = (panel) => panel.page.locator('#dock-training [aria-live]');
export const training = [
  {
    name: 'an exercise is begun, checked, mended and done',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.begin_exercise('A plate with rounded corners');
      await panel.page.locator('.file.current', { hasText: 'rounded-plate.nc' }).waitFor();
      await panel.says('G54 Z is set');
      await panel.training_button('Check').click();
      await result(panel).getByText('are not cut').waitFor();
      const first = Number(await result(panel).locator('.score b').innerText());
      assert.ok(first < 60, `${first} points for the start`);

      // What is missing, written into the line of the comment.
      await panel.go_to_line(10);
      await panel.page.keyboard.press('Home');
      await panel.page.keyboard.press('Shift+End');
      await panel.page.keyboard.insertText(REST.trimEnd());
      await result(panel).getByText('The text has changed since.').waitFor();
      await panel.training_button('Check').click();
      await result(panel).locator('.score b', { hasText: /^100$/ }).waitFor();
      assert.equal(await result(panel).locator('.criterion:not(.met)').count(), 0);
      const best = panel.page.locator('#dock-training .best', { hasText: '100' }).first();
      await best.waitFor();

      await panel.page.reload();
      await panel.is_connected();
      await panel.tab('Training');
      await best.waitFor();
    },
  },
  {
    name: 'a finding leads to its line, with the keyboard',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.begin_exercise('Find the mistakes');
      await panel.training_button('Check').focus();
      await panel.page.keyboard.press('Enter');
      await result(panel).getByText('The alarm PS0020 ends the program').waitFor();
      await result(panel).getByRole('button', { name: 'line 10' }).focus();
      await panel.page.keyboard.press('Enter');
      await panel.page.locator('.cm-activeLine', { hasText: 'G03 Y20. R6.' }).waitFor();
      const found = result(panel).getByText('A rapid goes into the work');
      assert.equal(await found.count(), 1);
    },
  },
  {
    name: 'an exercise for another kind of machine goes to one',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.begin_exercise('Squares in squares');
      await panel.page.locator('header .chosen b', { hasText: /^laser$/ }).waitFor();
      await panel.page.locator('.file.current', { hasText: 'nested-squares.bas' }).waitFor();
      await panel.training_button('Check').click();
      await result(panel).locator('.score').waitFor();
    },
  },
];
