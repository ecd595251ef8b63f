// What is typed and not saved is never lost without a question: ×, another machine, the page loaded again or closed.
import assert from 'node:assert/strict';
import { LONG } from '../programs.mjs';

const WORK = '(MY UNSAVED WORK)';

async function typed(open, name) {
  const panel = await open();
  await panel.fresh();
  await panel.run_text(name, LONG);
  await panel.go_to_line(2);
  await panel.page.keyboard.press('End');
  await panel.page.keyboard.type(WORK);
  await panel.page.locator('.file.current .dirty').waitFor();
  return panel;
}
const text_with_work = (panel) => panel.page.locator('.cm-content', { hasText: WORK });
const offer = (panel) => panel.page.locator('.draft', { hasText: 'was not saved' });
const choose = (panel, name) =>
  panel.page.locator('dialog.question').getByRole('button', { name, exact: true }).click();

export const drafts = [
  {
    name: 'an edit is there when another machine was chosen and the first again',
    async run({ open }) {
      const panel = await typed(open, 'draft-machine.nc');
      await panel.choose_machine('laser');
      await panel.says('kept as drafts: draft-machine.nc');
      await panel.choose_machine('mill');
      await offer(panel).waitFor();
      assert.equal(await text_with_work(panel).count(), 0, 'the text is that of the machine');
      await offer(panel).getByRole('button', { name: 'Restore' }).click();
      await text_with_work(panel).waitFor();
      await panel.page.locator('.file.current .dirty').waitFor();
    },
  },
  {
    name: 'the page asks before it is left with an edit, and has it when it comes back',
    async run({ open }) {
      const panel = await typed(open, 'draft-reload.nc');
      // Typed while an earlier draft is being written, and left at once: the last letter is kept, too.
      for (let i = 0; i < 20; ++i) await panel.page.keyboard.type('AB');
      let asked = 0;
      panel.page.on('dialog', (dialog) => {
        asked++;
        assert.equal(dialog.type(), 'beforeunload');
        void dialog.accept();
      });
      await panel.page.reload();
      assert.equal(asked, 1, 'the page asks before it is left');
      await panel.is_connected();
      await offer(panel).waitFor();
      // Until it is decided nothing is written over it.
      await panel.page.locator('.cm-content').click();
      await panel.page.keyboard.type('X');
      assert.equal(await panel.page.locator('.file.current .dirty').count(), 0);
      await offer(panel).getByRole('button', { name: 'Restore' }).click();
      await panel.page.locator('.cm-content', { hasText: `${WORK}${'AB'.repeat(20)}` }).waitFor();
      await panel.page.keyboard.press('Control+s');
      await panel.says('draft-reload.nc is saved.');
      await panel.page.reload();
      await panel.is_connected();
      await text_with_work(panel).waitFor();
      assert.equal(await offer(panel).count(), 0, 'what is saved is no draft');
      assert.equal(asked, 1, 'a saved text is left without a question');
    },
  },
  {
    name: 'a page that was closed leaves its edit to the next one, which can discard it',
    async run({ open }) {
      const panel = await typed(open, 'draft-closed.nc');
      await panel.page.waitForTimeout(300);
      const next = await panel.another_page();
      await panel.page.close();
      await offer(next).waitFor();
      await offer(next).getByRole('button', { name: 'Discard' }).click();
      await offer(next).waitFor({ state: 'detached' });
      await next.page.reload();
      await next.is_connected();
      await next.page.locator('.cm-content', { hasText: 'UP AND DOWN' }).waitFor();
      assert.equal(await offer(next).count(), 0);
      assert.equal(await text_with_work(next).count(), 0);
    },
  },
  {
    name: 'the × of a tab asks: leave it, drop the edits, or save',
    async run({ open }) {
      const panel = await typed(open, 'draft-tab.nc');
      const tab = panel.page.locator('li.file', { hasText: 'draft-tab.nc' });
      await panel.upload('beside.nc', LONG);
      const close = tab.getByRole('button', { name: 'Close: draft-tab.nc' });
      if (!(await close.count())) {
        await panel.open_program('beside.nc');
        await tab.getByRole('button').first().click();
      }
      await close.click();
      await choose(panel, 'Leave it');
      await text_with_work(panel).waitFor();
      await close.click();
      await choose(panel, 'Save');
      await tab.waitFor({ state: 'detached' });
      assert.match((await panel.library_bytes('draft-tab.nc')).toString(), /MY UNSAVED WORK/);

      await panel.open_program('draft-tab.nc');
      await panel.go_to_line(2);
      await panel.page.keyboard.type('(SECOND)');
      await panel.page.locator('.file.current .dirty').waitFor();
      await tab.click({ button: 'middle' });
      await choose(panel, 'Drop the edits');
      await tab.waitFor({ state: 'detached' });
      await panel.open_program('draft-tab.nc');
      assert.equal(await panel.page.locator('.cm-content', { hasText: 'SECOND' }).count(), 0);
      assert.equal(await offer(panel).count(), 0);
    },
  },
];
