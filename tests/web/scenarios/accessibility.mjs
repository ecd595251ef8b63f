// axe finds nothing, and everything can be reached and done with the keyboard.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { WRONG } from '../programs.mjs';

export const AXE = readFileSync(
  createRequire(import.meta.url).resolve('axe-core/axe.min.js'),
  'utf8',
);
const TABS = [
  'Problems',
  'Features',
  'Set-up',
  'Variables',
  'Stepping',
  'MDI',
  'Teach',
  'Offsets',
  'Tools',
  'Messages',
  'Pulses',
  'Speed',
  'Training',
];

const RULES = {
  type: 'tag',
  values: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'best-practice'],
};
/** Those that look at colours: all else is the same in the dark and in the light. */
const RULES_OF_COLOURS = { type: 'rule', values: ['color-contrast', 'link-in-text-block'] };

/** Of all rules as the page is, then of those of colours in the other light, in which it stays. */
export async function findings(panel, where, part = 'html') {
  const found = await violations(panel, where, part, RULES);
  const light = await other_light(panel.page);
  return [...found, ...(await violations(panel, `${where}, ${light}`, part, RULES_OF_COLOURS))];
}

/** As `findings`, of all places of a tour: there the light changes once, for a picture is drawn anew with it. */
async function findings_of_tour(panel, tour) {
  const found = [];
  const look_by =
    (rules, light) =>
    async (where, part = 'html') =>
      found.push(...(await violations(panel, `${where}${light}`, part, rules)));
  await tour(panel, look_by(RULES, ''));
  const light = await other_light(panel.page);
  await tour(panel, look_by(RULES_OF_COLOURS, `, ${light}`));
  return found;
}

async function violations({ page }, where, part, runOnly) {
  const { violations } = await page.evaluate(
    ([within, rules]) => window.axe.run(within, { resultTypes: ['violations'], runOnly: rules }),
    [part, runOnly],
  );
  return violations.map(
    ({ id, nodes }) =>
      `${where}: ${id}: ${nodes
        .map((n) => n.target.join(' '))
        .slice(0, 4)
        .join(', ')}`,
  );
}

async function other_light(page) {
  const is_dark = (await page.getAttribute('html', 'data-scheme')) === 'dark';
  const colorScheme = is_dark ? 'light' : 'dark';
  await page.emulateMedia({ colorScheme });
  await page.locator(`html[data-scheme="${colorScheme}"]`).waitFor();
  return colorScheme;
}

/** Nothing glides any more: the colours between are nobody's. */
const at_rest = (panel) =>
  panel.until(() =>
    document
      .getAnimations()
      .every(
        (each) =>
          each.playState !== 'running' || each.effect.getComputedTiming().endTime === Infinity,
      ),
  );

/** `look` at the page as it is first, then at what is another one of it. All tabs, dialogs and what opens beside its key. */
async function desk_tour(panel, look) {
  await look('page');
  for (const tab of TABS) {
    await panel.tab(tab);
    await at_rest(panel);
    await look(tab, '.dock');
  }
  for (const [name, key] of [
    ['keyboard', '?'],
    ['library', 'Control+o'],
    ['manual', 'F1'],
  ]) {
    await panel.page.locator('h1').click();
    await panel.page.keyboard.press(key);
    await panel.page.getByRole('dialog').waitFor();
    await look(name, 'dialog');
    await panel.page.keyboard.press('Escape');
    await panel.page.getByRole('dialog').waitFor({ state: 'detached' });
  }
  await panel.page.getByRole('button', { name: 'Settings of the machine' }).click();
  await panel.page.getByRole('dialog').waitFor();
  await look('settings', 'dialog');
  await panel.page.keyboard.press('Escape');
  const openers = await panel.page.locator('.popover > .opener:visible').all();
  assert.ok(openers.length >= 4, 'machines, files, operator, what is shown');
  for (const opener of openers) {
    await opener.click();
    await look(await opener.innerText());
    await panel.page.keyboard.press('Escape');
  }
}

/** All panes of a phone, all tabs, and the library. */
async function phone_tour(panel, look) {
  const pane = (name) =>
    panel.page.locator('.panes').getByRole('button', { name, exact: true }).click();
  for (const name of ['Position', 'Program', 'Picture', 'More']) {
    await pane(name);
    await look(name);
  }
  for (const tab of TABS) {
    await panel.tab(tab);
    await at_rest(panel);
    await look(tab, '.dock');
  }
  await pane('Program');
  await panel.open_library();
  await look('library');
  await panel.page.keyboard.press('Escape');
}

