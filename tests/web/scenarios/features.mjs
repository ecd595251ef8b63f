// What a program machines: the tree, the contour editor, what an edit would change, applied and taken back.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { FRAMED, LOOPED, P1, SHAPE, SHAPE_SETUP } from '../programs.mjs';
import { AXE, findings } from './accessibility.mjs';

const DESK = { width: 1440, height: 900 };
const PHONE = { width: 360, height: 800, touch: true };

const dock = (panel) => panel.page.locator('#dock-features');
const row = (panel, id) => dock(panel).locator(`[data-node="${id}"]`);
const editor = (panel) => panel.page.locator('dialog.contour');
const button = (where, name) => where.getByRole('button', { name, exact: true });
/** Where an element is gripped: its middle, or its corner. */
const grip = (panel, id, part = 'element') =>
  editor(panel)
    .locator(`[data-element="${id}"][data-part="${part}"]`)
    .locator(part === 'element' ? '.grip' : '.dot');
const number = (panel, name) => editor(panel).getByRole('textbox', { name, exact: true });
const line_with = (panel, text) => panel.page.locator('.cm-line', { hasText: text }).first();

async function shot(panel, shots, name) {
  if (!shots) return;
  const { width, height } = panel.page.viewportSize();
  await panel.page.mouse.move(2, 2);
  await panel.page.waitForTimeout(1500);
  await panel.page.screenshot({ path: join(shots, `${name}-${width}x${height}.png`) });
}

/** Opened as a person does, and seen by somebody who looks at features. */
async function open_features(panel, name, text) {
  await panel.operates();
  await panel.pane('More');
  await panel.fresh();
  await panel.pane('Program');
  await panel.run_text(name, text);
  await panel.has_path();
  await panel.pane('More');
  await panel.tab('Features');
  await row(panel, 'F1').waitFor();
}

/** By the text of the set-up, as a person may write it. */
async function set_up(panel, toml) {
  await panel.tab('Set-up');
  const dock = panel.page.locator('#dock-setup');
  await button(dock, 'Text').click();
  const text = dock.getByRole('textbox', { name: 'Set-up' });
  await text.fill(toml);
  await text.press('Tab');
  // The one of an earlier run of the tests may be the same.
  if (await button(dock, 'Set up').isEnabled()) {
    await button(dock, 'Set up').click();
    await panel.says('is kept');
  }
  await panel.tab('Features');
}

async function edit_contour(panel, id) {
  await row(panel, id).dblclick();
  await editor(panel).waitFor();
}

/** An element or corner, by so many mm of the plan; the hand lets go at the end. */
async function drag(panel, from, [dx, dy], { lets_go = true } = {}) {
  const scale = Number(await editor(panel).locator('svg[data-scale]').getAttribute('data-scale'));
  const box = await from.boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const { mouse } = panel.page;
  await mouse.move(x, y);
  await mouse.down();
  await mouse.move(x + 0.6 * scale * dx, y - 0.6 * scale * dy, { steps: 3 });
  await mouse.move(x + scale * dx, y - scale * dy, { steps: 3 });
  if (lets_go) await mouse.up();
}

const verified = (panel, where = editor(panel)) =>
  where.getByText('verified', { exact: true }).waitFor();
/** Lines that go and come, with their numbers. */
const diff_of = (where) =>
  where.locator('.diff').evaluate((diff) =>
    [...diff.querySelectorAll('.removed, .added')].map((row) => {
      const [line, sign, text] = ['.line', '.sign', '.text'].map(
        (part) => row.querySelector(part).textContent,
      );
      return `${line} ${sign[0]}${text}`;
    }),
  );
const selected = (panel) => dock(panel).locator('[aria-selected="true"]').getAttribute('data-node');

async function apply(panel, where = editor(panel)) {
  const key = where.getByRole('button', { name: 'Apply', exact: true });
  await panel.until(() => {
    const keys = [...document.querySelectorAll('.outcome .keys .main')];
    return keys.some((one) => !one.disabled);
  });
  await key.click();
}

