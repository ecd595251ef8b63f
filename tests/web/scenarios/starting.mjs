// How a program begins: with which text, what keeps it from beginning, and what it waits for.
import assert from 'node:assert/strict';
import { box } from '../boxes.mjs';
import { LONG } from '../programs.mjs';

const question = (panel) => panel.page.getByRole('alertdialog');

/** A program whose text in the editor goes to Y7, that in the machine does not. */
async function edited(panel, name) {
  await panel.run_text(name, 'O1\nG90 G54 G00 X0. Y0.\nG01 X10. F3000.\nM30\n');
  await type_at_line(panel, 3, ' Y7.');
}
async function type_at_line(panel, line, text) {
  await panel.go_to_line(line);
  await panel.page.keyboard.press('End');
  await panel.page.keyboard.type(text);
}
/** Presses the key, gives the answer, and waits until nothing is asked. */
async function answer(panel, press, choice) {
  await press();
  await question(panel).getByText('The machine has an earlier text').waitFor();
  await question(panel).getByRole('button', { name: choice }).click();
  await question(panel).waitFor({ state: 'detached' });
}

export const starting = [
  {
    name: 'cycle start with an edit open asks which text is meant',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('edited.nc', 'O1\nG90 G54 G00 X0. Y0.\nG01 X10. F3000.\nM30\n');
      const edit = async (from) => {
        await panel.go_to_line(3);
        await panel.page.keyboard.press('End');
        await panel.page.keyboard.type(from);
      };
      await edit(' Y7.');
      const question = panel.page.getByRole('alertdialog');
      await panel.press('Cycle start');
      await question.getByText('The machine has an earlier text of edited.nc').waitFor();
      assert.equal(await panel.status(), 'IDLE', 'nothing has begun');
      await question.getByRole('button', { name: 'Start what the machine has' }).click();
      await panel.has_status('END');
      await panel.position_is('X', 10);
      await panel.position_is('Y', 0);
      // By the key, too, and Enter is the main answer.
      await panel.page.locator('h1').click();
      await panel.page.keyboard.press('Control+Enter');
      await question.getByRole('button', { name: 'Load my edit and start' }).waitFor();
      await panel.page.keyboard.press('Enter');
      await panel.position_is('Y', 7);
      await panel.has_status('END');
      assert.equal(await question.count(), 0);
      await panel.press('Cycle start');
      await panel.page.waitForTimeout(300);
      assert.equal(await question.count(), 0, 'nothing is edited any more');
      await panel.has_status('END');
    },
  },
  {
    name: 'a refusal is told at its key, and the way out of it is offered there',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('refused.nc', LONG);
      await panel.press('JOG');
      await panel.press('Cycle start');
      const word = panel.page.getByRole('alertdialog');
      await word.getByText('cycle start does nothing in mode jog').waitFor();
      const key = await box(panel.key('Cycle start'));
      const at = await box(word);
      assert.ok(Math.abs(at.y + at.height - key.y) < 12, 'it stands above its key');
      assert.equal(await panel.page.locator('.notices p').count(), 0, 'and nowhere else');
      await word.getByRole('button', { name: 'Turn to AUTO and start' }).click();
      await panel.has_status('RUNNING');
      await panel.page.locator('.key.on', { hasText: 'AUTO' }).waitFor();
      await panel.press('Reset');
      await panel.has_status('IDLE');
      await panel.press('JOG');
      await panel.press('Over');
      await word.waitFor();
      await word.getByRole('button', { name: 'Close' }).click();
      await word.waitFor({ state: 'detached' });
      await panel.press('AUTO');
    },
  },
  {
    name: 'every key that begins a program asks which text is meant, and goes on with the answer',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      const mine = 'Load my edit and start';
      const theirs = 'Start what the machine has';
      const at_line_4 = async (keys) => {
        await panel.go_to_line(4);
        await panel.page.keyboard.press(keys);
      };
      const ways = {
        Over: [() => panel.press('Over'), 'STEP'],
        Into: [() => panel.press('Into'), 'STEP'],
        Out: [() => panel.press('Out'), 'STEP'],
        F10: [() => panel.page.keyboard.press('F10'), 'STEP'],
        'run to the line': [() => at_line_4('F4'), 'STEP', 'STOPPED'],
        'start at the line': [() => at_line_4('Shift+F4'), 'STEP', 'STOPPED'],
      };
      for (const [way, [press, ...reached]] of Object.entries(ways)) {
        const name = `begins-${way.replaceAll(' ', '-')}.nc`;
        await edited(panel, name);
        await answer(panel, press, theirs);
        await panel.has_status(...reached);
        assert.equal(await panel.page.locator('.program footer .ahead').count(), 1, way);
        await panel.press('Reset');
        await panel.has_status('IDLE');
        await answer(panel, press, mine);
        await panel.has_status(...reached);
        assert.equal(await panel.page.locator('.program footer .ahead').count(), 0, way);
        // What is under way goes on without a question.
        await panel.press('Cycle start');
        await panel.has_status('END');
        assert.equal(await question(panel).count(), 0, way);
        await panel.position_is('Y', 7);
        await panel.press('Reset');
        await panel.has_status('IDLE');
      }
    },
  },
  {
    name: 'a program that waits for an input says so before the start, and its path goes on when it is given',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text(
        'waits.nc',
        'O1\nG90 G54 G00 X0. Y0.\nG01 X5. F3000.\nN10 IF [#1003 EQ 0] GOTO 10\nX30. Y20.\nX0. Y0.\nM30\n',
      );
      const time = panel.page.locator('aside .wait');
      await time.filter({ hasText: 'waits for an input at line 4' }).waitFor();
      await panel.page.locator('.arriving.wait').waitFor();
      await panel.tab('Problems');
      const row = panel.page.locator('#dock-problems tbody tr', { hasText: 'INPUT_WAIT' });
      await row.waitFor();
      assert.ok(!(await row.innerText()).includes('control stops here'), 'it only waits');
      const before = Number(await panel.page.locator('#picture').getAttribute('data-segments'));
      await panel.tab('Variables');
      const input = panel.page.getByRole('button', { name: 'Input #1003' });
      await input.click();
      await time.waitFor({ state: 'detached' });
      await panel.has_path(before + 2);
      await input.click();
      await time.waitFor();
    },
  },
];
