// What helps a hand in the contour editor: the part before and behind the edits, the loupe, and what it snaps to.
import assert from 'node:assert/strict';
import {
  DESK,
  PHONE,
  button,
  drag,
  edit_contour,
  editor,
  grip,
  number,
  open_features,
  row,
  set_up,
  shade_at,
  shot,
  snapped_to,
  verified,
} from '../feature_page.mjs';
import { P1, SHAPE, SHAPE_SETUP } from '../feature_programs.mjs';
import { AXE, findings } from './accessibility.mjs';

const views = (panel, name) =>
  editor(panel)
    .getByRole('radiogroup', { name: 'What the plan shows' })
    .getByRole('radio', { name, exact: true });
const slider = (panel) => editor(panel).getByRole('slider', { name: 'Before and after' });

async function outwards(panel, by) {
  await number(panel, 'Outwards by').fill(by);
  await number(panel, 'Outwards by').press('Enter');
  await verified(panel);
}

export const contour_tools = [
  {
    name: 'features: the part before and after an edit is compared with a slider, and what differs is coloured',
    async run({ open, shots }) {
      const panel = await open(DESK);
      await open_features(panel, 'compare.nc', P1);
      await edit_contour(panel, 'F1');
      await grip(panel, 1).click();
      await outwards(panel, '4');
      await views(panel, 'Before / after').click();
      const [before, after] = [
        await shade_at(panel, 'before', [52, 24]),
        await shade_at(panel, 'after', [52, 24]),
      ];
      assert.notEqual(before, after, 'there it is cut now');
      assert.equal(after, await shade_at(panel, 'after', [30, 24]), 'as deep as the pocket');
      assert.equal(before, await shade_at(panel, 'before', [60, 30]), 'as high as the stock');
      const split = () => editor(panel).locator('#after-side rect').getAttribute('x');
      const middle = Number(await split());
      await slider(panel).focus();
      await panel.page.keyboard.press('Home');
      assert.equal(Number(await split()), 0, 'all of it is after');
      for (let i = 0; i < 50; i++) await panel.page.keyboard.press('ArrowRight');
      assert.equal(Number(await split()), middle);
      await slider(panel).evaluate((input) => {
        input.value = '28';
        input.dispatchEvent(new Event('input', { bubbles: true }));
      });
      await shot(panel, shots, 'features-before-after');
      await views(panel, 'Difference').click();
      const added = editor(panel).locator('[data-part-picture="difference"] path.added').first();
      assert.ok((await added.getAttribute('d')).length > 20);
      await shot(panel, shots, 'features-difference');
      await panel.page.evaluate(AXE);
      assert.deepEqual(await findings(panel, 'the part before and after'), []);
      await views(panel, 'Contour').click();
      await grip(panel, 1).waitFor();
    },
  },
  {
    name: 'features: the half section of a lathe is compared before and after',
    async run({ open }) {
      const panel = await open({ ...DESK, machine: 'lathe' });
      await open_features(panel, 'compare-turned.nc', SHAPE);
      await set_up(panel, SHAPE_SETUP);
      await row(panel, 'F1').filter({ hasText: 'turned contour' }).waitFor();
      await edit_contour(panel, 'F1');
      await grip(panel, 2).click();
      await outwards(panel, '2');
      await views(panel, 'Before / after').click();
      // Z-40, between 15 and 17 mm from the axis.
      assert.equal(await shade_at(panel, 'before', [-40, 16]), 'gone');
      assert.notEqual(await shade_at(panel, 'after', [-40, 16]), 'gone');
    },
  },
  {
    name: 'features: a side snaps to a same length and to a tangent, which is drawn and told, also with the key S',
    async run({ open, shots }) {
      const panel = await open(DESK);
      await open_features(panel, 'snap.nc', P1);
      await edit_contour(panel, 'F1');
      for (const kind of ['grid', 'ends', 'middles', '0 / 45 / 90°', 'original'])
        await editor(panel).getByRole('checkbox', { name: kind, exact: true }).uncheck();
      // The pocket is 40 × 28: a square where the short side comes in by 12.
      await drag(panel, grip(panel, 1), [-11.6, 0.3], { lets_go: false });
      await snapped_to(panel).filter({ hasText: 'As long as Line 1: 28.000 mm' }).waitFor();
      await editor(panel).locator('.mark[data-snap="length"] path').waitFor({ state: 'attached' });
      await shot_while_held(panel, shots, 'features-snap');
      await panel.page.mouse.up();
      await verified(panel);
      assert.equal(await number(panel, 'Length').inputValue(), '28');
      await grip(panel, 0).click();
      assert.equal(await number(panel, 'Length').inputValue(), '28');
      // A fillet, and a corner that goes on from it without a bend, by keys alone.
      await grip(panel, 2, 'start').click();
      await panel.page.keyboard.press('f');
      await editor(panel).getByRole('textbox', { name: 'Fillet: R' }).fill('6');
      await panel.page.keyboard.press('Enter');
      await verified(panel);
      await grip(panel, 3, 'start').click();
      await panel.page.keyboard.press('Shift+ArrowUp');
      await panel.page.keyboard.press('Shift+ArrowUp');
      assert.equal(await number(panel, 'Y').inputValue(), '40');
      await panel.page.keyboard.press('s');
      await snapped_to(panel)
        .filter({ hasText: /Tangent to Arc \d|As long as/ })
        .waitFor();
      for (let i = 0; i < 6; i++) {
        if ((await snapped_to(panel).innerText()).startsWith('Tangent')) break;
        await panel.page.keyboard.press('s');
      }
      await snapped_to(panel).filter({ hasText: 'Tangent to Arc' }).waitFor();
      assert.equal(await number(panel, 'Y').inputValue(), '38');
      await editor(panel).locator('.mark[data-snap="tangent"]').waitFor();
      // One step, whatever was tried on the way.
      await panel.page.keyboard.press('Control+z');
      await panel.until(() => document.querySelector('dialog [aria-label="Y"]')?.value === '40');
      assert.equal(await snapped_to(panel).innerText(), '');
    },
  },
  {
    name: 'features: under a finger a loupe shows what it covers, and the part is compared on a phone (360 px)',
    async run({ open, shots }) {
      const panel = await open(PHONE);
      await open_features(panel, 'loupe.nc', P1);
      await row(panel, 'F1').tap();
      await button(row(panel, 'F1'), 'Edit contour').tap();
      await editor(panel).waitFor();
      const box = await grip(panel, 1).boundingBox();
      const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      const touch = await panel.context.newCDPSession(panel.page);
      const send = (type, ...points) =>
        touch.send('Input.dispatchTouchEvent', {
          type,
          touchPoints: points.map(([x, y]) => ({ x, y })),
        });
      const loupe = editor(panel).locator('.loupe');
      assert.equal(await loupe.count(), 0);
      await send('touchStart', [x, y]);
      await loupe.waitFor();
      for (let i = 1; i <= 5; i++) await send('touchMove', [x + 3 * i, y]);
      await panel.until(() => document.querySelector('.loupe path.line')?.getAttribute('d'));
      const place = await loupe.boundingBox();
      assert.ok(place.x + place.width < x, 'it is not where the finger is');
      await shot_while_held(panel, shots, 'features-loupe');
      await send('touchEnd');
      await loupe.waitFor({ state: 'detached' });
      await verified(panel);
      await views(panel, 'Before / after').tap();
      await slider(panel).waitFor();
      await panel.page.evaluate(AXE);
      assert.deepEqual(await findings(panel, 'before and after on a phone'), []);
      const wide = await panel.page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= PHONE.width, `the page is ${wide} px wide`);
      await shot(panel, shots, 'features-compare-phone');
    },
  },
];

/** Without moving the pointer, which holds something. */
async function shot_while_held(panel, shots, name) {
  if (!shots) return;
  const { width, height } = panel.page.viewportSize();
  await panel.page.waitForTimeout(700);
  await panel.page.screenshot({ path: `${shots}/${name}-${width}x${height}.png` });
}
