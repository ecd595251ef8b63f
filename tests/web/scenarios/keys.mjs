// Every key that is advertised does what it says, whatever the cursor stands in.
import assert from 'node:assert/strict';
import { LONG } from '../programs.mjs';

/** Cut by a tool that does not turn: each block of it is a finding of the part. */
const TEXT = LONG.replace('G01 X150.', 'G01 Z-1. X150.');

/** What each key does, as it can be seen: `begin` brings the machine where the key can do it. */
const KEYS = {
  'Cycle start': { begin: idle, does: (p) => p.has_status('RUNNING') },
  'Feed hold': { begin: running, does: (p) => p.has_status('HOLD') },
  Reset: { begin: running, does: (p) => p.has_status('IDLE') },
  'Interrupt signal (M96)': {
    begin: running,
    async does(p) {
      await p.tab('Messages');
      await p.page.locator('#dock-messages', { hasText: 'no M96 was in force' }).waitFor();
    },
  },
  'Feed override up': { begin: normal_feed, does: (p) => feed_is(p, '110') },
  'Feed override down': { begin: normal_feed, does: (p) => feed_is(p, '90') },
  'Step over': { begin: idle, does: (p) => p.has_status('STEP') },
  'Step into': { begin: idle, does: (p) => p.has_status('STEP') },
  'Step out': { begin: stepped, does: (p) => p.has_status('RUNNING') },
  'Step back': { begin: stepped_twice, does: (p) => told(p, (line, before) => line < before) },
  'Run to the line of the cursor': { begin: idle, does: (p) => p.has_status('RUNNING', 'STEP') },
  'Start at the line of the cursor': { begin: idle, does: (p) => p.has_status('STEP', 'STOPPED') },
  'Breakpoint on, off': {
    begin: idle,
    does: async (p, press) => {
      await p.page.locator('.cm-dot.set').first().waitFor();
      await press();
      await p.page.locator('.cm-dot.set').first().waitFor({ state: 'detached' });
    },
  },
  'Condition of the breakpoint': { begin: idle, does: dialog_opens },
  'Mode EDIT': mode('EDIT'),
  'Mode MDI': mode('MDI'),
  'Mode AUTO': mode('AUTO', 'EDIT'),
  'Mode JOG': mode('JOG'),
  'Mode REF': mode('REF'),
  'Mode TEACH': mode('TEACH'),
  'Single block on, off': lamp('Single block'),
  'Optional stop on, off': lamp('Optional stop'),
  'Block skip on, off': lamp('Block skip'),
  'Dry run on, off': lamp('Dry run'),
  'Machine lock on, off': lamp('Machine lock'),
  'Capture a point': {
    begin: (p) => p.press('TEACH').then(() => lit(p, 'TEACH')),
    does: (p) => p.page.locator('.file.current', { hasText: 'taught.tch' }).waitFor(),
  },
  'Save the program': { begin: edited, does: (p) => p.says('keys.nc is saved.') },
  'Open the library': { begin: idle, does: dialog_opens },
  'Load the text into the machine': { begin: idle, does: (p) => p.says('keys.nc is loaded.') },
  'Next problem (F8 too, while nothing moves)': { begin: mistaken, does: (p) => stands_at(p, 5) },
  'Previous problem': { begin: mistaken, does: (p) => stands_at(p, 5) },
  'Next finding of the part: line, instant and place': {
    begin: met,
    does: (p) => goes_to_finding(p, 1),
  },
  'Previous finding of the part': { begin: met, does: (p) => goes_to_finding(p, -1) },
  'Manual: what is wrong here, or all of it': { begin: idle, does: dialog_opens },
  'To the program': {
    begin: idle,
    does: (p) => p.until(() => document.activeElement?.classList.contains('cm-content')),
  },
  'To the picture (arrows turn, + and − zoom)': {
    begin: idle,
    does: (p) => p.until(() => document.activeElement?.id === 'picture'),
  },
  'Next tab': { begin: idle, does: (p) => tab_is(p, 'Stepping') },
  'Previous tab': { begin: idle, does: (p) => tab_is(p, 'Set-up') },
  'Become the operator, or ask for it': {
    begin: async (p) => {
      await p.page.locator('header .badge').click();
      await p.page.getByRole('button', { name: 'Give control back' }).click();
      await p.page.locator('header .badge', { hasText: 'No operator' }).waitFor();
    },
    does: (p) => p.operates(),
  },
  'This list': { begin: idle, does: dialog_opens },
};

