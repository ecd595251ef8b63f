// The first minutes: what greets, how a program gets to run, what is wrong with it, and what the page says about that.
import assert from 'node:assert/strict';
import { AXE, findings } from './accessibility.mjs';
import { box, overlap } from '../boxes.mjs';
import { LONG } from '../programs.mjs';

/** Mistakes of the run in lines 4, 6 and 7, behind each other; one move before the first, two behind. */
const MISTAKES = `%
O0700 (THREE MISTAKES)
G90 G54 G01 X20. F3000.
G04 P1.0
X40.
M98 P7777
G02 X60. Y10. R1.
X0.
M30
%
`;
const TURNED = 'T101\nG00 Z0 X-25.5\nG97 M03 S500\nG01 F50 Z-2\nM30\n';
const BASIC = 'speed(40)\npower(60)\nmove(0,0)\nline(30,0)\nend\n';

/** A file as a person drops it onto an element. */
async function drop(panel, selector, name, text) {
  await panel.page.locator(selector).evaluate(
    (element, [file, content]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([content], file));
      const init = { dataTransfer, bubbles: true, cancelable: true };
      element.dispatchEvent(new DragEvent('dragover', init));
      element.dispatchEvent(new DragEvent('drop', init));
    },
    [name, text],
  );
}
const card = (panel) => panel.page.locator('.guide');
const is_loaded = (panel, name) =>
  panel.until((n) => document.querySelector('header .program')?.textContent?.includes(n), name);
const problem_rows = (panel) => panel.page.locator('#dock-problems tbody tr');
const cursor_line = async (panel) =>
  Number(/line (\d+)/.exec(await panel.page.locator('.program footer').innerText())?.[1] ?? 0);
async function cursor_is(panel, line) {
  await panel.until(
    (n) => document.querySelector('.program footer')?.textContent?.includes(`line ${n}`),
    line,
  );
  assert.equal(await cursor_line(panel), line);
}
/** It is put there with the next picture. */
async function is_below(panel, card, line) {
  const late = Date.now() + 10_000;
  for (;;) {
    const [at, mark] = [await box(card), await box(line)];
    if (at.y >= mark.y + mark.height - 2) return at;
    assert.ok(Date.now() < late, 'the card stands below its line');
    await panel.page.waitForTimeout(30);
  }
}
async function expect_below(panel, card, line) {
  const card_box = await is_below(panel, card, line);
  const buttons = await panel.page.locator('button:visible').all();
  for (const button of buttons) {
    const { inside, words } = await button.evaluate((e) => ({
      inside: e.closest('.cm-tooltip') !== null,
      words: e.textContent.trim() || e.ariaLabel,
    }));
    const at = await button.boundingBox();
    if (!inside && at) assert.ok(!overlap(at, card_box), `it covers the button ${words}`);
  }
}

