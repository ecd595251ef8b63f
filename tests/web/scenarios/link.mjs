// The line to the server hangs, breaks and comes back; two people at one machine.
import assert from 'node:assert/strict';
import { LONG } from '../programs.mjs';

export const link = [
  {
    name: 'a server that hangs is told within seconds, keys are dead, and nothing happens when it goes on',
    needs_server: true,
    async run({ open, server }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('hangs.nc', LONG);
      const banner = panel.page.locator('.line[role="alert"]');
      const frozen = async (act) => {
        server.freeze();
        try {
          await act();
        } finally {
          server.thaw();
        }
        await banner.waitFor({ state: 'detached' });
      };
      // A key that is pressed at once is sent, waits, and shows that it waits.
      await frozen(async () => {
        await panel.press('Cycle start');
        await panel.page.locator('.key.waiting', { hasText: 'Cycle start' }).waitFor();
        await banner.filter({ hasText: 'No link since' }).waitFor();
        await banner.filter({ hasText: 'Last known: idle' }).waitFor();
        assert.ok(await panel.key('Cycle start').isDisabled(), 'its keys are dead');
        assert.ok(await panel.key('Feed hold').isDisabled());
        assert.equal(await panel.status(), 'NO LINK');
        const struck = await panel.page
          .locator('aside .big')
          .first()
          .evaluate((e) => getComputedStyle(e).textDecorationLine);
        assert.equal(struck, 'line-through', 'the values are struck out');
        await panel.page.keyboard.press('Control+Enter');
        await panel.page.locator('.key-word', { hasText: 'nothing was sent' }).waitFor();
      });
      await panel.operates();
      await panel.page.waitForTimeout(1500);
      assert.equal(await panel.status(), 'IDLE', 'the key of then does nothing now');
      // What it does is known again, and keys work.
      await panel.press('Cycle start');
      await panel.has_status('RUNNING');
      await panel.passes('X', 0);
      await frozen(() => banner.filter({ hasText: /Last known: running, line \d/ }).waitFor());
      await panel.has_status('RUNNING');
      await panel.press('Feed hold');
      await panel.has_status('HOLD');
      await panel.press('Reset');
    },
  },
  {
    name: 'a server that was killed is told in words of what is known, and that the run was ended',
    needs_server: true,
    async run({ open, server }) {
      const panel = await open();
      await panel.fresh();
      await panel.run_text('killed.nc', LONG);
      await panel.press('Cycle start');
      await panel.has_status('RUNNING');
      await panel.passes('X', 0);
      await server.kill();
      const banner = panel.page.locator('.line[role="alert"]');
      try {
        await banner.filter({ hasText: /No link since \d\d:\d\d:\d\d\./ }).waitFor();
        await banner.filter({ hasText: /Last known: running, line \d/ }).waitFor();
        assert.ok(!(await banner.innerText()).includes('goes on'), 'nobody knows what it does');
        assert.equal(await panel.status(), 'NO LINK');
      } finally {
        await server.begin();
      }
      await panel.is_connected();
      const restart = panel.page.locator('.restart');
      await restart
        .filter({ hasText: /started again at \d\d:\d\d:\d\d: the run was ended/ })
        .waitFor();
      await restart.getByRole('button', { name: 'Seen' }).click();
      await restart.waitFor({ state: 'detached' });
      await panel.operates();
    },
  },
  {
    name: 'a colleague asks for the machine by name: refused, handed over, or granted after ten seconds',
    async run({ open }) {
      const first = await open();
      await first.fresh();
      const second = await open();
      const badge = (panel) => panel.page.locator('header .badge');
      await badge(second)
        .filter({ hasText: /page \d+ operates/ })
        .waitFor();
      await badge(second).click();
      const ask = second.page.getByRole('button', { name: /^Ask page \d+ for the machine$/ });
      assert.ok(await ask.isDisabled(), 'who asks says who he is');
      await second.page.getByLabel('Your name').fill('Lee');
      await ask.click();
      const request = first.page.locator('.request');
      await request.filter({ hasText: 'Lee asks for the machine.' }).waitFor();
      await request.getByRole('button', { name: 'Keep it' }).click();
      await second.says('The operator keeps the machine.');
      await first.operates();

      await second.page.keyboard.press('Alt+t');
      await request.getByRole('button', { name: 'Hand over' }).click();
      await second.operates();
      await badge(first).filter({ hasText: 'Lee operates' }).waitFor();

      await first.page.locator('h1').click();
      await first.page.keyboard.press('Alt+t');
      await first.page.locator('.request', { hasText: 'Lee is asked' }).waitFor();
      await second.page
        .locator('.request', { hasText: /asks for the machine.*\b[1-9] s/ })
        .waitFor();
      await first.operates(); // nobody has answered
      await badge(second)
        .filter({ hasText: /page \d+ operates/ })
        .waitFor();

      // The name is asked once.
      await second.page.reload();
      await second.is_connected();
      await badge(first).click();
      await first.page.getByRole('button', { name: 'Hand over to Lee' }).waitFor();
    },
  },
];
