// By what the part can be coloured: how far its tools were engaged, and how far it is from its design.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { GROOVES, GROOVES_DESIGN, STEPPED, STEPPED_DESIGN } from '../programs.mjs';
import { bar, turned } from '../solids.mjs';
import { open_lathe, without_card } from './lathe.mjs';

const DESK = { width: 1440, height: 900 };
const PHONE = { width: 390, height: 844, touch: true };

const BLOCK = '[stock]\nshape = "box:0,0,-20,70,60,0"\n[design]\nfile = "grooves.stl"\n';
const BAR = `[stock]
shape = "bar:50,-60,0"
[design]
file = "stepped.stl"
[[tool]]
number = 1
type = "turning"
nose_radius = 0
tip = 3
ic = 40
kapr = 95
tip_angle = 80
`;

const colour = (panel, name) =>
  panel.page
    .getByRole('radiogroup', { name: 'Colour of the part' })
    .getByRole('radio', { name, exact: true });

/** Loads a program and sets it up, with its design in the library; the part is seen against it. */
async function open_program(panel, { name, text, design, set_up }) {
  await panel.upload(...design);
  await panel.pane('Program');
  await panel.run_text(name, text);
  await panel.pane('More');
  await panel.tab('Set-up');
  const dock = panel.page.locator('#dock-setup');
  await dock.getByRole('button', { name: 'Text', exact: true }).click();
  const field = dock.getByRole('textbox', { name: 'Set-up' });
  await field.fill(set_up);
  await field.press('Tab');
  await dock.getByRole('button', { name: 'Set up' }).click();
  await panel.page.getByText(`The set-up of ${name} is kept.`).first().waitFor();
  await panel.pane('Picture');
  await colour(panel, 'Deviation').waitFor();
}

/** How much of what is seen of the picture is clearly blue, and clearly red. */
const shares = (panel) =>
  panel.page.evaluate(() => {
    const canvas = document.querySelector('#picture');
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const pen = copy.getContext('2d');
    pen.drawImage(canvas, 0, 0);
    const { data } = pen.getImageData(0, 0, copy.width, copy.height);
    let [all, blue, red] = [0, 0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] < 200) continue;
      all++;
      if (data[i + 2] > data[i] + 60) blue++;
      if (data[i] > data[i + 1] + 70) red++; // the hatch is brown
    }
    return { blue: blue / all, red: red / all };
  });

async function is_seen(panel, what, test) {
  let seen;
  for (const late = Date.now() + 20_000; Date.now() < late;) {
    seen = await shares(panel);
    if (test(seen)) return;
    await panel.page.waitForTimeout(100);
  }
  assert.fail(`${what}: blue ${seen.blue.toFixed(4)}, red ${seen.red.toFixed(4)}`);
}

async function choose(panel, name, caption) {
  await colour(panel, name).click();
  await panel.page.locator('.scale .caption', { hasText: caption }).waitFor();
}

/** The legend lies beside all that can be pressed. */
const is_free = (panel) =>
  panel.page.evaluate(() => {
    const scale = document.querySelector('.picture .scale').getBoundingClientRect();
    return [...document.querySelectorAll('.picture .part .group')]
      .map((group) => group.getBoundingClientRect())
      .every(
        (box) =>
          box.bottom <= scale.top ||
          box.top >= scale.bottom ||
          box.right <= scale.left ||
          box.left >= scale.right,
      );
  });

async function shot(panel, shots, name, { width, height }) {
  if (!shots) return;
  await panel.page.mouse.move(2, 2);
  await panel.page.waitForTimeout(2500);
  await panel.page.screenshot({ path: join(shots, `${name}-${width}x${height}.png`) });
}

/** What the part tells of places one below the other in the middle of the picture. */
async function told_from_top_to_bottom(panel) {
  const box = await panel.page.locator('#picture').boundingBox();
  const words = [];
  for (let share = 0.2; share < 0.8; share += 0.03) {
    await panel.page.mouse.click(box.x + box.width / 2, box.y + share * box.height);
    const card = panel.page.locator('.picture .hover[role="status"]');
    if (await card.count()) words.push((await card.innerText()).replace(/\s+/g, ' '));
  }
  return words;
}

const at_size = (size) => ({
  name: `a part has the colours of its deviation and of its engagement (${size.width} px)`,
  async run({ open, shots }) {
    const panel = await open(size);
    await panel.operates();
    await panel.pane('More');
    await panel.fresh();
    await open_program(panel, {
      name: 'grooves.nc',
      text: GROOVES,
      design: ['grooves.stl', bar(GROOVES_DESIGN, 0, 70)],
      set_up: BLOCK,
    });
    await panel.has_part();
    await colour(panel, 'Plain').click();
    await is_seen(panel, 'a plain part', ({ blue, red }) => blue < 0.02 && red < 0.01);
    await choose(panel, 'Deviation', 'Deviation, mm');
    await is_seen(panel, 'too deep and left', ({ blue, red }) => blue > 0.03 && red > 0.03);
    await shot(panel, shots, 'part-deviation', size);
    await choose(panel, 'Engagement', 'Engagement, °');
    await is_seen(panel, 'no deviation', ({ red }) => red < 0.01);
    await shot(panel, shots, 'part-engagement', size);
    assert.ok(await is_free(panel), 'nothing lies over the legend');
    const wide = await panel.page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= size.width, `the page is ${wide} px wide`);
    if (size.touch) return;
    await choose(panel, 'Deviation', 'Deviation, mm');
    await is_seen(panel, 'once more', ({ blue, red }) => blue > 0.03 && red > 0.03);
    await panel.page.locator('#picture').focus();
    await panel.page.keyboard.press('1'); // from above
    await panel.page.waitForTimeout(1200);
    const told = (await told_from_top_to_bottom(panel)).join('\n');
    for (const words of ['0.200 mm too deep', '0.100 mm left', 'Engaged over 180°'])
      assert.ok(told.includes(words), `${words} is not in: ${told}`);
  },
});

export const colours = [
  at_size(DESK),
  at_size(PHONE),
  {
    name: 'a turned part has the colours of its tools, and of its deviation all along its lines',
    async run({ open, shots }) {
      const panel = await open_lathe(open, DESK);
      await panel.fresh();
      await open_program(panel, {
        name: 'stepped.nc',
        text: STEPPED,
        design: ['stepped.stl', turned(STEPPED_DESIGN)],
        set_up: BAR,
      });
      await without_card(panel);
      await panel.has_part('profile');
      await colour(panel, 'Tool').waitFor();
      await colour(panel, 'Plain').click();
      await is_seen(panel, 'a plain part', ({ blue, red }) => blue < 0.02 && red < 0.01);
      await choose(panel, 'Deviation', 'Deviation, mm');
      await is_seen(panel, 'too thin and left', ({ blue, red }) => blue > 0.03 && red > 0.03);
      assert.ok(await is_free(panel), 'nothing lies over the legend');
      await shot(panel, shots, 'part-turned-deviation', DESK);
      await colour(panel, 'Tool').click();
      await is_seen(panel, 'cut by T1', ({ blue }) => blue > 0.1);
      await shot(panel, shots, 'part-turned-tool', DESK);
    },
  },
];
