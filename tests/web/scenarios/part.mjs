// The part that is cut: set up in forms, seen at any time of the run, opened, measured, and what it has met.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { CLAMPED, RELIEF } from '../programs.mjs';
import { AXE, findings } from './accessibility.mjs';

const DESK = { width: 1440, height: 900 };
const PHONE = { width: 390, height: 844, touch: true };

const picture = (panel) => panel.page.locator('#picture');
const dock = (panel) => panel.page.locator('#dock-setup');

async function shows_instant(panel, time_s) {
  await panel.until(
    (wanted) =>
      Math.abs(Number(document.querySelector('#picture').dataset.partTime) - wanted) < 0.3,
    time_s,
  );
}

async function fill(panel, name, value) {
  const field = dock(panel).getByRole('textbox', { name, exact: true });
  await field.fill(String(value));
  await field.press('Tab');
}

/** A block with a clamp, an end mill in its holder and a drill, entered in the forms. */
async function set_up(panel) {
  await panel.pane('More');
  await panel.tab('Set-up');
  await dock(panel).getByRole('combobox', { name: 'Stock: Shape' }).selectOption('box');
  for (const [field, value] of [
    ['X from', -5],
    ['X to', 64],
    ['Y to', 60],
    ['Z from', -18],
  ])
    await fill(panel, `Stock: ${field}`, value);
  await dock(panel).getByRole('button', { name: 'Add a clamp' }).click();
  await fill(panel, 'Clamp 1: Name', 'left jaw');
  await fill(panel, 'Clamp 1: X to', -5);
  await dock(panel).getByRole('button', { name: 'Add tool' }).click();
  await fill(panel, 'Tool 1: Holder, Ø × height from below', '30/40x25, 63x40');
  await dock(panel).getByRole('button', { name: 'Add tool' }).click();
  await dock(panel).getByRole('combobox', { name: 'Tool 2: Type' }).selectOption('drill');
  await fill(panel, 'Tool 2: Diameter', 6);
  await dock(panel).getByRole('button', { name: 'Set up' }).click();
  await panel.page.getByText('The set-up of clamped.nc is kept.').first().waitFor();
}

/** The set-up of an earlier scenario is another one. */
async function open_clamped(panel) {
  await panel.operates();
  await panel.pane('More');
  await panel.fresh();
  await panel.pane('Program');
  await panel.run_text('clamped.nc', CLAMPED);
  await panel.has_path();
  await panel.pane('More');
  await panel.tab('Set-up');
  await dock(panel).getByRole('button', { name: 'Text', exact: true }).click();
  const text = dock(panel).getByRole('textbox', { name: 'Set-up' });
  await text.fill('# as nobody has set it up\n');
  await text.press('Tab');
  await dock(panel).getByRole('button', { name: 'Set up' }).click();
  await dock(panel).getByRole('button', { name: 'Forms' }).click();
}

/** Of the picture, so much is not seen through. */
const opaque_share = (panel) =>
  panel.page.evaluate(() => {
    const canvas = document.querySelector('#picture');
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const pen = copy.getContext('2d');
    pen.drawImage(canvas, 0, 0);
    const { data } = pen.getImageData(0, 0, copy.width, copy.height);
    let sum = 0;
    for (let i = 3; i < data.length; i += 4) if (data[i] > 200) sum++;
    return (4 * sum) / data.length;
  });

async function shot(panel, shots, name, { width, height }) {
  if (!shots) return;
  await panel.page.mouse.move(2, 2);
  await panel.page.waitForTimeout(2500);
  await panel.page.screenshot({ path: join(shots, `${name}-${width}x${height}.png`) });
}

