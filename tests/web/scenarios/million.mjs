// A program of a million motions: soon seen, and the page stays fluent.
import assert from 'node:assert/strict';
import { spiral } from '../programs.mjs';

const CUTS = 1_000_000;
const MOST_MIB = 600;
const ALL_OF_IT_MS = 150_000; // seconds on a quiet computer

export const million = [
  {
    name: 'a million motions are seen at once and can be turned',
    measures_frames: true,
    async run({ open, browser }) {
      const panel = await open();
      await panel.fresh();
      await panel.upload('million.nc', spiral(CUTS));
      await panel.open_library();
      const entry = panel.page
        .getByRole('dialog')
        .getByRole('button', { name: 'million.nc', exact: true });
      await entry.waitFor();
      await panel.page.evaluate(() => {
        const picture = document.querySelector('#picture');
        window.first_picture = new Promise((resolve) => {
          const from = performance.now();
          const run_before = picture.dataset.run;
          const look = () => {
            if (picture.dataset.run !== run_before && Number(picture.dataset.segments) > 0)
              resolve(performance.now() - from);
            else requestAnimationFrame(look);
          };
          look();
        });
      });
      await entry.click();
      const first_ms = await panel.page.evaluate(() => window.first_picture);
      await panel.has_path(CUTS, ALL_OF_IT_MS);
      const box = await panel.page.locator('#picture').boundingBox();
      await panel.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
      await panel.page.mouse.down();
      const turning = panel.frames(40);
      for (let i = 0; i < 60; i++) {
        await panel.page.mouse.move(box.x + box.width / 2 + 3 * i, box.y + box.height / 2 + i);
      }
      const times = (await turning).sort((a, b) => a - b);
      await panel.page.mouse.up();
      const median = times[times.length >> 1];
      const mib = await memory_mib(browser, panel);
      assert.ok(mib < MOST_MIB, `the page takes ${mib.toFixed(0)} MiB`);
      return `first picture after ${first_ms.toFixed(0)} ms, median frame ${median.toFixed(0)} ms, slowest ${times.at(-1).toFixed(0)} ms, ${mib.toFixed(0)} MiB`;
    },
  },
  {
    name: 'in a million lines words have their colours, also those that are being typed',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.upload('few.nc', spiral(100));
      await panel.open_program('few.nc');
      const few = await colours_while_typing(panel);
      await panel.upload('coloured.nc', spiral(CUTS));
      await panel.open_program('coloured.nc');
      const all = await colours_while_typing(panel);
      // The slowest ones wait for the page, which compares the whole text whenever the typing pauses.
      const words = `a colour takes ${all.median.toFixed(0)} ms, in a hundred lines ${few.median.toFixed(0)} ms`;
      assert.ok(all.median < SOME_KEYS_MS + MANY_TIMES * few.median, words);
      return `${words}, the slowest ${all.slowest.toFixed(0)} ms`;
    },
  },
];

const SOME_KEYS_MS = 500; // a colour takes some 10 on a quiet computer
const MANY_TIMES = 10; // on a busy one all is slower

/** From keys at the end of the text to their colours. */
async function colours_while_typing({ page }) {
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+Home'); // another text may have been longer or shorter
  await page.locator('.cm-line .cm-token-command', { hasText: 'G01' }).first().waitFor();
  await page.keyboard.press('Control+End');
  await page.locator('.cm-line .cm-token-program', { hasText: '%' }).first().waitFor();
  const times = [];
  for (const key of 'G01 X12.5 Y-7. (NOTE)') {
    await page.evaluate(AWAIT_COLOUR, key);
    await page.keyboard.type(key);
    times.push(await page.evaluate(() => window.coloured));
  }
  times.sort((a, b) => a - b);
  return { median: times[times.length >> 1], slowest: times.at(-1) };
}

/** ms from the next key until each character of the line, blanks left out, lies in a token of the server. */
const AWAIT_COLOUR = (key) => {
  const line = () => document.querySelector('.cm-activeLine');
  const solid = (text) => text.replaceAll(' ', '');
  const wanted = line().textContent + key;
  let from = 0;
  addEventListener('keydown', () => (from = performance.now()), { capture: true, once: true });
  window.coloured = new Promise((resolve) => {
    const look = () => {
      const coloured = [...line().querySelectorAll('[class^=cm-token-]')];
      const text = coloured.map((token) => token.textContent).join('');
      if (line().textContent === wanted && solid(text) === solid(wanted))
        resolve(performance.now() - from);
      else requestAnimationFrame(look);
    };
    look();
  });
};

/** The page's heap with all its array buffers. */
async function memory_mib(_browser, panel) {
  const session = await panel.context.newCDPSession(panel.page);
  await session.send('HeapProfiler.collectGarbage');
  const heap = await session.send('Runtime.getHeapUsage');
  return (
    (heap.usedSize + (heap.embedderHeapUsedSize ?? 0) + (heap.backingStorageSize ?? 0)) /
    1024 /
    1024
  );
}
