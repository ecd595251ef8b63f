// Marks and breakpoints stand where the machine is, also in a text that was edited since.
import assert from 'node:assert/strict';
import { LONG } from '../programs.mjs';

export const marks = [
  {
    name: 'the line that executes is marked where it stands in the edited text',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('marks.nc', LONG);
      await panel.go_to_line(1);
      await panel.page.keyboard.type('(A)\n(B)\n(C)\n');
      await panel.page.locator('.ahead').waitFor();
      await start_what_is_loaded(panel);
      await panel.has_status('RUNNING');
      await panel.passes('X', 0);
      await panel.executes_line(7); // the fourth line of what the machine has
      const block = await panel.page.locator('aside .text.mono').first().innerText();
      assert.equal(await panel.page.locator('.cm-executing').innerText(), block);
      // And stays there while lines before it come and go.
      await panel.go_to_line(1);
      await panel.page.keyboard.press('Control+Shift+K');
      await panel.executes_line(6);
      await panel.press('Reset');
      await panel.has_status('IDLE');
    },
  },
  {
    name: 'a breakpoint stops at the block that it stands beside, however the text was edited',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('stops.nc', LONG.replace('F300.', 'F6000.'));
      await panel.toggle_breakpoint(5); // Y50.
      await panel.page.locator('.cm-dot.set').waitFor();
      await panel.go_to_line(1);
      await panel.page.keyboard.type('(A)\n(B)\n');
      await panel.page.locator('.ahead').waitFor();
      await panel.toggle_breakpoint(8); // X0., the sixth line of what the machine has
      await panel.page.locator('.cm-dot.set').nth(1).waitFor();
      await panel.toggle_breakpoint(1);
      await panel.says('Line 1 is new');
      await start_what_is_loaded(panel);
      for (const [line, text] of [
        [7, 'Y50.'],
        [8, 'X0.'],
      ]) {
        await panel.has_status('STEP');
        await panel.executes_line(line);
        assert.equal(await panel.page.locator('.cm-executing').innerText(), text);
        await panel.press('Cycle start');
      }
      await panel.has_status('END');
      await panel.press('Reset');
      await panel.has_status('IDLE');
      // Loaded, the machine has the lines of the screen.
      await panel.page.keyboard.press('F5');
      await panel.says('stops.nc is loaded.');
      await panel.press('Cycle start');
      await panel.has_status('STEP');
      await panel.executes_line(7);
      assert.equal(await panel.page.locator('.cm-executing').innerText(), 'Y50.');
    },
  },
];

async function start_what_is_loaded(panel) {
  await panel.press('Cycle start');
  await panel.page.getByRole('button', { name: 'Start what the machine has' }).click();
}