/** Those that belong to a text while one is written; elsewhere they act. */
const OUTSIDE = {
  'Jog X+, while held': jogs('X', 1),
  'Jog X−, while held': jogs('X', -1),
  'Jog Y+, while held': jogs('Y', 1),
  'Jog Y−, while held': jogs('Y', -1),
  'Jog Z+, while held': jogs('Z', 1),
  'Jog Z−, while held': jogs('Z', -1),
  'Isometric view': { begin: turned, does: looks_otherwise },
  'View from above': { begin: turned, does: looks_otherwise },
  'View from the front': { begin: turned, does: looks_otherwise },
  'View from the right': { begin: turned, does: looks_otherwise },
  'Fit the path into the picture': { begin: turned, does: looks_otherwise },
  'Next colouring of the path': { begin: turned_with_path, does: looks_otherwise },
  'One second back in the run': { begin: (p) => p.go_to_instant(5), does: instant_is('0:04') },
  'One second on in the run': { begin: (p) => p.go_to_instant(5), does: instant_is('0:06') },
  'Back to now': {
    begin: (p) => p.go_to_instant(5),
    does: (p) => p.page.locator('.instant').waitFor({ state: 'detached' }),
  },
  'Take the table edit back': { begin: table_edited, does: (p) => p.variable_is('#510', '1') },
  'Do the table edit again': {
    begin: async (p) => {
      await table_edited(p);
      await p.page.locator('h1').click();
      await p.page.keyboard.press('Control+KeyZ');
      await p.variable_is('#510', '1');
    },
    does: (p) => p.variable_is('#510', '2'),
  },
};

/** So many scenarios share them: they run beside each other. */
const SHARES = 3;

export const keys = Array.from({ length: SHARES }, (_, share) => ({
  name: `every key that the panel advertises acts on the machine, in the program and outside of it (${share + 1} of ${SHARES})`,
  limit_ms: 600_000,
  async run({ open }) {
    const panel = await open();
    await panel.fresh();
    await panel.upload('beside.nc', 'O201\nM30\n'); // the last tab that is open has no ×
    await panel.open_program('beside.nc');
    await panel.upload('keys.nc', TEXT);
    await panel.open_program('keys.nc');
    const all = await advertised(panel);
    // All in the program first: then the cursor stands there already.
    for (const place of ['program', 'picture']) {
      for (const { words, keys } of all.filter((_, i) => i % SHARES === share)) {
        const known = KEYS[words] ?? OUTSIDE[words];
        assert.ok(known, `the test does not know what "${words}" does`);
        if (place === 'program' && !KEYS[words]) continue;
        for (const key of keys) {
          if (key === '?' && place === 'program') continue; // a letter of the text
          await prepare(panel);
          await known.begin(panel);
          await stand(panel, place);
          const before = await panel.told_line();
          const press = () => panel.page.keyboard.press(key);
          await (known.held ? known.held(panel, key) : press());
          const failed = (reason) => {
            throw new Error(`${words} (${key}) in the ${place}: ${reason.stack}`);
          };
          panel.line_before = before;
          await known.does(panel, press).catch(failed);
          await panel.page.keyboard.press('Escape');
          if (![edited, mistaken].includes(known.begin)) await text_is(panel, TEXT).catch(failed);
        }
      }
    }
  },
}));

async function idle() {}
async function running(p) {
  await p.press('Cycle start');
  await p.has_status('RUNNING');
}
async function stepped(p) {
  await p.press('Over');
  await p.has_status('STEP');
}
async function stepped_twice(p) {
  await stepped(p);
  const before = await p.told_line();
  await p.press('Over');
  p.line_before = before;
  await told(p, (line, first) => line > first);
  await p.has_status('STEP');
}
async function mistaken(p) {
  await p.go_to_line(5);
  await p.page.keyboard.press('End');
  await p.page.keyboard.type('5.5');
  await p.page.locator('.cm-lintRange-error').first().waitFor();
}
/** Which of the findings stands out, from 0; -1: none. */
const finding_now = (p) =>
  p.page
    .locator('#dock-problems tbody tr')
    .evaluateAll((rows) => rows.findIndex((row) => row.classList.contains('here')));