const at_size = (size) => ({
  name: `a part is set up, cut, opened and gone through in time (${size.width} px)`,
  async run({ open, shots }) {
    const panel = await open(size);
    await open_clamped(panel);
    await set_up(panel);
    await shot(panel, shots, 'part-set-up', size);
    await panel.has_part();
    await panel.page.locator('header .problems.findings').waitFor({ state: 'attached' });
    await panel.pane('More');
    await panel.tab('Problems');
    const rows = panel.page.locator('#dock-problems tbody tr');
    const count = await rows.count();
    assert.ok(count >= 3, `${count} findings`);

    // A finding: line, instant and place.
    const row = rows.filter({ hasText: 'FIXTURE_COLLISION' }).first();
    const line = Number(await row.locator('.line').innerText());
    await row.locator('.sentence').click();
    await panel.pane('Position');
    await panel.page.locator('.instant').waitFor();
    await panel.pane('Program');
    await panel.page
      .locator('.cm-activeLine', { hasText: CLAMPED.split('\n')[line - 1] })
      .waitFor();
    await panel.pane('Picture');
    await panel.page.locator('#picture').waitFor();
    const [minutes, seconds] = /(\d+):(\d+\.\d)/
      .exec(await row.textContent())
      .slice(1)
      .map(Number);
    const first = 60 * minutes + seconds;
    await shows_instant(panel, first);
    await shot(panel, shots, 'part-finding', size);
    assert.ok((await panel.page.locator('.track .mark').count()) >= 2, 'marks on the slider');
    const here = () => document.querySelector('#dock-problems tr.here .line')?.textContent;
    await panel.pane('More');
    const from = await panel.page.evaluate(here);
    await panel.page.keyboard.press('F3');
    await panel.until((before) => {
      const now = document.querySelector('#dock-problems tr.here .line')?.textContent;
      return now !== undefined && now !== before;
    }, from);
    await panel.page.keyboard.press('Shift+F3');
    await panel.until(
      (before) => document.querySelector('#dock-problems tr.here .line')?.textContent === before,
      from,
    );
    await shows_instant(panel, first);

    // Forwards and backwards.
    await panel.pane('Picture');
    for (const time_s of [20, 3, 12]) {
      await panel.go_to_instant(time_s);
      await shows_instant(panel, time_s);
    }
    await panel.page.locator('#picture').focus();
    await panel.page.keyboard.press('n');
    await panel.until(() => document.querySelector('.instant') === null);

    // A section takes away what lies before it.
    await panel.page.waitForTimeout(1000);
    const whole = await opaque_share(panel);
    const section = panel.page.getByRole('radiogroup', { name: 'Section' });
    await section.getByRole('radio', { name: 'Y' }).click();
    await panel.page.getByRole('slider', { name: 'Section at Y' }).fill('0.34');
    await panel.page.waitForTimeout(1000);
    assert.ok((await opaque_share(panel)) < whole, 'less is seen of an opened part');
    await shot(panel, shots, 'part-section', size);
    await section.getByRole('radio', { name: 'Whole' }).click();
    const wide = await panel.page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= size.width, `the page is ${wide} px wide`);
  },
});

