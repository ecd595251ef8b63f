// A long look at one running machine: whether the page keeps what it has long used up. Part of run.mjs --soak MINUTES.
import assert from 'node:assert/strict';
import { RUNS_FOR_HOURS } from './programs.mjs';

const MINUTE_MS = 60_000;
/** What a page may hold more at the end than once it has settled. */
const MOST_MORE = { heap_MB: 3, nodes: 400, listeners: 20 };

/** Runs, steps the overrides, turns the tabs, and measures each five minutes; what is held must not grow. */
export async function soak(panel, minutes) {
  await panel.fresh();
  await panel.run_text('soak.nc', RUNS_FOR_HOURS);
  await panel.press('Cycle start');
  await panel.has_status('RUNNING');
  const protocol = await panel.context.newCDPSession(panel.page);
  await protocol.send('Performance.enable');
  await use(panel, 1);
  const table = [{ minute: 0, ...(await measured(panel, protocol)) }];
  console.log(told(table[0]));
  for (let minute = 5; minute < minutes + 5; minute += 5) {
    const until = Math.min(minute, minutes);
    await use(panel, until - table.at(-1).minute);
    table.push({ minute: until, ...(await measured(panel, protocol)) });
    console.log(told(table.at(-1)));
  }
  assert.equal(await panel.status(), 'RUNNING', 'the program outlasts the look at it');
  for (const [what, most] of Object.entries(MOST_MORE)) {
    const more = table.at(-1)[what] - table[0][what];
    assert.ok(more <= most, `${what} grew by ${more} in ${minutes} min`);
  }
}

/** As somebody does who stands beside it. */
async function use(panel, minutes) {
  const until = Date.now() + minutes * MINUTE_MS;
  const tabs = [
    'Problems',
    'Variables',
    'Stepping',
    'Offsets',
    'Tools',
    'Pulses',
    'Speed',
    'Messages',
  ];
  for (let turn = 0; Date.now() < until; turn++) {
    await panel.tab(tabs[turn % tabs.length]);
    await panel.page.waitForTimeout(2000);
    if (turn % 8 === 7) {
      await panel.press('Feed hold');
      await panel.has_status('HOLD');
      await panel.press('Cycle start');
      await panel.has_status('RUNNING');
    }
  }
}

/** In the same tab each time, behind a collection of what nobody holds any more. */
async function measured(panel, protocol) {
  await panel.tab('Messages');
  await panel.page.waitForTimeout(1000);
  await protocol.send('HeapProfiler.enable');
  await protocol.send('HeapProfiler.collectGarbage');
  await protocol.send('HeapProfiler.disable');
  const { metrics } = await protocol.send('Performance.getMetrics');
  const value = (name) => metrics.find((metric) => metric.name === name).value;
  return {
    heap_MB: Math.round(value('JSHeapUsedSize') / 1e4) / 100,
    nodes: value('Nodes'),
    listeners: value('JSEventListeners'),
  };
}

const told = ({ minute, heap_MB, nodes, listeners }) =>
  `  ${String(minute).padStart(3)} min: heap ${heap_MB} MB, ${nodes} nodes, ${listeners} listeners`;
