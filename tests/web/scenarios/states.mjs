// Every state that a panel can be in, on each kind of machine: reached as a person reaches it, held against what must
// then be seen, and taken as a picture of docs/images, on a desk and on a tablet.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { FRAMES_BASIC, frames } from '../programs.mjs';

const SIZES = [
  [1440, 900],
  [820, 1180],
];

const G_CODE = {
  file: 'frames.nc',
  called_line: 10,
  variable: { name: '#500', value: '7' },
};

/** What each machine runs, where its program is called, and what it can be told by hand. */
const MACHINES = [
  {
    ...G_CODE,
    machine: 'mill',
    scheme: 'dark',
    sample: 'flanges.nc',
    run: { seconds: 9, tab: 'Variables' },
    text: frames('G90 G54 G00 X60. Y40.'),
    wrong: { file: 'wrong.nc', text: wrong('#101=1/#100'), code: 'PS0112' },
    mdi: { text: 'G90 G53 G01 X-3.5 F2000', axis: 'X', value: -3.5 },
    jog: 'X',
  },
  {
    machine: 'laser',
    scheme: 'dark',
    sample: 'cardioid.bas',
    run: { seconds: 3, tab: 'Pulses' },
    hold_ms: 300,
    file: 'frames.bas',
    text: FRAMES_BASIC,
    called_line: 10,
    variable: { name: 'SIZE', value: '30' },
    wrong: { file: 'wrong.bas', text: 'speed(40)\nmove(5, 5)\nline(500, 5)\nend\n', code: 'LB' },
    mdi: { text: 'speed(40); move(12.5, -7.5)', axis: 'X', value: 12.5 },
    jog: 'X',
  },
  {
    ...G_CODE,
    machine: 'five-axis',
    scheme: 'light',
    sample: 'tube.tch',
    run: { seconds: 8, tab: 'Speed' },
    text: frames('G90 G54 G00 X260. Y40. Z60. A30. C45.'),
    wrong: { file: 'wrong.nc', text: wrong('G90 G01 X4000.'), code: 'LIMIT' },
    mdi: { text: 'G90 G01 Y12.5 A20. F3000', axis: 'Y', value: 12.5 },
    jog: 'Y',
  },
  {
    ...G_CODE,
    machine: 'arm',
    scheme: 'light',
    sample: 'flower.nc',
    run: { seconds: 14, tab: 'Stepping', instant_s: 400 },
    text: frames('G90 G10 L2 P1 X210. Y10.\nG54 G00 X0. Y0.'),
    wrong: { file: 'wrong.nc', text: wrong('G90 G54 G01 X290.'), code: 'OUT_OF_REACH' },
    mdi: { text: 'G90 G54 G01 X5. Y-10. F600', axis: 'Y', value: -10 },
    jog: 'Y',
  },
];

