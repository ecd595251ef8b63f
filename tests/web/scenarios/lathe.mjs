// A lathe beside the mills: diameters, tool offsets, touching off, the speed under G96, and its picture.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { SHAFT } from '../programs.mjs';
import { AXE, findings } from './accessibility.mjs';

const NAME = 'turning';
const SIZES = [
  [1440, 900],
  [820, 1180],
];
const PHONE = { width: 390, height: 844, touch: true };

/** A page that watches a lathe, which it makes where there is none. */
export async function open_lathe(open, size = {}) {
  const panel = await open(size);
  await panel.operates();
  await panel.page.locator('header .chosen').click();
  const there = panel.page.locator('.machine', { has: panel.page.locator(`b:text-is("${NAME}")`) });
  if (await there.count()) {
    await there.click();
  } else {
    await panel.page.getByRole('button', { name: 'New machine' }).click();
    const dialog = panel.page.getByRole('dialog');
    await dialog.getByLabel('Name').fill(NAME);
    await dialog.getByRole('combobox').selectOption('lathe2');
    await dialog.getByRole('button', { name: 'Make the machine' }).click();
  }
  await panel.page.locator('header .chosen b', { hasText: new RegExp(`^${NAME}$`) }).waitFor();
  await panel.operates();
  return panel;
}

/** Where the page takes the program for another machine's, its card is not what the picture is about. */
export async function without_card(panel) {
  const close = panel.page.locator('.card[role="alert"]').getByRole('button', { name: 'Close' });
  if (await close.count()) await close.click();
}

async function mdi(panel, text) {
  await panel.press('MDI');
  await panel.tab('MDI');
  const entry = panel.page.getByRole('textbox', { name: 'Blocks to execute' });
  await entry.fill(text);
  await entry.press('Enter');
}

const cell = (panel, name) =>
  panel.page.locator('#dock-tools').getByRole('textbox', { name, exact: true });

async function set_cell(panel, name, value) {
  await cell(panel, name).fill(value);
  await cell(panel, name).press('Enter');
  await cell_is(panel, name, Number(value));
}

const cell_is = (panel, name, value) => value_is(panel, cell(panel, name), value);

/** As soon as the machine has told it. */
async function value_is(panel, field, value) {
  const late = Date.now() + 20_000;
  let seen = NaN;
  while (seen !== value && Date.now() < late) {
    seen = Number((await field.inputValue()).replace('\u2212', '-'));
    if (seen !== value) await panel.page.waitForTimeout(50);
  }
  assert.equal(seen, value, String(field));
}

async function row_of(panel, number) {
  await panel.tab('Tools');
  const dock = panel.page.locator('#dock-tools');
  if (!(await cell(panel, `T${number} Tip`).count())) {
    await dock.getByRole('textbox', { name: 'Offset', exact: true }).fill(String(number));
    await dock.getByRole('button', { name: 'Add offset' }).click();
  }
  await cell(panel, `T${number} Tip`).waitFor();
}

async function touch_off(panel, axis, value) {
  await panel.page.getByRole('textbox', { name: `Measured ${axis}` }).fill(value);
  await panel.page.getByRole('button', { name: `Set ${axis}` }).click();
}

async function offsets_of_the_shaft(panel) {
  for (const [number, radius, tip] of [
    [1, '0.8', '3'],
    [3, '0.2', '8'],
  ]) {
    await row_of(panel, number);
    await set_cell(panel, `T${number} Geometry Nose R`, radius);
    await set_cell(panel, `T${number} Tip`, tip);
  }
}

const speed = async (panel) =>
  Number((await panel.page.locator('[data-value="speed"]').innerText()).replace(/\s/g, ''));

const HALF_OF_PIXELS = 0.5;

