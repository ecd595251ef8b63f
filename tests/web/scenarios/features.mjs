// What a program machines: the tree, edits from it, the card of a program.
import assert from 'node:assert/strict';
import {
  DESK,
  apply,
  button,
  diff_of,
  dock,
  edit_contour,
  editor,
  grip,
  line_with,
  number,
  open_features,
  row,
  selected,
  shot,
  verified,
} from '../feature_page.mjs';
import { LOOPED, P1 } from '../feature_programs.mjs';
import { AXE, findings } from './accessibility.mjs';

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
  {
    name: 'features: a page that watches has the text of an edit that is applied elsewhere, and keeps what is edited in it',
    async run({ open }) {
      const panel = await open(DESK);
      await open_features(panel, 'watched.nc', P1);
      const watcher = await panel.another_page();
      await watcher.tab('Features');
      await line_with(watcher, 'N60 G01 X40. F300.').waitFor();
      await edit_contour(panel, 'F1');
      await grip(panel, 0).click();
      await number(panel, 'Length').fill('42');
      await number(panel, 'Length').press('Enter');
      await apply(panel);
      await panel.says('watched.nc is edited');
      await line_with(watcher, 'N60 G01 X42. F300.').waitFor();
      await row(watcher, 'F1').filter({ hasText: '42 × 28' }).waitFor();
      assert.equal(await watcher.page.locator('.file.current .dirty').count(), 0);
      // What somebody has typed there stays, and the machine's text is another one.
      await watcher.go_to_line(2);
      await watcher.page.keyboard.press('End');
      await watcher.page.keyboard.type(' (MINE)');
      await watcher.page.locator('.file.current .dirty').waitFor();
      await button(dock(panel), 'Undo last edit').click();
      await panel.says('watched.nc is as it was before');
      await row(watcher, 'F1').filter({ hasText: '40 × 28' }).waitFor();
      await line_with(watcher, '(MINE)').waitFor();
      await line_with(watcher, 'N60 G01 X42. F300.').waitFor();
      await watcher.page.close();
    },
  },
];