export const accessibility = [
  {
    name: 'axe finds nothing, in the dark and in the light',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      // A second program, and a result in the tab of training.
      await panel.begin_exercise('Find the mistakes');
      await panel.training_button('Check').click();
      await panel.page.locator('#dock-training .score').waitFor();
      await panel.open_program('flanges.nc');
      await panel.press('JOG');
      await panel.page.evaluate(AXE);
      const found = await findings_of_tour(panel, desk_tour);
      await panel.press('AUTO');
      // A question, an edit, a draft that is offered, an alarm, a request for the machine.
      const look = async (where) => found.push(...(await findings(panel, where)));
      await panel.run_text('axe.nc', WRONG);
      await panel.go_to_line(2);
      await panel.page.keyboard.type('(E)');
      await panel.page.locator('.file.current .dirty').waitFor();
      await panel.page.getByRole('button', { name: 'Close: axe.nc' }).click();
      await panel.page.locator('dialog.question').waitFor();
      await look('question');
      await panel.page.keyboard.press('Escape');
      await panel.press('Over');
      await panel.page.getByRole('alertdialog').waitFor();
      await look('question at a key');
      await panel.page.keyboard.press('Escape');
      panel.page.once('dialog', (dialog) => dialog.accept());
      await panel.page.reload();
      await panel.is_connected();
      await panel.page.evaluate(AXE);
      await panel.page.locator('.draft').waitFor();
      await panel.tab('Messages');
      await panel.press('Cycle start');
      await panel.has_status('ALARM');
      await look('draft and alarm');
      const second = await open();
      await second.page.locator('header .badge').click();
      await second.page.getByLabel('Your name').fill('Lee');
      await second.page.getByRole('button', { name: /^Ask / }).click();
      await panel.page.locator('.request').waitFor();
      await look('request');
      await panel.page.locator('.request').getByRole('button', { name: 'Keep it' }).click();
      await panel.press('Reset');
      await panel.page.locator('.draft').getByRole('button', { name: 'Discard' }).click();
      assert.equal([...new Set(found)].join('\n'), '');
    },
  },
  {
    name: 'axe finds nothing on a phone, nor while the server hangs, in the dark and in the light',
    needs_server: true,
    async run({ open, server }) {
      const panel = await open({ width: 390, height: 844, touch: true });
      await panel.operates();
      await panel.press('Reset');
      await panel.page.evaluate(AXE);
      const found = await findings_of_tour(panel, phone_tour);
      server.freeze();
      try {
        await panel.page.locator('.line[role="alert"]', { hasText: 'No link since' }).waitFor();
        found.push(...(await findings(panel, 'no link')));
      } finally {
        server.thaw();
      }
      assert.equal([...new Set(found)].join('\n'), '');
    },
  },
  {
    name: 'on a tablet a notice hides no button, and file and zero keys are in sight',
    async run({ open }) {
      const panel = await open({ machine: 'five-axis', width: 820, height: 1180 });
      await panel.has_program();
      await panel.operates();
      const box = (locator) => locator.boundingBox();
      await panel.tab('Offsets');
      const dock = await box(panel.page.locator('.dock'));
      const zero = await box(panel.page.getByRole('button', { name: /^C0, G54:/ }));
      assert.ok(zero.x + zero.width <= dock.x + dock.width, 'C0 is in sight');
      await panel.page.locator('.program').getByRole('button', { name: 'Load' }).click();
      await panel.says('is loaded.');
      const notice = await box(panel.page.locator('.notices p').first());
      const tools = await box(panel.page.getByRole('toolbar', { name: 'Views' }));
      assert.ok(notice.y >= tools.y + tools.height, 'the views are beside the notice');
      await panel.page.locator('header .file').waitFor();
    },
  },
  {
    name: 'every control is reached by the Tab key',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.open_program('flanges.nc');
      await panel.press('JOG');
      const wanted = await panel.page.evaluate(() => {
        const is_one = (e) => e.matches('button, input, select, textarea, a[href], [tabindex="0"]');
        const all = [...document.querySelectorAll('*')].filter(
          (e) => is_one(e) && !e.disabled && e.tabIndex >= 0 && e.getClientRects().length,
        );
        all.forEach((e, i) => (e.dataset.wanted = String(i)));
        return all.length;
      });
      assert.ok(wanted > 60, `${wanted} controls`);
      await panel.page.evaluate(() => document.activeElement?.blur());
      const reached = new Set();
      for (let i = 0; i < wanted + 25; i++) {
        await panel.page.keyboard.press('Tab');
        const at = await panel.page.evaluate(() => {
          const e = document.activeElement;
          // The editor keeps Tab for itself only while it is asked to; it is left by Escape, Tab.
          return e?.closest('[data-wanted]')?.dataset.wanted ?? null;
        });
        if (at !== null) reached.add(at);
      }
      const missed = await panel.page.evaluate(
        (seen) =>
          [...document.querySelectorAll('[data-wanted]')]
            .filter((e) => !seen.includes(e.dataset.wanted))
            .map((e) => e.outerHTML.slice(0, 90)),
        [...reached],
      );
      assert.deepEqual(missed, []);
      await panel.press('AUTO');
    },
  },
  {
    name: 'the machine is operated with the keyboard alone',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      const { keyboard } = panel.page;
      await keyboard.press('Alt+4');
      await panel.page.locator('.key.on', { hasText: 'JOG' }).waitFor();
      await panel.page.locator('h1').click();
      const before = await panel.position('X');
      await keyboard.down('ArrowRight');
      await panel.passes('X', before);
      await keyboard.up('ArrowRight');
      await panel.has_status('IDLE', 'END', 'STOPPED');
      await keyboard.press('Alt+3');
      await panel.page.locator('.key.on', { hasText: 'AUTO' }).waitFor();
      await keyboard.press('Alt+s');
      await panel.page.locator('.key.on', { hasText: 'Single block' }).waitFor();
      await keyboard.press('Alt+s');
      await keyboard.press('?');
      await panel.page.getByRole('dialog', { name: 'Keyboard' }).waitFor();
      await keyboard.press('Escape');
    },
  },
];