/** How much of the canvas is drawn on, above and below its middle: how many pixels are opaque. */
const inked = (panel) =>
  panel.page.evaluate((half) => {
    const canvas = document.querySelector('#picture');
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const pen = copy.getContext('2d');
    pen.drawImage(canvas, 0, 0);
    const { data } = pen.getImageData(0, 0, copy.width, copy.height);
    const halves = [0, 0];
    for (let i = 3; i < data.length; i += 4)
      if (data[i] > 40) halves[i / 4 < half * copy.width * copy.height ? 0 : 1]++;
    return halves;
  }, HALF_OF_PIXELS);

export const lathe = [
  {
    name: 'on a lathe X is a diameter: position, jog and zero of a work system agree',
    async run({ open }) {
      const panel = await open_lathe(open);
      await panel.fresh();
      await mdi(panel, 'G00 X60. Z-5.');
      await panel.position_is('X', 60);
      await panel.position_is('Z', -5);
      const row = panel.page.locator('aside tbody tr', { hasText: 'X' }).first();
      assert.match(await row.innerText(), /Ø/, 'X says that it is a diameter');
      await panel.press('JOG');
      await panel.page.getByLabel('Step, mm').selectOption({ label: '10' });
      await panel.page.getByRole('button', { name: 'Jog X+' }).click();
      await panel.position_is('X', 70);
      await panel.tab('Offsets');
      await panel.page.getByRole('button', { name: /^X0, G54/ }).click();
      await panel.position_is('X', 0);
      const g54 = panel.page.getByRole('textbox', { name: 'G54 X', exact: true });
      await value_is(panel, g54, 70);
      await panel.page.locator('h1').click();
      await panel.page.keyboard.press('Control+z');
      await panel.position_is('X', 70);
    },
  },
  {
    name: 'offsets of a lathe are edited, picked by their picture, and taken back',
    async run({ open }) {
      const panel = await open_lathe(open);
      await panel.fresh();
      await row_of(panel, 5);
      await set_cell(panel, 'T5 Geometry XØ', '-8.5');
      await set_cell(panel, 'T5 Wear Z', '0.02');
      await set_cell(panel, 'T5 Geometry Nose R', '0.8');
      await panel.page.getByRole('radio', { name: 'Direction 2 of the tip' }).click();
      await cell_is(panel, 'T5 Tip', 2);
      await cell(panel, 'T5 Tip').fill('1.5');
      await cell(panel, 'T5 Tip').press('Enter');
      await panel.says('whole number from 0 to 9');
      await panel.page.locator('h1').click();
      await panel.page.keyboard.press('Control+z');
      await cell_is(panel, 'T5 Tip', 0);
    },
  },
  {
    name: 'a tool is touched off with a measured diameter, and its position reads it',
    async run({ open }) {
      const panel = await open_lathe(open);
      await panel.fresh();
      await mdi(panel, 'G53 X52. Z-80.');
      await panel.position_is('Z', -80);
      await panel.has_status('END', 'IDLE');
      await row_of(panel, 7);
      await panel.page.getByRole('button', { name: '7', exact: true }).click();
      await touch_off(panel, 'XØ', '38.25');
      await cell_is(panel, 'T7 Geometry XØ', 13.75);
      await touch_off(panel, 'Z', '0');
      await cell_is(panel, 'T7 Geometry Z', -80);
      await mdi(panel, 'T0707 G00 X38.25 Z0.');
      await panel.position_is('X', 38.25);
      await panel.page.getByRole('radio', { name: 'Machine' }).click();
      await panel.position_is('X', 52);
      await panel.position_is('Z', -80);
    },
  },
  {
    name: 'a shaft is roughed and threaded: the speed follows the diameter, and the picture has both halves',
    async run({ open }) {
      const panel = await open_lathe(open);
      await panel.fresh();
      await offsets_of_the_shaft(panel);
      await panel.run_text('shaft.nc', SHAFT);
      await panel.has_path(100);
      await panel.has_part('profile');
      assert.equal(await panel.page.locator('.legend').count(), 0, 'no path, no legend of it');
      await panel.shows('Path over the part', true);
      await panel.page.locator('.legend', { hasText: 'thread' }).waitFor();
      await panel.shows('Part', false);
      await panel.page.locator('.legend', { hasText: 'thread' }).waitFor();
      await panel.page.waitForTimeout(800);
      const [above, below] = await inked(panel);
      assert.ok(above > 2000 && below > 2000, `both halves are drawn: ${above}, ${below}`);
      await panel.press('Cycle start');
      await panel.has_status('RUNNING');
      const seen = new Set();
      const late = Date.now() + 20_000;
      while (seen.size < 3 && Date.now() < late) {
        seen.add(await speed(panel));
        await panel.page.waitForTimeout(200);
      }
      assert.ok(seen.size >= 3, `speeds: ${[...seen]}`);
      await panel.page.locator('aside', { hasText: 'G96 180 m/min' }).waitFor();
      await panel.page.locator('aside', { hasText: 'mm/r' }).waitFor();
      await panel.press('Reset');
      await panel.has_status('IDLE');
    },
  },
  {
    name: 'axe finds nothing at a lathe',
    async run({ open }) {
      const panel = await open_lathe(open);
      await panel.fresh();
      await offsets_of_the_shaft(panel);
      await panel.run_text('shaft.nc', SHAFT);
      await panel.has_path(100);
      await panel.page.evaluate(AXE);
      const found = [];
      for (const tab of ['Tools', 'Offsets']) {
        await panel.tab(tab);
        await panel.page.waitForTimeout(300);
        found.push(...(await findings(panel, tab)));
      }
      assert.deepEqual(found, []);
    },
  },
  {
    name: 'a phone shows the diameter, the offsets and the part of a lathe',
    async run({ open, shots }) {
      const desk = await open_lathe(open);
      await desk.fresh();
      await offsets_of_the_shaft(desk);
      await desk.run_text('shaft.nc', SHAFT);
      await desk.has_path(100);
      await desk.close();
      const panel = await open({ ...PHONE, machine: NAME });
      const show = (pane) =>
        panel.page.locator('.panes').getByRole('button', { name: pane, exact: true }).click();
      const take = async (pane) => {
        await panel.page.waitForTimeout(700);
        if (shots) await panel.page.screenshot({ path: join(shots, `lathe-${pane}-390x844.png`) });
      };
      await show('Position');
      await panel.page.locator('aside tbody tr', { hasText: 'Ø' }).first().waitFor();
      await take('position');
      await show('Picture');
      await panel.has_path(100);
      await panel.has_part('profile');
      await take('picture');
      await panel.shows('Path over the part', true);
      await panel.page.locator('.legend', { hasText: 'thread' }).waitFor();
      await show('More');
      await panel.tab('Tools');
      await cell(panel, 'T1 Geometry XØ').waitFor();
      await take('tools');
      const wide = await panel.page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= PHONE.width, `the page is ${wide} wide`);
    },
  },
  ...SIZES.map(([width, height]) => ({
    name: `pictures of a lathe at ${width}×${height}`,
    needs_shots: true,
    async run({ open, shots }) {
      const panel = await open_lathe(open, { width, height });
      const take = async (state) => {
        await panel.page.waitForTimeout(700);
        await panel.page.mouse.move(0, 0);
        await panel.page.screenshot({
          path: join(shots, `lathe-${state}-${width}x${height}.png`),
        });
      };
      await panel.fresh();
      await offsets_of_the_shaft(panel);
      await panel.run_text('shaft.nc', SHAFT);
      await panel.has_path(100);
      await without_card(panel);
      await panel.tab('Variables');
      await take('open');
      await panel.tab('Tools');
      await panel.press('Cycle start');
      await panel.page.waitForTimeout(9000);
      await take('run');
      await panel.press('Reset');
      await panel.has_status('IDLE');
    },
  })),
];