export const part = [
  at_size(DESK),
  at_size(PHONE),
  ...[DESK, PHONE].map((size) => ({
    name: `the part is as the machine has made it, and the picture stays fluent (${size.width} px)`,
    measures_frames: true,
    // What goes on is the same on a phone, only smaller: there its picture is taken.
    needs_shots: size === PHONE,
    async run({ open, shots }) {
      const panel = await open(size);
      const bytes = await bytes_received(panel);
      await panel.operates();
      await panel.pane('More');
      await panel.fresh();
      await panel.pane('Program');
      await panel.run_text('relief.nc', RELIEF);
      await panel.pane('Picture');
      await panel.has_path();
      // Until then the part of the program before may be there.
      await panel.until(() => Number(document.querySelector('#picture').dataset.partEnd) > 200);
      await panel.has_part();
      const end = Number(await picture(panel).getAttribute('data-part-end'));
      await panel.press('Cycle start');
      await panel.has_status('RUNNING');
      await panel.until((all) => {
        const now = Number(document.querySelector('#picture').dataset.partTime);
        return now > 4 && now < all / 2;
      }, end);
      const part_time = async () => Number(await picture(panel).getAttribute('data-part-time'));
      const seen_s = await part_time();
      const began = [Date.now(), bytes()];
      const times = (await panel.frames(60)).sort((a, b) => a - b);
      const kib_s = (bytes() - began[1]) / 1.024 / (Date.now() - began[0]);
      const median = times[times.length >> 1];
      const went_on_s = (await part_time()) - seen_s;
      const behind = await panel.page.evaluate(
        () => document.querySelector('.says.behind')?.textContent ?? '',
      );
      await shot(panel, shots, 'part-run', size);
      await panel.press('Reset');
      const cells = await picture(panel).getAttribute('data-part-cells');
      assert.equal(behind, '', 'the model keeps up with the machine');
      assert.ok(went_on_s > 0, 'the part goes on with the machine while frames are drawn');
      assert.ok(kib_s < MOST_KIB_S, `${kib_s.toFixed(0)} KiB/s`);
      return `${cells} cells: median frame ${median.toFixed(1)} ms, slowest ${times.at(-1).toFixed(0)} ms, ${kib_s.toFixed(0)} KiB/s to the page`;
    },
  })),
  {
    name: 'places of the part are measured, and a click tells the line that cut it',
    async run({ open }) {
      const panel = await open(DESK);
      await open_clamped(panel);
      await set_up(panel);
      await panel.has_part();
      const { page } = panel;
      await page.locator('#picture').focus();
      await page.keyboard.press('1'); // from above: the middle of the picture is the middle of what is seen
      await page.waitForTimeout(1200);
      const box = await picture(panel).boundingBox();
      const at = (x, y) => page.mouse.click(box.x + x * box.width, box.y + y * box.height);
      await page.getByRole('button', { name: 'Measure' }).click();
      await page.getByRole('button', { name: /^Distance/ }).click();
      await at(0.45, 0.5);
      await at(0.55, 0.5);
      const words = await page.locator('.measured').innerText();
      assert.match(words, /ΔX [\d.]+ ΔY [−-]?0\.000/, words);
      assert.ok(Number(/([\d.]+) mm/.exec(words)[1]) > 1, words);
      await page.getByRole('button', { name: 'Measure' }).click();
      await page.getByRole('button', { name: 'Stop measuring' }).click();
      await at(0.5, 0.5);
      await page.locator('.picture .hover[role="status"]', { hasText: 'X' }).waitFor();
    },
  },
  {
    name: 'a text that was changed makes what is known stale',
    async run({ open }) {
      const panel = await open(DESK);
      await open_clamped(panel);
      await panel.page.locator('.cm-content').click();
      await panel.page.keyboard.press('Control+Home');
      await panel.page.keyboard.press('End');
      await panel.page.keyboard.type(' (CHANGED)');
      await panel.page.locator('header .problems.stale').waitFor();
    },
  },
  {
    name: 'what is no set-up is refused with its line, and changes nothing',
    async run({ open }) {
      const panel = await open(DESK);
      await open_clamped(panel);
      await dock(panel).getByRole('button', { name: 'Text', exact: true }).click();
      const text = dock(panel).getByRole('textbox', { name: 'Set-up' });
      await text.fill('[stock]\nshape = \n');
      await text.press('Tab');
      await dock(panel).getByRole('alert').filter({ hasText: 'Line 2' }).waitFor();
      await text.fill('[stuck]\nshape = "extents"\n');
      await text.press('Tab');
      await dock(panel).getByRole('button', { name: 'Set up' }).click();
      await dock(panel).getByRole('alert').filter({ hasText: 'stuck' }).waitFor();
    },
  },
  {
    name: 'axe finds nothing at a part, its findings and its set-up, in the dark and in the light',
    async run({ open }) {
      const panel = await open(DESK);
      await open_clamped(panel);
      await set_up(panel);
      await panel.has_part();
      await panel.page.evaluate(AXE);
      assert.deepEqual(await findings(panel, 'set-up'), []);
      await panel.tab('Problems');
      await panel.page.keyboard.press('F3');
      assert.deepEqual(await findings(panel, 'findings of the part'), []);
    },
  },
];

const MOST_KIB_S = 2048;

/** A count of what has come over the line of the page so far. */
async function bytes_received(panel) {
  let sum = 0;
  const line = await panel.context.newCDPSession(panel.page);
  await line.send('Network.enable');
  line.on('Network.webSocketFrameReceived', ({ response: { opcode, payloadData } }) => {
    sum += opcode === 2 ? (3 * payloadData.length) / 4 : payloadData.length;
  });
  return () => sum;
}
