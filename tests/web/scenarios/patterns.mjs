// The engraver's own data on the panel: the bytes are shown as their listing, run, edited and saved as bytes.
import assert from 'node:assert/strict';

const BYTES = Buffer.from('7F00C83F0FA0400CA7FF00C8', 'hex');

const text = (panel) =>
  panel.page
    .locator('.cm-line')
    .allInnerTexts()
    .then((lines) => lines.join('\n').trimEnd());

export const patterns = [
  {
    name: 'a pattern is opened on the machine that counts pulses, run, held, edited and saved as bytes',
    async run({ open }) {
      const panel = await open();
      await panel.fresh();
      await panel.upload('figure.pat', BYTES);
      // On the mill: another machine is offered.
      await panel.open_library();
      await panel.page
        .getByRole('dialog')
        .getByRole('button', { name: 'figure.pat', exact: true })
        .click();
      await panel.page.getByRole('button', { name: 'Open it on arm' }).click();
      await panel.page.locator('header .chosen b', { hasText: /^arm$/ }).waitFor();
      await panel.until(
        () =>
          document.querySelector('header .program')?.textContent?.includes('figure.pat') ?? false,
      );
      await panel.operates();
      await panel.page.locator('.cm-content', { hasText: 'F T2 4000' }).waitFor();
      assert.equal(await text(panel), 'F Z 200\nF T2 4000\nS 0 12 -7\nF Z -200');
      await panel.has_path();
      await panel.fresh();
      await panel.press('Cycle start');
      await panel.executes_line(2);
      await panel.press('Feed hold');
      await panel.has_status('HOLD');
      await panel.press('Cycle start');
      await panel.has_status('END');

      // A record more, and a comment, which bytes cannot hold.
      await panel.go_to_line(4);
      await panel.page.keyboard.press('End');
      await panel.page.keyboard.insertText('\nF T3 -120 # turn the wheel');
      await panel.page.locator('.file.current .dirty').waitFor();
      await panel.page.keyboard.press('Control+s');
      await panel.says('figure.pat is kept as the bytes of its records');
      await panel.says('figure.pat is saved.');
      assert.equal(await text(panel), 'F Z 200\nF T2 4000\nS 0 12 -7\nF Z -200\nF T3 -120');
      assert.deepEqual(
        await panel.library_bytes('figure.pat'),
        Buffer.concat([BYTES, Buffer.from('DF0078', 'hex')]),
      );

      // It stands where the pattern has ended: the next one begins at the zero of the motors.
      await panel.press('Reset');
      await panel.press('Cycle start');
      await panel.page
        .getByText('bring the axes to their reference points first')
        .first()
        .waitFor();

      // A wrong record cannot be saved, and is marked.
      await panel.page.locator('.cm-content').click();
      await panel.page.keyboard.press('Control+End');
      await panel.page.keyboard.insertText('\nF Q 1');
      await panel.page.locator('.cm-lint-marker-error').first().waitFor();
      await panel.page.keyboard.press('Control+s');
      await panel.page
        .getByText('figure.pat cannot be saved as a pattern: line 6')
        .first()
        .waitFor();
    },
  },
];
