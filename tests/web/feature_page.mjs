// The tab of features and the contour editor as a person has them.
import { join } from 'node:path';

export const DESK = { width: 1440, height: 900 };
export const PHONE = { width: 360, height: 800, touch: true };

export const dock = (panel) => panel.page.locator('#dock-features');
export const row = (panel, id) => dock(panel).locator(`[data-node="${id}"]`);
export const editor = (panel) => panel.page.locator('dialog.full');
export const button = (where, name) => where.getByRole('button', { name, exact: true });
/** Where an element is gripped: its middle, or its corner. */
export const grip = (panel, id, part = 'element') =>
  editor(panel)
    .locator(`[data-element="${id}"][data-part="${part}"]`)
    .locator(part === 'element' ? '.grip' : '.dot');
export const number = (panel, name) => editor(panel).getByRole('textbox', { name, exact: true });
export const line_with = (panel, text) => panel.page.locator('.cm-line', { hasText: text }).first();

export async function shot(panel, shots, name) {
  if (!shots) return;
  const { width, height } = panel.page.viewportSize();
  await panel.page.mouse.move(2, 2);
  await panel.page.waitForTimeout(1500);
  await panel.page.screenshot({ path: join(shots, `${name}-${width}x${height}.png`) });
}

/** Opened as a person does, and seen by somebody who looks at features. */
export async function open_features(panel, name, text) {
  await panel.operates();
  await panel.pane('More');
  await panel.fresh();
  await panel.pane('Program');
  await panel.run_text(name, text);
  await panel.has_path();
  await panel.pane('More');
  await panel.tab('Features');
  await row(panel, 'F1').waitFor();
}

/** By the text of the set-up, as a person may write it. */
export async function set_up(panel, toml) {
  await panel.tab('Set-up');
  const dock = panel.page.locator('#dock-setup');
  await button(dock, 'Text').click();
  const text = dock.getByRole('textbox', { name: 'Set-up' });
  await text.fill(toml);
  await text.press('Tab');
  // The one of an earlier run of the tests may be the same.
  if (await button(dock, 'Set up').isEnabled()) {
    await button(dock, 'Set up').click();
    await panel.says('is kept');
  }
  await panel.tab('Features');
}

export async function edit_contour(panel, id) {
  await row(panel, id).dblclick();
  await editor(panel).waitFor();
}

/** An element or corner, by so many mm of the plan; the hand lets go at the end. */
export async function drag(panel, from, [dx, dy], { lets_go = true } = {}) {
  const scale = Number(await editor(panel).locator('svg[data-scale]').getAttribute('data-scale'));
  const box = await from.boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const { mouse } = panel.page;
  await mouse.move(x, y);
  await mouse.down();
  await mouse.move(x + 0.6 * scale * dx, y - 0.6 * scale * dy, { steps: 3 });
  await mouse.move(x + scale * dx, y - scale * dy, { steps: 3 });
  if (lets_go) await mouse.up();
}

/** What the plan says of what has been snapped to. */
export const snapped_to = (panel) => editor(panel).locator('.plan .now');
/** Of the colours of the picture of the part, in a place of the plan in mm. */
export const shade_at = (panel, picture, [x, y]) =>
  editor(panel)
    .locator(`[data-part-picture="${picture}"]`)
    .evaluate(
      (group, [x, y]) => {
        const point = new DOMPoint(x, y);
        const paths = [...group.querySelectorAll('path')].reverse();
        const seen = paths.find((path) => path.isPointInFill(point));
        return seen?.getAttribute('fill') ?? 'gone';
      },
      [x, y],
    );

export const verified = (panel, where = editor(panel)) =>
  where.getByText('verified', { exact: true }).waitFor();
/** Lines that go and come, with their numbers. */
export const diff_of = (where) =>
  where.locator('.diff').evaluate((diff) =>
    [...diff.querySelectorAll('.removed, .added')].map((row) => {
      const [line, sign, text] = ['.line', '.sign', '.text'].map(
        (part) => row.querySelector(part).textContent,
      );
      return `${line} ${sign[0]}${text}`;
    }),
  );
export const selected = (panel) =>
  dock(panel).locator('[aria-selected="true"]').getAttribute('data-node');

export async function apply(panel, where = editor(panel)) {
  const key = where.getByRole('button', { name: 'Apply', exact: true });
  await panel.until(() => {
    const keys = [...document.querySelectorAll('.outcome .keys .main')];
    return keys.some((one) => !one.disabled);
  });
  await key.click();
}
