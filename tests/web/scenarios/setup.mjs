// The set-up in its forms: what is entered stands in the text, what cannot be is told, and nothing is given to the server so.
import assert from 'node:assert/strict';
import { AXE, findings } from './accessibility.mjs';

const DESK = { width: 1440, height: 900 };
const PHONE = { width: 360, height: 740, touch: true };

const dock = (panel) => panel.page.locator('#dock-setup');

async function fill(panel, name, value) {
  const field = dock(panel).getByLabel(name, { exact: true });
  await field.fill(String(value));
  await field.press('Tab');
}

const choose = (panel, name, value) =>
  dock(panel).getByRole('combobox', { name, exact: true }).selectOption(value);

const unfold = (panel, words) => dock(panel).locator('summary', { hasText: words }).first().click();

async function open_forms(panel) {
  await panel.operates();
  await panel.has_program();
  if (panel.page.viewportSize().width < 600)
    await panel.page.getByRole('button', { name: 'More', exact: true }).click();
  await panel.tab('Set-up');
  await dock(panel).getByRole('button', { name: 'Add a clamp' }).waitFor();
}

async function text_of(panel) {
  await dock(panel).getByRole('button', { name: 'Text', exact: true }).click();
  const text = await dock(panel).getByRole('textbox', { name: 'Set-up' }).inputValue();
  await dock(panel).getByRole('button', { name: 'Forms' }).click();
  return text.replace(/\s+/g, ' ');
}

const at_size = (size) => ({
  name: `what the forms of the set-up are told stands in its text (${size.width} px)`,
  async run({ open }) {
    const panel = await open(size);
    await open_forms(panel);
    await choose(panel, 'Material: Group', 'own');
    await fill(panel, 'Material: Exponent mc', 0.3);
    await unfold(panel, 'Place of the stock');
    await fill(panel, 'Place of the stock: Z', 4);
    await fill(panel, 'Place of the stock: C', 90);
    await fill(panel, 'Checks: Touch tolerance', 0.02);
    await choose(panel, 'Checks: A run fails at', 'error');
    await unfold(panel, 'checks are made');
    await dock(panel).getByRole('checkbox', { name: 'Nothing was cut' }).click();
    await dock(panel).getByText('24 of 25 checks are made').waitFor();
    await fill(panel, 'Design: File', 'part.stl');
    await fill(panel, 'Design: Tolerance', 0.1);
    await dock(panel).getByRole('button', { name: 'Add tool' }).click();
    await unfold(panel, 'Limits');
    await fill(panel, 'Tool 1: Depth ap', 6);

    const text = await text_of(panel);
    for (const words of [
      'kc11 = 1700 mc = 0.3',
      'place = [ 0, 0, 4, 0, 0, 90 ]',
      'touch_mm = 0.02',
      'no_check = [ "STOCK_MISSED" ]',
      'fail_on = "error"',
      '[design] file = "part.stl" tolerance = 0.1',
      '[tool.limits] ap = 6',
    ])
      assert.ok(text.includes(words), `${words} is not in: ${text}`);
    const wide = await panel.page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= size.width, `the page is ${wide} px wide`);
    await panel.page.evaluate(AXE);
    assert.deepEqual(await findings(panel, 'set-up'), []);
  },
});

export const setup = [
  at_size(DESK),
  at_size(PHONE),
  {
    name: 'what cannot be set up is told, and is not given to the server',
    async run({ open }) {
      const panel = await open(DESK);
      await open_forms(panel);
      const take = dock(panel).getByRole('button', { name: 'Set up' });
      const sentence = (words) => dock(panel).getByRole('alert').filter({ hasText: words });
      for (const [name, wrong, words, right] of [
        ['Design: Tolerance', '0.1', 'needs the file of the design', ''],
        ['Design: File', 'part.step', 'is an STL file', ''],
        ['Checks: Touch tolerance', '2', 'from 0.001 to 1', '0.05'],
        ['Checks: Touch tolerance', 'wide', 'from 0.001 to 1', '0.05'],
      ]) {
        await fill(panel, name, wrong);
        await sentence(words).waitFor();
        assert.ok(await take.isDisabled(), `${name} ${wrong}`);
        await fill(panel, name, right);
        await sentence(words).waitFor({ state: 'detached' });
      }
      assert.ok(await take.isEnabled());
      await dock(panel).getByRole('button', { name: 'Discard changes' }).click();
      assert.ok(await take.isDisabled());
    },
  },
];
