// The panel as a person has it: what can be seen, and what can be pressed. Everything goes through the page itself.
import assert from 'node:assert/strict';
import { join } from 'node:path';

const SLOW_MS = 40_000;
const POLL_MS = 30;
const STATUSES = new Set('ALARM END HOLD IDLE RUNNING STEP STOPPED'.split(' ').concat('NO LINK'));

/** Without a graphics card sixty pictures a second would keep more than one processor busy. */
const SCREEN_MS = 80;
const SLOW_SCREEN = (ms) => {
  const draw = window.requestAnimationFrame.bind(window);
  const waiting = new Map();
  let last = 0;
  const show = (id, now) => {
    const call = waiting.get(id);
    waiting.delete(id);
    call?.(now);
  };
  window.requestAnimationFrame = (call) => {
    waiting.set(++last, call);
    const id = last;
    setTimeout(() => draw((now) => show(id, now)), ms);
    return id;
  };
  window.cancelAnimationFrame = (id) => waiting.delete(id);
};

export class PanelPage {
  static async open(
    browser,
    base,
    {
      machine = 'mill',
      width = 1440,
      height = 900,
      scheme = 'dark',
      locale = 'en-US',
      touch = false,
      /** Nothing of the panel is known to this browser yet. */
      newcomer = false,
      /** A screen that shows some ten pictures a second: wherever nobody counts them, or takes one to show it. */
      slow_screen = true,
      /** The card that tells what a program is like when it opens. */
      insight = false,
    } = {},
  ) {
    const context = await browser.newContext({
      viewport: { width, height },
      colorScheme: scheme,
      locale,
      hasTouch: touch,
      reducedMotion: 'reduce',
    });
    context.setDefaultTimeout(SLOW_MS);
    const page = await context.newPage();
    if (!newcomer)
      await page.addInitScript((name) => {
        sessionStorage.setItem('kerf.machine', name);
        localStorage.setItem('kerf.start-card', 'away');
      }, machine);
    if (!insight && !newcomer)
      await page.addInitScript(() => localStorage.setItem('kerf.insight-card', 'away'));
    if (slow_screen) await page.addInitScript(SLOW_SCREEN, SCREEN_MS);
    const panel = new PanelPage(context, page, base);
    await page.goto(base);
    await panel.is_connected();
    return panel;
  }

  /** Another page of the same browser: it knows what this one has kept. */
  async another_page() {
    const page = await this.context.newPage();
    const panel = new PanelPage(this.context, page, this.base);
    const machine = await this.page.evaluate(() => sessionStorage.getItem('kerf.machine'));
    await page.addInitScript((name) => sessionStorage.setItem('kerf.machine', name), machine);
    await page.goto(this.base);
    await panel.is_connected();
    return panel;
  }

  constructor(context, page, base) {
    this.context = context;
    this.page = page;
    this.base = base;
    this.errors = [];
    page.on('pageerror', (error) =>
      this.errors.push(`${error.message} ${error.stack?.split('\n')[1] ?? ''}`),
    );
    page.on('console', (message) => {
      const text = message.text();
      // What the browser itself says of a server that is away is no error of the page.
      if (
        message.type() === 'error' &&
        !/WebSocket|ERR_CONNECTION|Failed to load resource/.test(text)
      )
        this.errors.push(text);
    });
  }

  expect_no_errors() {
    assert.deepEqual(this.errors, [], 'the page has told errors');
  }
  close() {
    return this.context.close();
  }
  async keep_for_search(name, index, folder) {
    const file = join(folder, `failed-${name.replace(/\W+/g, '-')}-${index}.png`);
    await this.page.screenshot({ path: file, timeout: 10_000 }).catch(() => null);
    console.log(`     ${file}; errors: ${this.errors.join(' | ') || 'none'}`);
  }

  // Seeing