async function met(p) {
  await p.has_part();
  await p.tab('Problems');
  await p.page.locator('#dock-problems tbody tr').nth(3).waitFor();
  p.finding_before = await finding_now(p);
}
/** The next one or the one before, around the end: line, instant and place. */
async function goes_to_finding(p, way) {
  const rows = p.page.locator('#dock-problems tbody tr');
  const count = await rows.count();
  const before = p.finding_before < 0 && way < 0 ? count : p.finding_before;
  const wanted = (before + way + count) % count;
  await p.page.locator(`#dock-problems tbody tr:nth-child(${wanted + 1}).here`).waitFor();
  const words = await rows.nth(wanted).innerText();
  await stands_at(p, Number(await rows.nth(wanted).locator('.line').innerText()));
  const [minutes, seconds] = /(\d+):(\d+\.\d)/.exec(words).slice(1).map(Number);
  await p.until(
    (time_s) =>
      Math.abs(Number(document.querySelector('#picture').dataset.partTime) - time_s) < 0.2,
    60 * minutes + seconds,
  );
}
function stands_at(p, line) {
  return p.page
    .locator('.program footer')
    .filter({ hasText: new RegExp(`line ${line}$`) })
    .waitFor();
}
async function normal_feed(p) {
  await p.page.getByTitle('Feed override: back to 100 %').click();
  await feed_is(p, '100');
}
async function edited(p) {
  await p.go_to_line(2);
  await p.page.keyboard.press('End');
  await p.page.keyboard.type(' (E)');
  await p.page.locator('.file.current .dirty').waitFor();
}
function feed_is(p, wanted) {
  return p.until(
    (value) => document.querySelector('input[aria-label="Feed override"]')?.value === value,
    wanted,
  );
}
async function told(p, holds) {
  const late = Date.now() + 20_000;
  let line = await p.told_line();
  while (!holds(line, p.line_before) && Date.now() < late) {
    await p.page.waitForTimeout(50);
    line = await p.told_line();
  }
  assert.ok(holds(line, p.line_before), `line ${line} behind line ${p.line_before}`);
}
function lit(p, name) {
  return p.page.locator('.key.on', { hasText: name }).waitFor();
}
function mode(name, from = 'AUTO') {
  return {
    begin: (p) => p.press(from).then(() => lit(p, from)),
    does: (p) => lit(p, name),
  };
}
function lamp(name) {
  return {
    begin: idle,
    does: async (p, press) => {
      await lit(p, name);
      await press();
      await p.page.locator('.key.on', { hasText: name }).waitFor({ state: 'detached' });
    },
  };
}
async function dialog_opens(p) {
  await p.page.getByRole('dialog').first().waitFor();
}
function tab_is(p, name) {
  return p.page.locator('.dock [role="tab"][aria-selected="true"]', { hasText: name }).waitFor();
}
/** By hand, so that no view of the keys is that one. */
async function turned(p) {
  const box = await p.page.locator('#picture').boundingBox();
  await p.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await p.page.mouse.down();
  await p.page.mouse.move(box.x + box.width / 2 + 90, box.y + box.height / 2 + 40, { steps: 4 });
  await p.page.mouse.up();
  await p.page.mouse.move(5, 5);
  p.picture_before = await still_picture(p);
}
/** The part may lie over the path. */
async function turned_with_path(p) {
  await p.shows('Path over the part', true);
  await turned(p);
}
async function still_picture(p) {
  let before;
  let now = await p.page.locator('#picture').screenshot();
  do {
    before = now;
    await p.page.waitForTimeout(150);
    now = await p.page.locator('#picture').screenshot();
  } while (!now.equals(before));
  return now;
}
async function looks_otherwise(p) {
  const late = Date.now() + 20_000;
  while ((await p.page.locator('#picture').screenshot()).equals(p.picture_before)) {
    assert.ok(Date.now() < late, 'the picture is as it was');
    await p.page.waitForTimeout(50);
  }
}
async function table_edited(p) {
  await p.tab('Variables');
  await p.set_variable('#510', '1');
  await p.variable_is('#510', '1');
  await p.set_variable('#510', '2');
  await p.variable_is('#510', '2');
}
function instant_is(time) {
  return (p) => p.page.locator('.instant', { hasText: time }).waitFor();
}
function jogs(axis, way) {
  return {
    async begin(p) {
      await p.press('JOG');
      await lit(p, 'JOG');
      if (axis !== 'Z' || way < 0) return;
      // Z stands at the end of its travel, and goes far enough from it that no late key is there again.
      await p.page.locator('h1').click();
      const before = await p.position('Z');
      await p.page.keyboard.down('PageDown');
      await p.until(
        (from) =>
          Number(
            [...document.querySelectorAll('aside tbody tr')]
              .find((row) => row.querySelector('th').textContent === 'Z')
              .querySelector('.big')
              .textContent.replace('\u2212', '-'),
          ) <
          from - 15,
        before,
      );
      await p.page.keyboard.up('PageDown');
      await p.has_status('IDLE', 'END', 'STOPPED');
    },
    held: async (p, key) => {
      const before = await p.position(axis);
      await p.page.keyboard.down(key);
      const late = Date.now() + 20_000;
      let seen = before;
      while (!(way * (seen - before) > 0.05) && Date.now() < late) {
        await p.page.waitForTimeout(30);
        seen = await p.position(axis);
      }
      await p.page.keyboard.up(key);
      assert.ok(way * (seen - before) > 0.05, `${axis} went from ${before} to ${seen}`);
    },
    does: (p) => p.has_status('IDLE', 'END', 'STOPPED'),
  };
}

