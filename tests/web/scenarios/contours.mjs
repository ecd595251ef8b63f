// The contour editor: hands, numbers, keys, what an edit would change, applied and taken back.
import assert from 'node:assert/strict';
import {
  DESK,
  PHONE,
  apply,
  button,
  diff_of,
  dock,
  drag,
  edit_contour,
  editor,
  grip,
  line_with,
  number,
  open_features,
  row,
  set_up,
  shot,
  verified,
} from '../feature_page.mjs';
import { FRAMED, LOOPED, P1, SHAPE, SHAPE_SETUP } from '../feature_programs.mjs';
import { AXE, findings } from './accessibility.mjs';

export const contours = [
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
];
