// A phone beside the machine: nothing wider or higher than it, the keys always at hand, everything large enough for a finger.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { LONG, WRONG, spiral } from '../programs.mjs';

const SIZE = { width: 390, height: 844, touch: true };

async function fits(panel, where) {
  const { page, canvas } = await panel.page.evaluate(() => ({
    page: [
      document.documentElement.scrollWidth,
      document.documentElement.scrollHeight,
      document.body.scrollHeight,
    ],
    canvas: document.querySelector('#picture').getBoundingClientRect().height,
  }));
  assert.deepEqual(page, [390, 844, 844], `${where}: the page is as large as the phone`);
  assert.ok(canvas <= 844, `${where}: the picture is ${canvas} px high`);
}
async function keys_at_hand(panel, where) {
  for (const name of ['Cycle start', 'Feed hold', 'Reset']) {
    const box = await panel.key(name).boundingBox();
    assert.ok(box.y >= 0 && box.y + box.height <= 844, `${where}: ${name} is in sight`);
    assert.ok(box.height >= 44 && box.width >= 44, `${where}: ${name} is as large as a finger`);
  }
  const status = await panel.page.locator('header .status').boundingBox();
  assert.ok(status.y >= 0 && status.x + status.width <= 390, `${where}: the status is in sight`);
}
const show = (panel, pane) =>
  panel.page.locator('.panes').getByRole('button', { name: pane, exact: true }).click();

/** What is seen and can be pressed, and is smaller than a finger. Links in a sentence may be. */
function small_targets(panel) {
  return panel.page.evaluate(() =>
    [...document.querySelectorAll('button, select, input, textarea, [role="tab"]')]
      .filter((e) => {
        const style = getComputedStyle(e);
        const box = e.getBoundingClientRect();
        const is_seen = style.visibility === 'visible' && box.width > 1 && box.height > 1;
        const is_place = e.matches('.place, .row, [type="checkbox"], [type="file"], .name');
        return is_seen && !is_place && !e.closest('.cm-editor, .unseen') && box.height < 43.5;
      })
      .map(
        (e) =>
          `${e.tagName} ${e.className} ${e.getAttribute('aria-label') ?? e.textContent.trim()} ${Math.round(e.getBoundingClientRect().height)}`,
      ),
  );
}

/** Whole in the window, and nothing over its middle. */
async function in_reach(locator) {
  await locator.waitFor();
  const found = await locator.evaluate((element) => {
    const { left, right, top, bottom } = element.getBoundingClientRect();
    const at = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
    const whole = left >= 0 && right <= innerWidth && top >= 0 && bottom <= innerHeight;
    return whole && (element.contains(at) || at?.contains(element));
  });
  assert.ok(found, `${locator} is in reach`);
}