  /** Asks the page until the answer is true. Not Playwright's waitForFunction: the page's own security policy forbids it. */
  async until(predicate, argument, limit_ms = SLOW_MS) {
    const late = Date.now() + limit_ms;
    while (!(await this.page.evaluate(predicate, argument))) {
      assert.ok(Date.now() < late, `not true within ${limit_ms / 1000} s: ${predicate}`);
      await this.page.waitForTimeout(POLL_MS);
    }
  }
  async is_connected() {
    await this.page.locator('header .badge').waitFor();
    await this.page.locator('.line[role="alert"]').waitFor({ state: 'detached' });
    await this.until(() => document.querySelectorAll('tbody .big').length > 0);
  }
  async has_program() {
    await this.until(() => (document.querySelector('.cm-content')?.textContent ?? '').length > 10);
  }
  async has_path(at_least = 1, limit_ms = SLOW_MS) {
    await this.until(
      (n) => Number(document.querySelector('#picture')?.dataset.segments) >= n,
      at_least,
      limit_ms,
    );
  }
  /** All of the program has been cut, and some of it is seen. */
  async has_part(model = 'zmap') {
    await this.until((wanted) => {
      const { part, partDone } = document.querySelector('#picture').dataset;
      return part === wanted && partDone === 'true';
    }, model);
  }
  /** One of what the picture can show, as a box has it. */
  async shows(what, is_shown) {
    const tools = this.page.locator('.picture .tools');
    await tools.getByRole('button', { name: 'Show' }).click();
    await this.page.getByRole('checkbox', { name: what, exact: true }).setChecked(is_shown);
    await this.page.keyboard.press('Escape');
  }
  status() {
    return this.page.locator('header .status').innerText();
  }
  async has_status(...words) {
    for (const word of words) assert.ok(STATUSES.has(word), `${word} is no status`);
    await this.until(
      (wanted) =>
        wanted.includes(document.querySelector('header .status')?.textContent?.trim() ?? ''),
      words,
    );
  }
  async position(axis) {
    const row = this.page.locator('tbody tr', {
      has: this.page.locator(`th:text-is("${axis}")`),
    });
    return Number((await row.locator('.big').innerText()).replace('\u2212', '-'));
  }
  async position_is(axis, wanted, tolerance = 0.0015) {
    await this.until(
      ([name, value, most]) => {
        for (const row of document.querySelectorAll('aside tbody tr')) {
          if (row.querySelector('th')?.textContent?.trim() !== name) continue;
          const shown = Number(row.querySelector('.big')?.textContent?.replace('\u2212', '-'));
          return Math.abs(shown - value) <= most;
        }
        return false;
      },
      [axis, wanted, tolerance],
    );
  }
  /** While it moves towards plus: until it is farther than that. */
  async passes(axis, place) {
    const late = Date.now() + SLOW_MS;
    let seen = await this.position(axis);
    while (!(seen > place) && Date.now() < late) {
      await this.page.waitForTimeout(POLL_MS);
      seen = await this.position(axis);
    }
    assert.ok(seen > place, `${axis} is at ${seen}, not beyond ${place}`);
  }
  /** The line with the mark of the executing block; 0: none is in sight. */
  executing_line() {
    return this.page.evaluate(() => {
      const mark = document.querySelector('.cm-executing');
      if (!mark) return 0;
      const top = mark.getBoundingClientRect().top;
      const numbers = [...document.querySelectorAll('.cm-lineNumbers .cm-gutterElement')];
      const number = numbers.find((e) => Math.abs(e.getBoundingClientRect().top - top) < 5);
      return Number(number?.textContent ?? 0);
    });
  }
  async executes_line(line) {
    const until = Date.now() + SLOW_MS;
    let seen = 0;
    while (Date.now() < until) {
      seen = await this.executing_line();
      if (seen === line) return;
      await this.page.waitForTimeout(100);
    }
    assert.equal(seen, line, 'the line of the executing block');
  }
  async variable(name) {
    const field = this.page.locator('#dock-variables').getByRole('textbox', { name, exact: true });
    return (await field.inputValue()).replace('\u2212', '-');
  }
  async variable_is(name, value) {
    const until = Date.now() + SLOW_MS;
    let seen;
    while (Date.now() < until) {
      seen = await this.variable(name).catch(() => undefined);
      if (seen === value) return;
      await this.page.waitForTimeout(150);
    }
    assert.equal(seen, value, `the value of ${name}`);
  }
  /** Each notice answers once: a sentence that still stands from before is not said again. */
  async says(text) {
    await this.until((wanted) => {
      const fresh = [...document.querySelectorAll('.notices p:not([data-heard])')];
      const notice = fresh.find((p) => p.textContent.includes(wanted));
      if (notice) notice.dataset.heard = '';
      return Boolean(notice);
    }, text);
  }

  async says_nothing(text) {
    assert.equal(await this.page.locator('.notices p', { hasText: text }).count(), 0, text);
  }
  /** Of a program of the library. */
  async library_bytes(name) {
    const answer = await fetch(new URL(`library/${encodeURIComponent(name)}`, this.base));
    return Buffer.from(await answer.arrayBuffer());
  }

  // Doing