/** In the order of a day at the machine; each leaves the machine at rest or resets it. */
const STATES = {
  async open(panel, { sample }) {
    await panel.open_program(sample);
    await panel.has_path(10);
  },
  async run(panel, { run }) {
    await panel.tab(run.tab);
    await panel.press('Cycle start');
    await panel.page.waitForTimeout(1000 * run.seconds);
    if (run.instant_s) await panel.go_to_instant(run.instant_s);
  },
  async hold(panel, { sample, hold_ms = 5000 }) {
    await panel.open_program(sample);
    await panel.press('Cycle start');
    await panel.page.waitForTimeout(hold_ms);
    await panel.press('Feed hold');
    await panel.has_status('HOLD');
  },
  async macro(panel, { file, text, called_line }) {
    await panel.run_text(file, text);
    await panel.tab('Variables');
    await panel.step_into(called_line);
    await panel.press('Over');
    await panel.executes_line(called_line + 1);
    await panel.page.locator('#dock-variables li.changed').first().waitFor();
  },
  async variable(panel, { file, text, variable }) {
    await panel.run_text(file, text);
    await panel.press('Into');
    await panel.has_status('STEP');
    await panel.tab('Variables');
    await panel.set_variable(variable.name, variable.value);
    await panel.variable_is(variable.name, variable.value);
  },
  async breakpoint(panel, { file, text, called_line }) {
    await panel.run_text(file, text);
    await panel.toggle_breakpoint(called_line + 1);
    await panel.tab('Stepping');
    await panel.press('Cycle start');
    await panel.page.getByText(`Breakpoint at line ${called_line + 1}`).waitFor();
  },
  async alarm(panel, { wrong }) {
    await panel.run_text(wrong.file, wrong.text);
    await panel.tab('Messages');
    await panel.press('Cycle start');
    await panel.has_status('ALARM');
    assert.match(await panel.page.locator('section.alarm').innerText(), new RegExp(wrong.code));
  },
  async mdi(panel, { mdi, file, text }) {
    await panel.run_text(file, text);
    await panel.press('MDI');
    await panel.tab('MDI');
    const entry = panel.page.getByRole('textbox', { name: 'Blocks to execute' });
    await entry.fill(mdi.text);
    await entry.press('Enter');
    await panel.position_is(mdi.axis, mdi.value);
  },
  async jog(panel, { jog, sample }) {
    await panel.open_program(sample);
    await panel.has_path(10);
    await panel.press('JOG');
    await panel.tab('Offsets');
    await panel.page.getByLabel('Step, mm').selectOption({ label: '10' });
    const before = await panel.position(jog);
    await panel.page.getByRole('button', { name: `Jog ${jog}+` }).click();
    await panel.position_is(jog, before + 10);
  },
  async teach(panel, { jog }) {
    await panel.press('TEACH');
    await panel.tab('Teach');
    await panel.page.getByRole('radio', { name: 'Machine' }).click(); // the taught program knows no G54
    await panel.page.getByLabel('Step, mm').selectOption({ label: '10' });
    const before = await panel.position(jog);
    await panel.teach_two_points(jog);
    await panel.load_taught();
    await panel.press('Cycle start');
    await panel.has_status('END');
    await panel.position_is(jog, before + 10);
  },
  async language(panel, { sample }) {
    await panel.open_program(sample);
    await panel.page.getByRole('combobox', { name: 'Language' }).selectOption('zh-Hant');
    await panel.key('循環啟動').waitFor();
  },
  async upload(panel, { file, text }) {
    const name = `uploaded-${file}`;
    await panel.upload(name, text);
    await panel.open_program(name);
    await panel.page.reload();
    await panel.is_connected();
    await panel.page.locator('.file.current', { hasText: name }).waitFor();
    await panel.open_library();
  },
  async watch(panel, { machine, sample }, open) {
    await panel.open_program(sample);
    const second = await open({ machine });
    await second.page.locator('header .badge', { hasText: 'operates' }).waitFor();
    await panel.page.locator('header .badge').click();
    await panel.page.getByRole('button', { name: /^Hand over to/ }).waitFor();
  },
};

/** Back to a machine at rest, in English. */
async function leave(panel) {
  await panel.page.keyboard.press('Escape');
  const language = panel.page.getByRole('combobox', { name: '語言' });
  if (await language.count()) await language.selectOption('en');
  await panel.page.getByRole('radio', { name: 'Work' }).click();
  await panel.fresh();
}

async function take(panel, path) {
  await panel.page.waitForTimeout(700); // what glides has come to rest
  await panel.page.mouse.move(0, 0);
  await panel.page.screenshot({ path });
}

export const states = MACHINES.flatMap((kind) =>
  SIZES.map(([width, height]) => ({
    name: `states of the ${kind.machine} at ${width}×${height}`,
    needs_shots: kind.machine !== 'five-axis' || width !== 820, // one of them without pictures, too
    async run({ open, shots }) {
      const { machine, scheme } = kind;
      const panel = await open({ machine, width, height, scheme });
      await panel.fresh();
      for (const [state, reach] of Object.entries(STATES)) {
        await reach(panel, kind, open).catch((reason) => {
          throw new Error(`${state}: ${reason.stack}`);
        });
        if (shots) await take(panel, join(shots, `${machine}-${state}-${width}x${height}.png`));
        await leave(panel);
      }
    },
  })),
);

/** Line 5 does what is wrong, behind a block that is right. */
function wrong(block) {
  return `%\nO0300 (HAS A MISTAKE)\n#100=0\nG90 G54 G94 F2000\n${block}\nM30\n%\n`;
}