export const phone = [
  {
    name: 'a phone greets a newcomer, and leads him to the lessons',
    async run({ open }) {
      const panel = await open({ width: 390, height: 844, touch: true, newcomer: true });
      const card = panel.page.locator('.guide');
      await card.waitFor();
      for (const way of ['Open a program', 'Try the sample', 'Lessons', 'New machine'])
        await in_reach(card.getByText(way, { exact: true }).or(card.getByLabel(way)).first());
      await card.getByRole('button', { name: 'Lessons' }).click();
      await panel.page.locator('#dock-training').waitFor();
      assert.equal(await card.count(), 0);
    },
  },
  {
    name: 'a phone shows one pane at a time between the status and the keys',
    async run({ open, shots }) {
      const panel = await open(SIZE);
      await panel.operates();
      await panel.press('Reset');
      await panel.has_status('IDLE');
      await show(panel, 'Program');
      await panel.run_text('phone.nc', LONG);
      await panel.has_path(4);
      for (const [pane, seen] of [
        ['Position', 'aside .big'],
        ['Program', '.cm-content'],
        ['Picture', '#picture'],
        ['More', '.dock [role="tab"]'],
      ]) {
        await show(panel, pane);
        await panel.page.locator(seen).first().waitFor({ state: 'visible' });
        await fits(panel, pane);
        await keys_at_hand(panel, pane);
        assert.deepEqual(await small_targets(panel), [], pane);
        if (shots)
          await panel.page.screenshot({ path: join(shots, `phone-${pane.toLowerCase()}.png`) });
      }
      await show(panel, 'Position');
      await panel.press('Cycle start');
      await panel.has_status('RUNNING');
      await panel.press('Feed hold');
      await panel.has_status('HOLD');
      await panel.press('Reset');
      await panel.has_status('IDLE');
    },
  },
  {
    name: 'blocks are entered on a phone without a keyboard',
    async run({ open, shots }) {
      const panel = await open(SIZE);
      await panel.operates();
      await panel.press('Reset');
      await panel.has_status('IDLE');
      await show(panel, 'More');
      await panel.press('MDI');
      const pad = panel.page.locator('.pad');
      for (const key of [
        'G',
        '9',
        '1',
        'G',
        '0',
        '1',
        'X',
        '-',
        '2',
        '.',
        '5',
        'F',
        '1',
        '0',
        '0',
        '0',
        '9',
      ])
        await pad.getByRole('button', { name: key, exact: true }).click();
      await pad.getByRole('button', { name: 'Erase' }).click();
      const entry = panel.page.getByRole('textbox', { name: 'Blocks to execute' });
      assert.equal(await entry.inputValue(), 'G91G01X-2.5F1000');
      if (shots) await panel.page.screenshot({ path: join(shots, 'phone-mdi.png') });
      await show(panel, 'Position');
      const before = await panel.position('X');
      await show(panel, 'More');
      await panel.page.getByRole('button', { name: 'Execute' }).click();
      await panel.position_is('X', before - 2.5);
      await panel.press('AUTO');
    },
  },
  {
    name: 'a phone stays as large as it is with a program of a million lines',
    async run({ open }) {
      const panel = await open(SIZE);
      await panel.operates();
      await show(panel, 'Program');
      await panel.run_text('phone-million.nc', spiral(1_000_000));
      await panel.has_path(100_000, 120_000);
      for (const pane of ['Program', 'Picture', 'Position']) {
        await show(panel, pane);
        await fits(panel, pane);
        await keys_at_hand(panel, pane);
      }
      await show(panel, 'Program');
      await panel.run_text('phone.nc', LONG);
    },
  },
  {
    name: 'an alarm, a question and the library fit a phone',
    async run({ open, shots }) {
      const panel = await open(SIZE);
      await panel.operates();
      await panel.press('Reset');
      await panel.has_status('IDLE');
      const take = async (name) => {
        await fits(panel, name);
        if (shots) await panel.page.screenshot({ path: join(shots, `phone-${name}.png`) });
      };
      await show(panel, 'Program');
      await panel.run_text('phone-wrong.nc', WRONG);
      await panel.press('Cycle start');
      await panel.has_status('ALARM');
      await show(panel, 'Position');
      await take('alarm');
      await panel.press('Reset');
      await show(panel, 'Program');
      await panel.go_to_line(2);
      await panel.page.keyboard.type('(E)');
      await panel.page.locator('.file.current .dirty').waitFor();
      await panel.page.locator('.program footer .ahead').waitFor();
      await in_reach(panel.page.locator('.program .bar .button').last());
      await in_reach(panel.page.locator('.program footer > *').last());
      await panel.press('Cycle start');
      for (const choice of ['Load my edit and start', 'Start what the machine has', 'Close'])
        await in_reach(panel.page.getByRole('alertdialog').getByRole('button', { name: choice }));
      await take('which-text');
      await panel.page.keyboard.press('Escape');
      await panel.open_library();
      await take('library');
      await panel.page.getByRole('button', { name: 'Delete: phone-wrong.nc' }).click();
      await panel.page.locator('dialog.question').waitFor();
      await take('question');
      await panel.page.locator('dialog.question').getByRole('button', { name: 'Leave it' }).click();
      await panel.page.keyboard.press('Escape');
      await panel.page.locator('header .chosen').click();
      await panel.page.locator('.machine').first().waitFor();
      const box = await panel.page.locator('.popover .panel').boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= 390, 'the machines are not cut off');
      await take('machines');
    },
  },
];
