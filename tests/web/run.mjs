// node tests/web/run.mjs (--base URL | --kerf PROGRAM) [--shots DIR] [--only WORD]… [--part 1/2] [--soak MINUTES] [--chromium PATH]
//
// Drives the page of the panel as a person does, in a real browser, against a real `kerf serve`. With --kerf a server is
// started with an empty data folder and ended afterwards; some scenarios need that, because they end it themselves. Each
// scenario has a page of its own; what one leaves behind in the server does not matter to the next. --part runs every
// second of them, from the first or from the second on. --shots takes the pictures of docs/images/panel, and makes them
// small where pngquant is installed; Chinese needs a font, such as fonts-noto-cjk.
// --soak looks at one running machine for so long instead, and holds what the page has used up (soak.mjs). Exit status: 0 all hold · 1 some do not · 2 wrong usage.
import { spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright-core';
import { PanelPage } from './panel_page.mjs';
import { Server } from './server.mjs';
import { soak } from './soak.mjs';
import { accessibility } from './scenarios/accessibility.mjs';
import { debugging } from './scenarios/debugging.mjs';
import { editing } from './scenarios/editing.mjs';
import { faults } from './scenarios/faults.mjs';
import { manual } from './scenarios/manual.mjs';
import { million } from './scenarios/million.mjs';
import { newcomer } from './scenarios/newcomer.mjs';
import { operating } from './scenarios/operating.mjs';
import { pictures } from './scenarios/pictures.mjs';
import { starting } from './scenarios/starting.mjs';
import { states } from './scenarios/states.mjs';
import { drafts } from './scenarios/drafts.mjs';
import { contours } from './scenarios/contours.mjs';
import { contour_tools } from './scenarios/contour_tools.mjs';
import { features } from './scenarios/features.mjs';
import { files } from './scenarios/files.mjs';
import { patterns } from './scenarios/patterns.mjs';
import { panel_states } from './scenarios/panel_states.mjs';
import { part as part_scenarios } from './scenarios/part.mjs';
import { colours } from './scenarios/colours.mjs';
import { phone } from './scenarios/phone.mjs';
import { lathe } from './scenarios/lathe.mjs';
import { link } from './scenarios/link.mjs';
import { cells } from './scenarios/cells.mjs';
import { keys } from './scenarios/keys.mjs';
import { marks } from './scenarios/marks.mjs';
import { setup } from './scenarios/setup.mjs';
import { training } from './scenarios/training.mjs';

const ALL = [
  ...operating,
  ...debugging,
  ...editing,
  ...manual,
  ...keys,
  ...cells,
  ...marks,
  ...drafts,
  ...lathe,
  ...link,
  ...files,
  ...features,
  ...contours,
  ...contour_tools,
  ...patterns,
  ...setup,
  ...[...part_scenarios, ...colours].map((scenario) => ({ ...scenario, needs_part: true })),
  ...phone,
  ...training,
  ...newcomer,
  ...starting,
  ...accessibility,
  ...faults,
  ...million,
  ...states,
  ...panel_states,
  ...pictures,
];
const LIMIT_MS = 600_000; // whoever has not ended by then hangs, however busy the computer is
const STARTED = Date.now();

const { values } = parseArgs({
  options: {
    base: { type: 'string' },
    kerf: { type: 'string' },
    shots: { type: 'string' },
    only: { type: 'string', multiple: true },
    part: { type: 'string', default: '1/1' },
    soak: { type: 'string' },
    chromium: { type: 'string', default: '/usr/bin/chromium-headless-shell' },
  },
});
const [part, parts] = values.part.split('/').map(Number);
if (!values.base === !values.kerf || !(part >= 1 && part <= parts)) {
  console.error(
    'usage: node tests/web/run.mjs (--base URL | --kerf PROGRAM) [--shots DIR] [--only WORD]… [--part 1/2]',
  );
  process.exit(2);
}
if (values.shots) mkdirSync(values.shots, { recursive: true });

const server = values.kerf ? await Server.start(values.kerf) : null;
// Without a graphics card the picture is drawn by software; 2-D canvases then belong to the processor, too.
const browser = await chromium.launch({
  executablePath: values.chromium,
  args: [
    '--no-sandbox',
    '--disable-dev-shm-usage', // small in containers
    '--enable-unsafe-swiftshader',
    '--disable-gpu-rasterization',
    '--disable-accelerated-2d-canvas',
  ],
});

const shows_parts = await fetch(new URL('api', server?.base ?? values.base))
  .then((answer) => answer.text())
  .then((text) => text.includes('`stock_at`'));

const scenarios = values.soak ? [a_long_look(Number(values.soak))] : ALL;
const wanted = scenarios
  .filter(({ name }) => !values.only || values.only.some((word) => name.includes(word)))
  .filter((_, i) => i % parts === part - 1);
let failed = 0;
let left_out = 0;
for (const scenario of wanted) {
  const reason = why_not(scenario);
  if (reason) {
    left_out++;
    console.log(`  –  ${scenario.name}: ${reason}`);
  } else if (!(await holds(scenario))) {
    failed++;
  }
}
await browser.close();
await server?.end();
if (values.shots) make_small(values.shots);
console.log(`${wanted.length - failed - left_out} hold, ${failed} do not, ${left_out} left out`);
process.exit(failed || wanted.length === 0 ? 1 : 0);

function a_long_look(minutes) {
  return {
    name: `nothing grows in ${minutes} minutes at a running machine`,
    limit_ms: (minutes + 5) * 60_000,
    run: async ({ open }) => soak(await open(), minutes),
  };
}

function why_not(scenario) {
  if (scenario.needs_server && !server) return 'it ends the server: --kerf is needed';
  if (scenario.needs_part && !shows_parts) return 'this server shows no parts';
  if (scenario.needs_shots && !values.shots) return 'it only takes pictures: --shots is needed';
  return '';
}

async function holds(scenario) {
  const began = Date.now();
  const opened = [];
  const context = {
    browser,
    server,
    base: server?.base ?? values.base,
    shots: values.shots,
    async open(options) {
      const slow_screen = !values.shots && !scenario.measures_frames;
      const page = await PanelPage.open(browser, server?.base ?? values.base, {
        slow_screen,
        ...options,
      });
      opened.push(page);
      return page;
    },
  };
  try {
    const note = await within(scenario.limit_ms ?? LIMIT_MS, scenario.run(context));
    for (const page of opened) page.expect_no_errors();
    console.log(
      `  ✓  ${scenario.name} (${((Date.now() - began) / 1000).toFixed(1)} s)${note ? `: ${note}` : ''}`,
    );
    return true;
  } catch (reason) {
    console.log(
      `  ✗  ${scenario.name}\n     ${String(reason.stack ?? reason)
        .split('\n')
        .slice(0, 24)
        .join('\n     ')}`,
    );
    for (const [i, page] of opened.entries())
      await page.keep_for_search(scenario.name, i, values.shots ?? '/tmp');
    return false;
  } finally {
    for (const page of opened) await page.close();
  }
}

/** The pictures of this run in 256 colours each: a third of the bytes, and no difference that an eye finds. */
function make_small(folder) {
  const taken = readdirSync(folder)
    .filter((file) => file.endsWith('.png') && !file.startsWith('failed-'))
    .map((file) => join(folder, file))
    .filter((file) => statSync(file).mtimeMs >= STARTED);
  if (taken.length === 0) return;
  const options = ['--force', '--ext', '.png', '--strip', '--speed', '1'];
  const { error } = spawnSync('pngquant', [...options, ...taken], { stdio: 'inherit' });
  if (error) console.log(`the pictures stay as they are: pngquant: ${error.code}`);
}

function within(milliseconds, promise) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(
      () => reject(new Error(`not done in ${milliseconds / 1000} s`)),
      milliseconds,
    );
  });
  return Promise.race([promise, late]).finally(() => clearTimeout(timer));
}