export const features = [
  {
    name: 'features: tree, text and picture show the same part',
    async run({ open, shots }) {
      const panel = await open(DESK);
      await open_features(panel, 'p1.nc', P1);
      // From the tree.
      await row(panel, 'F1').click();
      await line_with(panel, 'N40 G00 X20. Y20.')
        .and(panel.page.locator('.cm-of-feature'))
        .waitFor();
      await panel.until(() => document.querySelector('#picture').dataset.region === '1');
      assert.match(
        await row(panel, 'F1').innerText(),
        /pocket\s+40 × 28\s+Z0…-4[^]*\? stock assumed/,
      );
      await shot(panel, shots, 'features-tree');
      await row(panel, 'P1').click();
      await panel.until(() => document.querySelector('#picture').dataset.region === '2');
      // From the text.
      await panel.go_to_line(49);
      await panel.until(() => document.querySelector('[data-node="H1"]')?.ariaSelected === 'true');
      // From the picture: whatever of the part is clicked is what the tree shows.
      await panel.has_part();
      await panel.page.locator('#picture').focus();
      await panel.page.keyboard.press('1');
      await panel.page.keyboard.press('f');
      await panel.page.waitForTimeout(800);
      const box = await panel.page.locator('#picture').boundingBox();
      const seen = new Set();
      for (const [u, v] of [0.3, 0.4, 0.6, 0.7].flatMap((x) =>
        [0.4, 0.5, 0.62].map((y) => [x, y]),
      )) {
        await panel.page.mouse.click(box.x + u * box.width, box.y + v * box.height);
        await panel.page.waitForTimeout(150);
        seen.add((await selected(panel)).split('/')[0]);
      }
      assert.ok(seen.has('F1') && seen.has('F2'), [...seen].join(' '));
      // Folded and unfolded with the keyboard.
      await row(panel, 'F1').click();
      await panel.page.keyboard.press('ArrowLeft');
      await row(panel, 'F1/1').waitFor({ state: 'detached' });
      await panel.page.keyboard.press('ArrowRight');
      await panel.page.keyboard.press('ArrowDown');
      assert.equal(await selected(panel), 'F1/1');
      // By the rows alone nothing has a hole in a pattern.
      await dock(panel).getByRole('radio', { name: 'Literal' }).click();
      await row(panel, 'L2').filter({ hasText: 'side milling' }).waitFor();
    },
  },
  {
    name: 'features: a pocket is made 2 mm longer in five actions',
    async run({ open, shots }) {
      const panel = await open(DESK);
      await open_features(panel, 'longer.nc', P1);
      await panel.tab('Variables');
      // From the opened program: 1. the tab …
      await panel.tab('Features');
      // 2. the pocket, twice …
      await row(panel, 'F1').dblclick();
      await editor(panel).waitFor();
      // 3. its long side …
      await grip(panel, 0).click();
      // 4. its length, and Enter …
      await number(panel, 'Length').fill('40+2');
      await number(panel, 'Length').press('Enter');
      await verified(panel);
      assert.deepEqual(await diff_of(editor(panel)), [
        '10 −N60 G01 X40. F300.',
        '10 +N60 G01 X42. F300.',
        '15 −N110 X45.',
        '15 +N110 X47.',
        '22 −N180 X40. F300.',
        '22 +N180 X42. F300.',
        '27 −N230 X45.',
        '27 +N230 X47.',
      ]);
      await shot(panel, shots, 'features-diff');
      // 5. Apply.
      await apply(panel);
      await editor(panel).waitFor({ state: 'detached' });
      await panel.says('longer.nc is edited');
      await row(panel, 'F1').filter({ hasText: '42 × 28' }).waitFor();
      const edited = P1.replace('X40. F300', 'X42. F300').replace('X45.', 'X47.');
      const twice = edited.replace('N180 X40.', 'N180 X42.').replace('N230 X45.', 'N230 X47.');
      assert.equal((await panel.library_bytes('longer.nc')).toString(), twice);
      await line_with(panel, 'N60 G01 X42. F300.').waitFor();
      assert.equal(await panel.page.locator('.file.current .dirty').count(), 0);
      // Taken back to the byte.
      await button(dock(panel), 'Undo last edit').click();
      await panel.says('longer.nc is as it was before');
      await row(panel, 'F1').filter({ hasText: '40 × 28' }).waitFor();
      assert.equal((await panel.library_bytes('longer.nc')).toString(), P1);
      await line_with(panel, 'N60 G01 X40. F300.').waitFor();
    },
  },
  {
    name: 'features: a side is dragged, and what it changes is seen before the hand lets go',
    async run({ open, shots }) {
      const panel = await open(DESK);
      await open_features(panel, 'drag.nc', P1);
      await edit_contour(panel, 'F1/2');
      await drag(panel, grip(panel, 1), [4, 0], { lets_go: false });
      await editor(panel).locator('.label', { hasText: '28' }).waitFor();
      await panel.until(
        () => document.querySelector('dialog path.added')?.getAttribute('d').length > 20,
      );
      assert.equal(await editor(panel).locator('path.removed').getAttribute('d'), '');
      await shot(panel, null);
      await panel.page.mouse.up();
      await verified(panel);
      assert.equal(await number(panel, 'Start X').inputValue(), '54');
      // Layer 1 has to follow: the tool comes from above.
      assert.equal((await diff_of(editor(panel))).length, 8);
      await drag(panel, grip(panel, 2), [0, -6]);
      await panel.until(
        () => document.querySelector('dialog path.removed')?.getAttribute('d').length > 20,
      );
      await verified(panel);
      await shot(panel, shots, 'features-editor');
      // Steps are taken back and done again.
      await panel.page.keyboard.press('Control+z');
      await panel.until(
        () => document.querySelector('dialog path.removed')?.getAttribute('d') === '',
      );
      await panel.page.keyboard.press('Control+z');
      await editor(panel).locator('.diff').waitFor({ state: 'detached' });
      await panel.page.keyboard.press('Control+y');
      await editor(panel).locator('.diff').waitFor();
      // What would be lost is asked about.
      await button(editor(panel), 'Discard').click();
      await panel.page.locator('dialog.question').getByRole('button', { name: 'Discard' }).click();
      await editor(panel).waitFor({ state: 'detached' });
      assert.equal((await panel.library_bytes('drag.nc')).toString(), P1);
    },
  },
  {
    name: 'features: a contour that crosses itself stays, is red where it does, and cannot be applied',
    async run({ open, shots }) {
      const panel = await open(DESK);
      await open_features(panel, 'crossing.nc', P1);
      await edit_contour(panel, 'F1');
      await drag(panel, grip(panel, 2, 'start'), [-20, -34]);
      await editor(panel).getByRole('alert').filter({ hasText: 'EDIT_CROSSES_ITSELF' }).waitFor();
      await editor(panel).locator('.fails').waitFor();
      await shot(panel, shots, 'features-invalid');
      assert.ok(await button(editor(panel), 'Apply').isDisabled());
      await panel.page.keyboard.press('Control+z');
      await editor(panel).getByRole('alert').waitFor({ state: 'detached' });
    },
  },
  {
    name: 'features: a contour in a loop is refused, and edited when the loop is written out',
    async run({ open, shots }) {
      const panel = await open(DESK);
      await open_features(panel, 'looped.nc', LOOPED);
      await edit_contour(panel, 'F1');
      await grip(panel, 1).click();
      await number(panel, 'Outwards by').fill('2');
      await number(panel, 'Outwards by').press('Enter');
      await editor(panel).getByRole('alert').filter({ hasText: 'EDIT_IN_LOOP' }).waitFor();
      await shot(panel, shots, 'features-refused');
      await button(editor(panel), 'Write the loop out, then edit').click();
      await verified(panel);
      const diff = await diff_of(editor(panel));
      assert.ok(
        diff.some((line) => line.includes('−WHILE')),
        diff.join('\n'),
      );
      await apply(panel);
      await panel.says('looped.nc is edited');
      assert.ok(!(await panel.library_bytes('looped.nc')).toString().includes('WHILE'));
    },
  },
  {
    name: 'features: numbers that a call hands over are edited in the call',
    async run({ open }) {
      const panel = await open(DESK);
      await open_features(panel, 'framed.nc', FRAMED);
      await edit_contour(panel, 'F1');
      await grip(panel, 1).click();
      await number(panel, 'Outwards by').fill('-2');
      await number(panel, 'Outwards by').press('Enter');
      await editor(panel).getByRole('alert').filter({ hasText: 'EDIT_EXPRESSION' }).waitFor();
      const field = editor(panel).getByRole('textbox', { name: 'Argument C1 A' });
      await field.fill('28');
      await field.press('Enter');
      await verified(panel);
      assert.deepEqual(await diff_of(editor(panel)), [
        '8 −G65 P9400 A30. B18.',
        '8 +G65 P9400 A28. B18.',
      ]);
    },
  },
  {
    name: 'features: depth, place and holes are edited from the tree',
    async run({ open, shots }) {
      const panel = await open(DESK);
      await open_features(panel, 'holes.nc', P1);
      const form = (name) => dock(panel).getByRole('form', { name, exact: true });
      await row(panel, 'H1').click();
      await form('Place of the hole').getByRole('textbox').first().fill('24/2');
      await form('Place of the hole').getByRole('button').click();
      await verified(panel, dock(panel));
      assert.deepEqual(await diff_of(dock(panel)), [
        '48 −N440 G00 X10. Y50.',
        '48 +N440 G00 X12. Y50.',
      ]);
      await shot(panel, shots, 'features-hole');
      const saved = panel.page.waitForEvent('download');
      await button(dock(panel), 'Save edits').click();
      assert.equal((await saved).suggestedFilename(), 'holes-edits.json');
      await row(panel, 'F2').click();
      await form('Depth').getByRole('textbox').fill('-5');
      await form('Depth').getByRole('button').click();
      await dock(panel).locator('.diff', { hasText: 'Z-5.' }).waitFor();
      await row(panel, 'H2').click();
      await button(dock(panel), 'Delete').click();
      await dock(panel).locator('.diff', { hasText: 'N470 X30. Y50.' }).waitFor();
      await apply(panel, dock(panel));
      await panel.says('holes.nc is edited');
      await row(panel, 'H2').waitFor({ state: 'detached' });
    },
  },
  {
    name: 'features: a contour is edited with the keyboard alone',
    async run({ open }) {
      const panel = await open(DESK);
      await open_features(panel, 'keys.nc', P1);
      const { keyboard } = panel.page;
      await row(panel, 'F1').click();
      await keyboard.press('Enter');
      await editor(panel).waitFor();
      const at = () => panel.page.evaluate(() => document.activeElement?.ariaLabel ?? '');
      for (let i = 0; i < 30 && !(await at()).startsWith('Line 1'); i++)
        await keyboard.press('Tab');
      assert.match(await at(), /^Line 1: 28.000 mm/);
      await keyboard.press('Shift+ArrowRight');
      await keyboard.press('ArrowRight');
      await keyboard.press('Alt+ArrowRight');
      assert.equal(await number(panel, 'Start X').inputValue(), '51.11');
      await keyboard.press('Control+z');
      await panel.until(
        () => document.querySelector('dialog [aria-label="Start X"]')?.value === '50',
      );
      for (let i = 0; i < 30 && (await at()) !== 'Corner 2'; i++) await keyboard.press('Tab');
      await keyboard.press('f');
      await editor(panel).getByRole('textbox', { name: 'Fillet: R' }).waitFor();
      await keyboard.type('6');
      await keyboard.press('Enter');
      await verified(panel);
      await editor(panel)
        .getByRole('button', { name: /^Arc \d+: 9.425 mm/ })
        .waitFor();
      await keyboard.press('Escape');
      await keyboard.press('Escape');
      await panel.page.locator('dialog.question').waitFor();
      await keyboard.press('Escape');
      await panel.page.locator('dialog.question').waitFor({ state: 'detached' });
      await editor(panel).waitFor();
    },
  },
  {
    name: 'features: the right button has fillets, chamfers and islands; a gap is closed by a line',
    async run({ open }) {
      const panel = await open(DESK);
      await open_features(panel, 'menu.nc', P1);
      await edit_contour(panel, 'F1');
      const item = (name) => editor(panel).getByRole('menuitem', { name, exact: true });
      await grip(panel, 0, 'start').click({ button: 'right' });
      await item('Chamfer').click();
      await button(editor(panel), 'Do it').click();
      await verified(panel);
      await editor(panel)
        .getByRole('button', { name: /^Line 4: 2.828 mm/ })
        .waitFor();
      await grip(panel, 2).click({ button: 'right' });
      await item('Delete').click();
      await editor(panel).getByRole('alert').filter({ hasText: 'EDIT_OPEN' }).waitFor();
      await button(editor(panel), 'Line L').click();
      await button(editor(panel), 'Do it').click();
      await verified(panel);
    },
  },
  {
    name: 'features: the half section of a lathe is edited in Z and diameters',
    async run({ open, shots }) {
      const panel = await open({ ...DESK, machine: 'lathe' });
      await open_features(panel, 'turned.nc', SHAPE);
      await set_up(panel, SHAPE_SETUP);
      await row(panel, 'F1').filter({ hasText: 'turned contour' }).click();
      await shot(panel, shots, 'features-lathe-tree');
      await edit_contour(panel, 'F1');
      await grip(panel, 2).click();
      assert.equal(await number(panel, 'Start X Ø').inputValue(), '30');
      await number(panel, 'Outwards by').fill('4/2');
      await number(panel, 'Outwards by').press('Enter');
      await verified(panel);
      assert.equal(await number(panel, 'Start X Ø').inputValue(), '34');
      const diff = await diff_of(editor(panel));
      assert.ok(
        diff.some((line) => line.endsWith('+X34. Z-34.')),
        diff.join('\n'),
      );
      await shot(panel, shots, 'features-lathe');
      await apply(panel);
      await panel.says('turned.nc is edited');
    },
  },
  {
    name: 'features: on a phone a pocket is found, its side dragged with a finger and applied (360 px)',
    async run({ open, shots }) {
      const panel = await open(PHONE);
      await open_features(panel, 'phone.nc', P1);
      await row(panel, 'F1').tap();
      await shot(panel, shots, 'features-phone-tree');
      await button(row(panel, 'F1'), 'Edit contour').tap();
      await editor(panel).waitFor();
      await grip(panel, 1).tap({ force: true });
      await number(panel, 'Outwards by').fill('2');
      await number(panel, 'Outwards by').press('Enter');
      await verified(panel);
      await shot(panel, shots, 'features-phone');
      const wide = await panel.page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= PHONE.width, `the page is ${wide} px wide`);
      await panel.page.evaluate(AXE);
      assert.deepEqual(await findings(panel, 'contour editor on a phone'), []);
      await apply(panel);
      await panel.says('phone.nc is edited');
    },
  },
  {
    name: 'features: axe finds nothing in tab and contour editor',
    async run({ open }) {
      const panel = await open(DESK);
      await open_features(panel, 'axe-features.nc', P1);
      await panel.page.evaluate(AXE);
      await row(panel, 'F1').click();
      const found = await findings(panel, 'features');
      await edit_contour(panel, 'F1');
      await grip(panel, 1).click();
      await number(panel, 'Outwards by').fill('2');
      await number(panel, 'Outwards by').press('Enter');
      await verified(panel);
      found.push(...(await findings(panel, 'contour editor')));
      assert.deepEqual(found, []);
    },
  },
  {
    name: 'features: the card of a program tells what it is like, once, and leads to the features',
    async run({ open, shots }) {
      const panel = await open({ ...DESK, insight: true });
      await panel.operates();
      await panel.fresh();
      await panel.run_text('card.nc', P1);
      const card = panel.page.getByRole('region', { name: 'What this program is like' });
      await card.getByText('2 × pocket').waitFor();
      await shot(panel, shots, 'features-insight');
      const text = await card.innerText();
      for (const words of ['55 lines', 'T1', 'T2', '1 × outside profile', 'Travel used'])
        assert.ok(text.includes(words), `${words} is not in: ${text}`);
      await button(card, 'Show features').click();
      await card.waitFor({ state: 'detached' });
      await row(panel, 'F1').waitFor();
      // Not again for the same program, but for another one, until nobody wants it.
      await panel.page.locator('.program').getByRole('button', { name: 'Load' }).click();
      await panel.says('card.nc is loaded');
      assert.equal(await card.count(), 0);
      await panel.run_text('other.nc', LOOPED);
      await button(card, 'Do not show again').click();
      await panel.run_text('third.nc', P1);
      await panel.has_path();
      assert.equal(await card.count(), 0);
    },
  },
];