export const newcomer = [
  {
    name: 'a new browser begins with the mill, and a card says what can be done and what comes next',
    async run({ open }) {
      const panel = await open({ newcomer: true });
      await panel.operates();
      await panel.page.locator('header .chosen b', { hasText: /^mill$/ }).waitFor();
      for (const way of ['Try the sample', 'Lessons', 'New machine'])
        await card(panel).getByRole('button', { name: way }).waitFor();
      await card(panel).getByText('Open a program').waitFor();
      await panel.press('Reset');
      await card(panel).getByRole('button', { name: 'Try the sample' }).click();
      await is_loaded(panel, 'flanges.nc');
      await card(panel).getByText('flanges.nc is loaded: press Cycle start').waitFor();
      const tools = await box(panel.page.getByRole('toolbar', { name: 'Views' }));
      const guide = await box(card(panel));
      assert.ok(!overlap(tools, guide), 'the card is beside the views');
      await panel.press('Cycle start');
      await panel.has_status('RUNNING');
      await card(panel).waitFor({ state: 'detached' });
      await panel.press('Reset');
      await card(panel).getByRole('button', { name: 'Do not show this again' }).click();
      await panel.page.reload();
      await panel.is_connected();
      await panel.has_program();
      assert.equal(await card(panel).count(), 0, 'it stays away');
    },
  },
  {
    name: 'a browser comes back to the machine that it had the last time',
    async run({ open, base }) {
      const panel = await open({ newcomer: true });
      await panel.page.locator('header .chosen').click();
      await panel.page
        .locator('.machine', { hasText: /^laser\b/ })
        .first()
        .click();
      await panel.page.locator('header .chosen b', { hasText: /^laser$/ }).waitFor();
      const again = await panel.context.newPage();
      await again.goto(base);
      await again.locator('header .chosen b', { hasText: /^laser$/ }).waitFor();
    },
  },
  {
    name: 'three actions from nothing to the own program running',
    async run({ open }) {
      const panel = await open({ newcomer: true });
      await panel.operates();
      let actions = 0;
      const chooser = panel.page.waitForEvent('filechooser');
      await card(panel).getByText('Open a program').click();
      actions++;
      await (
        await chooser
      ).setFiles({ name: 'own.nc', mimeType: 'text/plain', buffer: Buffer.from(LONG) });
      actions++;
      await is_loaded(panel, 'own.nc');
      await panel.page.locator('.file.current', { hasText: 'own.nc' }).waitFor();
      await panel.press('Cycle start');
      actions++;
      await panel.has_status('RUNNING');
      await panel.page.locator('header .program', { hasText: 'O0200' }).waitFor();
      await panel.press('Reset');
      assert.equal(actions, 3);
      return `${actions} actions`;
    },
  },
  {
    name: 'a file dropped anywhere is opened and loaded; while the machine works it is opened alone',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await drop(panel, '#picture', 'dropped.nc', LONG);
      await is_loaded(panel, 'dropped.nc');
      await panel.page.locator('.cm-content', { hasText: 'UP AND DOWN' }).waitFor();
      await panel.has_path(4);
      await panel.press('Cycle start');
      await panel.has_status('RUNNING');
      await drop(panel, '.dock', 'second.nc', LONG.replace('0200', '0201'));
      await panel.page.locator('.file.current', { hasText: 'second.nc' }).waitFor();
      await panel.says('The machine is at work');
      assert.ok(!(await panel.page.locator('header .program').innerText()).includes('second.nc'));
      await panel.press('Reset');
    },
  },
  {
    name: 'a program for another machine is told by its words, and goes there by one key',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await drop(panel, 'body', 'turned.nc', TURNED);
      await card(panel)
        .getByText('turned.nc looks like a lathe program: T101 in line 1.')
        .waitFor();
      await card(panel).getByText('The machine lathe runs such programs.').waitFor();
      assert.ok(!(await panel.page.locator('header .program').innerText()).includes('turned.nc'));
      await drop(panel, 'body', 'square.bas', BASIC);
      await card(panel).getByText('square.bas looks like laser BASIC.').waitFor();
      assert.ok(!(await panel.page.locator('header .program').innerText()).includes('square.bas'));
      await card(panel).getByRole('button', { name: 'Open it on laser' }).click();
      await panel.page.locator('header .chosen b', { hasText: /^laser$/ }).waitFor();
      await is_loaded(panel, 'square.bas');
      await card(panel).waitFor({ state: 'detached' });
      await drop(panel, 'body', 'turned.nc', TURNED);
      await card(panel).getByRole('button', { name: 'Open it on lathe' }).click();
      await panel.page.locator('header .chosen b', { hasText: /^lathe$/ }).waitFor();
      await is_loaded(panel, 'turned.nc');
    },
  },
  {
    name: 'the message line covers neither the picture nor the program nor a key',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('noticed.nc', LONG);
      await panel.page.locator('.program').getByRole('button', { name: 'Load' }).click();
      await panel.says('noticed.nc is loaded.');
      const line = await box(panel.page.locator('.notices'));
      for (const part of ['.picture', '.program', '.dock', 'aside', '.slider'])
        assert.ok(!overlap(line, await box(panel.page.locator(part).first())), part);
      for (const key of await panel.page.locator('.operator .key').all())
        assert.ok(!overlap(line, await box(key)), await key.innerText());
    },
  },
  {
    name: 'all problems are listed, also those behind the place where the control stops',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      // What the part would meet besides is not what this is about.
      await panel.page.locator('.tools .opener').click();
      await panel.page.getByLabel('Part', { exact: true }).uncheck();
      await panel.page.keyboard.press('Escape');
      await panel.run_text('mistakes.nc', MISTAKES);
      await panel.page.locator('header .problems', { hasText: '3' }).waitFor();
      await panel.tab('Problems');
      await panel.page.locator('#tab-problems .count', { hasText: '3' }).waitFor();
      await panel.until(() => document.querySelectorAll('#dock-problems tbody tr').length === 3);
      const rows = await problem_rows(panel).allInnerTexts();
      for (const [i, [code, line]] of [
        ['PS0007', 4],
        ['PS0076', 6],
        ['PS0020', 7],
      ].entries()) {
        assert.match(rows[i], new RegExp(`${code}[\\s\\S]*\\b${line}\\b`));
        assert.equal(rows[i].includes('control stops here'), i === 0, rows[i]);
      }
      await panel.until(() => document.querySelectorAll('.cm-lintRange-error').length === 3);
      await problem_rows(panel).nth(1).locator('.sentence').click();
      await cursor_is(panel, 6);
      // Keys: F8 where nothing moves, Shift+F8 back, around both ends.
      await panel.page.locator('h1').click();
      await panel.page.keyboard.press('F8');
      await cursor_is(panel, 7);
      await panel.page.keyboard.press('F8');
      await cursor_is(panel, 4);
      await panel.page.keyboard.press('Shift+F8');
      await cursor_is(panel, 7);
      // The path goes on behind the stop, and the time says where it ends.
      await panel.has_path(3);
      await panel.page.getByText('stops at line 4 with PS0007').waitFor();
      await panel.page.locator('.arriving.error', { hasText: 'The control stops with' }).waitFor();
      await panel.press('Cycle start');
      await panel.has_status('ALARM');
      await panel.position_is('X', 20);
      await panel.press('Reset');
      await panel.go_to_line(4);
      await panel.page.keyboard.press('End');
      await panel.page.keyboard.press('Backspace');
      await panel.page.keyboard.press('Backspace');
      await panel.page.keyboard.press('F5');
      await panel.says('is loaded.');
      await panel.page.locator('header .problems', { hasText: '2' }).waitFor();
      await panel.page.getByText('stops at line 6 with PS0076').waitFor();
    },
  },
  {
    name: 'a text that was edited and not run yet is not said to be without errors',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      const footer = (text) => panel.page.locator('.program footer', { hasText: text }).waitFor();
      await panel.run_text('divides.nc', 'O1\n#100=0\n#101=1/#100\nM30\n');
      await footer('Errors: 1');
      await panel.go_to_line(1);
      await panel.page.keyboard.type('(A)');
      await footer('Syntax correct, not run yet');
      await panel.page.keyboard.press('F5');
      await footer('Errors: 1');
      await panel.run_text('whole.nc', 'O2\nG91 G01 X1. F6000\nM30\n');
      await footer('No errors');
    },
  },
  {
    name: 'F8 holds the feed while something moves',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('held.nc', LONG);
      await panel.press('Cycle start');
      await panel.has_status('RUNNING');
      await panel.page.locator('.cm-content').click();
      await panel.page.keyboard.press('F8');
      await panel.has_status('HOLD');
      await panel.press('Reset');
    },
  },
  {
    name: 'the manual opens at what is asked about, and can be searched, and its links lead on',
    async run({ open, base }) {
      const panel = await open();
      const hosts = new Set();
      panel.page.on('request', (request) => hosts.add(new URL(request.url()).host));
      await panel.fresh();
      await panel.run_text('asked.nc', MISTAKES);
      const dialog = panel.page.getByRole('dialog', { name: 'Manual' });
      const article = dialog.locator('article');
      const sought = article.locator('.sought');
      // From a row of the problems.
      await panel.tab('Problems');
      await panel.page.getByRole('button', { name: 'Manual: PS0076' }).click();
      await sought.getByText('PS0076').waitFor();
      assert.ok(overlap(await box(sought), await box(article)), 'the entry is in sight');
      await panel.page.keyboard.press('Escape');
      // From the alarm, and by F1 while it stands.
      await panel.press('Cycle start');
      await panel.has_status('ALARM');
      await panel.page.locator('aside').getByRole('button', { name: 'Manual: PS0007' }).click();
      await sought.getByText('PS0007').waitFor();
      await panel.page.keyboard.press('Escape');
      await panel.page.keyboard.press('F1');
      await sought.getByText('PS0007').waitFor();
      await panel.page.keyboard.press('Escape');
      await panel.press('Reset');
      await panel.has_status('IDLE');
      // By F1 alone: the panel; its links, and back.
      await panel.go_to_line(1);
      await panel.page.keyboard.press('F1');
      await article.getByRole('heading', { name: 'The panel', exact: true }).waitFor();
      await article.getByRole('link', { name: 'machine file', exact: true }).first().click();
      await article.getByRole('heading', { name: 'Machine files', exact: true }).waitFor();
      await dialog.getByRole('button', { name: 'Back' }).click();
      await article.getByRole('heading', { name: 'The panel', exact: true }).waitFor();
      await dialog.getByRole('searchbox').fill('one decimal point at most');
      await dialog.locator('nav li button').first().click();
      await sought.getByText('PS0007').waitFor();
      await panel.page.keyboard.press('Escape');
      await dialog.waitFor({ state: 'detached' });
      assert.deepEqual([...hosts], [new URL(base).host], 'nobody else was asked');
    },
  },
  {
    name: 'a message of BASIC leads to its grammar',
    async run({ open }) {
      const panel = await open({ machine: 'laser' });
      await panel.fresh();
      await panel.run_text('grammar.bas', 'for i=1 to 3\nmove i*10, 0\nnext i\n');
      await panel.tab('Problems');
      await panel.page.getByRole('button', { name: 'Manual: laser-basic' }).first().click();
      const article = panel.page.getByRole('dialog', { name: 'Manual' }).locator('article');
      await article.getByRole('heading', { name: 'Laser BASIC', exact: true }).waitFor();
    },
  },
  {
    name: 'an error explains itself below its line and covers no button',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('below.nc', 'G04 P1.5\nG54\nM30\n');
      const mark = panel.page.locator('.cm-lintRange-error').first();
      await mark.hover();
      const bubble = panel.page.locator('.cm-tooltip-lint');
      await bubble.getByText('PS0007').waitFor();
      await expect_below(panel, bubble, mark);
      await bubble.getByRole('button', { name: 'Manual' }).click();
      await panel.page.getByRole('dialog', { name: 'Manual' }).waitFor();
    },
  },
  {
    name: 'teaching shows where the machine stands in both systems, by name',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.press('TEACH');
      const places = panel.page.locator('#dock-teach .places');
      await places.getByText('Machine', { exact: true }).waitFor();
      await places.getByText('Work', { exact: true }).waitFor();
      assert.equal(await places.locator('dd').count(), 2);
      await panel.press('AUTO');
    },
  },
  {
    name: 'symbols have words where there is room for them',
    async run({ open }) {
      const words = ['Run to', 'Start at', 'Follow', 'Isometric', 'Zoom in', 'Rapid', 'Spindle'];
      const shown = async (width) => {
        const panel = await open({ width });
        await panel.has_program();
        const seen = [];
        for (const word of words)
          if (
            await panel.page
              .locator('.word', { hasText: new RegExp(`^${word}$`) })
              .first()
              .isVisible()
          )
            seen.push(word);
        const bar = await panel.page
          .locator('.program .bar')
          .evaluate((e) => e.scrollWidth - e.clientWidth);
        assert.ok(bar <= 0, `the bar of the program at ${width}: ${bar} px are cut off`);
        return seen;
      };
      assert.deepEqual(await shown(1440), words);
      assert.deepEqual(await shown(1280), []);
    },
  },
  {
    name: 'axe finds nothing in card, problems, question and manual, in the dark and in the light',
    async run({ open }) {
      const panel = await open({ newcomer: true });
      await panel.operates();
      await panel.press('Reset');
      await drop(panel, 'body', 'seen.nc', MISTAKES);
      await is_loaded(panel, 'seen.nc');
      await card(panel).waitFor();
      await panel.tab('Problems');
      await problem_rows(panel).nth(2).waitFor();
      await panel.page.evaluate(AXE);
      const found = await findings(panel, 'card and problems');
      await drop(panel, 'body', 'other.bas', BASIC);
      await card(panel).getByRole('alert').waitFor();
      found.push(...(await findings(panel, 'another machine')));
      await card(panel).getByRole('button', { name: 'Close' }).click();
      await panel.press('JOG');
      await panel.press('Cycle start');
      await panel.page.getByRole('alertdialog').waitFor();
      found.push(...(await findings(panel, 'question')));
      await panel.page.keyboard.press('Escape');
      await panel.press('AUTO');
      await panel.page.getByRole('button', { name: 'Manual', exact: true }).first().click();
      await panel.page.getByRole('dialog').locator('article h2').waitFor();
      found.push(...(await findings(panel, 'manual')));
      assert.equal([...new Set(found)].join('\n'), '');
    },
  },
];
