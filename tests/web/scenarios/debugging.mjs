// Stepping, variables, breakpoints, alarms.
import assert from 'node:assert/strict';
import { MACRO, WRONG } from '../programs.mjs';

export const debugging = [
  {
    name: 'a step goes into a macro, and its local variable changes',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('macro.nc', MACRO);
      await panel.tab('Variables');
      await panel.step_into(9);
      await panel.variable_is('#1', '5');
      await panel.variable_is('#2', '2');
      await panel.press('Over');
      await panel.executes_line(10);
      await panel.variable_is('#33', '7');
      await panel.page.locator('#dock-variables li.changed', { hasText: '#33' }).waitFor();
      await panel.tab('Stepping');
      const stack = await panel.page.locator('.dock ol button').allInnerTexts();
      assert.equal(stack.length, 2, `two levels of calls: ${stack}`);
      await panel.press('Out');
      await panel.executes_line(4);
      await panel.press('Back');
      await panel.until(() =>
        document.querySelector('header .status')?.textContent?.includes('STEP'),
      );
      await panel.press('Reset');
    },
  },
  {
    name: 'a common variable is edited, and the edit taken back',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.tab('Variables');
      await panel.set_variable('#510', '0');
      await panel.variable_is('#510', '0');
      await panel.set_variable('#510', '12.5');
      await panel.variable_is('#510', '12.5');
      await panel.add_variable('#510');
      await panel.page.waitForTimeout(500);
      await panel.variable_is('#510', '12.5');
      await panel.page.locator('h1').click();
      await panel.page.keyboard.press('Control+z');
      await panel.variable_is('#510', '0');
      await panel.page.keyboard.press('Control+y');
      await panel.variable_is('#510', '12.5');
      await panel.page.reload();
      await panel.tab('Variables');
      await panel.variable_is('#510', '12.5');
    },
  },
  {
    name: 'a breakpoint stops the program, with a condition only when it holds',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('macro.nc', MACRO);
      await panel.toggle_breakpoint(10);
      await panel.page.locator('.cm-dot.set').waitFor();
      await panel.press('Cycle start');
      await panel.has_status('STEP');
      await panel.executes_line(10);
      await panel.page.getByText('Breakpoint at line 10').waitFor();
      await panel.press('Reset');
      await panel.has_status('IDLE');
      await panel.go_to_line(10);
      await panel.page.keyboard.press('Shift+F9');
      await panel.page.getByRole('textbox', { name: 'Stop only when' }).fill('#1 GT 100');
      await panel.page.keyboard.press('Enter');
      await panel.page.locator('.cm-dot.conditional').waitFor();
      await panel.press('Cycle start');
      await panel.has_status('END');
      await panel.toggle_breakpoint(10);
      await panel.page.locator('.cm-dot.set').waitFor({ state: 'detached' });
    },
  },
  {
    name: 'the program stops when a watched variable is written',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('macro.nc', MACRO);
      await panel.tab('Stepping');
      await panel.page.getByRole('textbox', { name: 'Stop when written' }).fill('#500');
      await panel.page.getByRole('button', { name: 'Stop when written' }).click();
      await panel.press('Cycle start');
      await panel.has_status('STEP');
      await panel.page.getByText('was written by line 4').waitFor();
      await panel.page.getByRole('button', { name: 'Remove: #500' }).click();
      await panel.press('Reset');
    },
  },
  {
    name: 'an alarm is told in words with its place, English and Chinese',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('wrong.nc', WRONG);
      await panel.press('Cycle start');
      await panel.has_status('ALARM');
      const card = panel.page.locator('section.alarm');
      const text = await card.innerText();
      assert.match(text, /PS0112/);
      assert.match(text, /zero divide/i);
      assert.match(text, /wrong\.nc:5/);
      await panel.page.getByRole('combobox', { name: 'Language' }).selectOption('zh-Hant');
      await panel.page.locator('section.alarm', { hasText: '除以零' }).waitFor();
      await panel.page.getByRole('combobox', { name: '語言' }).selectOption('en');
      await card.getByRole('button', { name: /wrong\.nc:5/ }).click();
      await panel.page.locator('.program footer', { hasText: 'line 5' }).waitFor();
      await panel.press('Reset');
      await card.waitFor({ state: 'detached' });
    },
  },
  {
    name: 'the program runs to a line and starts at a line',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('macro.nc', MACRO);
      await panel.go_to_line(5);
      await panel.page.keyboard.press('F4');
      await panel.executes_line(5);
      await panel.press('Reset');
      await panel.has_status('IDLE');
      await panel.go_to_line(5);
      await panel.page.keyboard.press('Shift+F4');
      await panel.executes_line(5);
      await panel.press('Reset');
    },
  },
];