/** As the dialog of the keyboard has them; Playwright calls a few of them otherwise. */
async function advertised(panel) {
  await panel.page.locator('h1').click();
  await panel.page.keyboard.press('?');
  const dialog = panel.page.getByRole('dialog', { name: 'Keyboard' });
  await dialog.waitFor();
  const rows = await dialog.locator('dl > div').evaluateAll((all) =>
    all.map((row) => ({
      words: row.querySelector('dt').textContent.trim(),
      keys: [...row.querySelectorAll('kbd')].map((key) => key.textContent),
    })),
  );
  await panel.page.keyboard.press('Escape');
  await dialog.waitFor({ state: 'detached' });
  const NAMES = {
    '↑': 'ArrowUp',
    '↓': 'ArrowDown',
    '←': 'ArrowLeft',
    '→': 'ArrowRight',
    'Page Up': 'PageUp',
    'Page Down': 'PageDown',
    '⌫': 'Backspace',
    Ctrl: 'Control',
  };
  assert.ok(rows.length > 40, `${rows.length} keys are advertised`);
  return rows.map(({ words, keys }) => ({
    words,
    keys: keys.map((key) =>
      key
        .split('+')
        .map((part) => NAMES[part] ?? (/^[A-Z]$/.test(part) ? `Key${part}` : part))
        .join('+'),
    ),
  }));
}

/** What of the page a key may have changed, all of it seen at once. */
const AS_IT_STANDS = () => {
  const has = (selector, words) =>
    [...document.querySelectorAll(selector)].some((e) => e.innerText.includes(words));
  return {
    is_operated: document.querySelector('header .badge.mine') !== null,
    status: document.querySelector('header .status')?.textContent?.trim(),
    is_auto: has('.key.on', 'AUTO'),
    is_now: has('.slider button[aria-pressed="true"]', 'Now'),
    has_variables: has('.dock [role="tab"][aria-selected="true"]', 'Variables'),
    is_shown: has('.file.current', 'keys.nc'),
    text: [...document.querySelectorAll('.cm-line')]
      .map((line) => line.innerText.replace(/\n$/, ''))
      .join('\n')
      .trimEnd(),
    line: Number(/line (\d+)$/.exec(document.querySelector('.program footer')?.innerText)?.[1]),
    is_written_in: document.activeElement?.classList.contains('cm-content'),
    is_in_nothing: document.activeElement === document.body,
  };
};

/** The machine at rest in AUTO with the program as it was, whatever the last key did. */
async function prepare(panel) {
  await panel.page.keyboard.press('Escape');
  const left = await panel.page.evaluate(AS_IT_STANDS);
  if (!left.is_operated) await panel.operates();
  if (left.status !== 'IDLE') {
    await panel.press('Reset');
    await panel.has_status('IDLE');
  }
  if (!left.is_auto) {
    await panel.press('AUTO');
    await lit(panel, 'AUTO');
  }
  const now = panel.page.locator('.slider').getByRole('button', { name: 'Now', exact: true });
  if (!left.is_now) await now.click();
  if (!left.has_variables) await panel.tab('Variables');
  if (!left.is_shown || left.text !== TEXT.trimEnd()) {
    await drop_edits(panel);
    await panel.upload('keys.nc', TEXT);
    await panel.open_program('keys.nc');
  }
  await panel.has_path(4);
}

/** What a key before has edited goes by the × of its tab, so that nothing of it is offered again. */
async function drop_edits(panel) {
  const tab = panel.page.locator('li.file', { hasText: 'keys.nc' });
  if (!(await tab.count())) return;
  const is_edited = await tab.locator('.dirty').count();
  await panel.page.getByRole('button', { name: 'Close: keys.nc' }).click();
  if (is_edited) await panel.page.getByRole('button', { name: 'Drop the edits' }).click();
  await tab.waitFor({ state: 'detached' });
}

/** The cursor in line 4, and the keyboard in the text or in nothing. */
async function stand(panel, place) {
  const { line, is_written_in, is_in_nothing } = await panel.page.evaluate(AS_IT_STANDS);
  if (line !== 4 || (place === 'program' && !is_written_in)) await panel.go_to_line(4);
  if (place === 'program' || (line === 4 && is_in_nothing)) return;
  await panel.page.locator('h1').click();
  await panel.page.evaluate(() => document.activeElement?.blur());
}

async function text_is(panel, wanted) {
  const { is_shown, text } = await panel.page.evaluate(AS_IT_STANDS);
  if (is_shown) assert.equal(text, wanted.trimEnd(), 'the text of the program');
}