  key(name) {
    return this.page.locator('.operator').getByRole('button', { name, exact: true });
  }
  async press(name) {
    await this.key(name).click();
  }
  /** The line that the machine tells, in sight or not; 0: none. */
  async told_line() {
    const told = (await this.page.locator('header .program').textContent()) ?? '';
    return Number(/line (\d+)/.exec(told)?.[1] ?? 0);
  }
  /** Steps with Into until the line is next. */
  async step_into(line) {
    for (let steps = 0; steps < 12; steps++) {
      const before = await this.told_line();
      if (before === line) break;
      await this.press('Into');
      const late = Date.now() + SLOW_MS;
      while (
        ((await this.told_line()) === before || (await this.status()) !== 'STEP') &&
        Date.now() < late
      )
        await this.page.waitForTimeout(POLL_MS);
    }
    await this.executes_line(line);
  }
  async operates() {
    await this.page.locator('header .badge.mine').waitFor();
  }
  tab(name) {
    return this.page.locator('.dock').getByRole('tab', { name }).click();
  }
  training_button(name) {
    return this.page.locator('#dock-training').getByRole('button', { name, exact: true });
  }
  async begin_exercise(title) {
    await this.tab('Training');
    await this.page.locator('#dock-training').getByRole('button', { name: title }).click();
    const check = this.training_button('Check').and(this.page.locator('[aria-disabled="false"]'));
    await this.training_button('Begin').or(check).first().waitFor();
    if (!(await check.count())) await this.training_button('Begin').click();
    await check.waitFor();
  }
  async choose_machine(name) {
    await this.page.locator('header .chosen').click();
    await this.page.locator('.machine', { has: this.page.locator(`b:text-is("${name}")`) }).click();
    await this.page.locator('header .chosen b', { hasText: new RegExp(`^${name}$`) }).waitFor();
  }
  async open_library() {
    await this.page
      .locator('.program .bar')
      .getByRole('button', { name: 'Open', exact: true })
      .click();
    await this.page.getByRole('dialog').waitFor();
  }
  async open_program(name) {
    await this.open_library();
    await this.page.getByRole('dialog').getByRole('button', { name, exact: true }).click();
    await this.page.getByRole('dialog').waitFor({ state: 'detached' });
    await this.page.locator('.file.current', { hasText: name }).waitFor();
    await this.until(
      (n) => document.querySelector('header .program')?.textContent?.includes(n),
      name,
    );
  }
  /** In the tab of the variables, which lists it from then on. */
  async add_variable(name) {
    const add = this.page.getByRole('textbox', { name: 'Set a variable' });
    await add.fill(name);
    await add.press('Enter');
  }
  async set_variable(name, value) {
    await this.add_variable(name);
    const field = this.page.locator('#dock-variables').getByRole('textbox', { name, exact: true });
    await field.fill(value);
    await field.press('Enter');
  }
  /** And waits until it is: the path on the screen may still be that of the program before. */
  async load_taught() {
    await this.page.getByRole('button', { name: 'Load what was taught' }).click();
    await this.page.getByText('taught.tch is loaded.').first().waitFor();
    await this.has_path(1);
  }
  /** A new taught program: where the machine stands, and a line to ten millimetres beside it. */
  async teach_two_points(axis) {
    const button = (name) => this.page.getByRole('button', { name, exact: true });
    const record = this.page
      .getByRole('textbox', { name: 'Another record' })
      .or(this.page.getByRole('combobox', { name: 'Another record' }));
    await button('New').click();
    await this.page.getByLabel('Step, mm').selectOption({ label: '10' });
    await button('Point').click();
    await this.page.locator('.cm-content', { hasText: 'POINT' }).waitFor();
    await record.fill('FEED 1200');
    await button('Insert').click();
    const before = await this.position(axis);
    await this.page.getByRole('button', { name: `Jog ${axis}+` }).click();
    await this.position_is(axis, before + 10);
    await this.has_status('IDLE', 'END', 'STOPPED');
    await button('Line').click();
    await this.page.locator('.cm-content', { hasText: 'LINE' }).waitFor();
    await record.fill('END');
    await button('Insert').click();
    await this.page.locator('.cm-content', { hasText: 'END' }).waitFor();
  }
  /** With the slider. */
  async go_to_instant(time_s) {
    const slider = this.page.getByRole('slider', { name: 'Time of the run' });
    await slider.evaluate((input, value) => {
      input.value = String(value);
      input.dispatchEvent(new Event('input', { bubbles: true }));
    }, time_s);
    await this.page.locator('.instant').waitFor({ state: 'attached' });
  }
  /** On a phone one pane is seen at a time. */
  async pane(name) {
    if (this.page.viewportSize().width > 640) return;
    await this.page.locator('.panes').getByRole('button', { name, exact: true }).click();
  }
  /** Puts a text into the library as an upload does, and opens it. */
  async run_text(name, text) {
    await this.upload(name, text);
    await this.open_program(name);
  }
  async upload(name, text) {
    const answer = await fetch(new URL(`library/${encodeURIComponent(name)}`, this.base), {
      method: 'PUT',
      body: text,
    });
    assert.ok(answer.ok, `${name} is uploaded: ${answer.status}`);
  }
  async toggle_breakpoint(line) {
    await this.go_to_line(line);
    await this.page.keyboard.press('F9');
  }
  async go_to_line(line) {
    await this.page.locator('.cm-content').click();
    await this.page.keyboard.press('Control+Home');
    for (let i = 1; i < line; i++) await this.page.keyboard.press('ArrowDown');
  }
  /** A machine as a test wants to find it: operated, at rest, in AUTO, without breakpoints. */
  async fresh() {
    await this.operates();
    await this.press('Reset');
    await this.has_status('IDLE');
    await this.press('AUTO');
    await this.tab('Stepping');
    const left = this.page.locator('.dock').getByRole('button', { name: /^Remove: / });
    while (await left.count()) await left.first().click();
    await this.tab('Variables');
  }
  frames(count) {
    return this.page.evaluate(
      (n) =>
        new Promise((resolve) => {
          const times = [];
          let before = performance.now();
          const next = (now) => {
            times.push(now - before);
            before = now;
            if (times.length < n) requestAnimationFrame(next);
            else resolve(times.slice(1));
          };
          requestAnimationFrame(next);
        }),
      count,
    );
  }
}
