// The server is killed and comes back; the page says so and goes on.
export const faults = [
  {
    name: 'the page tells that the server is away, comes back by itself, and nothing durable is lost',
    needs_server: true,
    async run({ open, server }) {
      const panel = await open();
      await panel.fresh();
      await panel.tab('Variables');
      const add = panel.page.getByRole('textbox', { name: 'Set a variable' });
      await add.fill('#511');
      await add.press('Enter');
      await panel.variable_is('#511', '0');
      const field = panel.page
        .locator('#dock-variables')
        .getByRole('textbox', { name: '#511', exact: true });
      await field.fill('77');
      await field.press('Enter');
      await panel.variable_is('#511', '77');
      await server.kill();
      await panel.page.locator('.line[role="alert"]', { hasText: 'No link since' }).waitFor();
      await server.begin();
      await panel.is_connected();
      await panel.variable_is('#511', '77');
    },
  },
  {
    name: 'the page shows that the memory is not on the disk, as long as it is so',
    needs_server: true,
    async run({ open, server }) {
      const panel = await open();
      await panel.fresh();
      const notice = panel.page.getByText('are not on the disk of the server');
      await panel.tab('Variables');
      const add = panel.page.getByRole('textbox', { name: 'Set a variable' });
      server.fill_disk(true);
      try {
        await add.fill('#512');
        await add.press('Enter');
        await notice.waitFor();
      } finally {
        server.fill_disk(false);
      }
      await notice.waitFor({ state: 'detached' });
    },
  },
];
