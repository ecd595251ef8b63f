/** What the operator's keys do. What the machine refuses is told at the key that was pressed. */
import { type Command, Refusal } from '../logic/connection';
import type { CommandName } from '../logic/keymap';
import type { Mode, StepHow, SwitchName } from '../logic/protocol';
import { documents, type TextDocument } from './documents.svelte';
import { editor_keys } from './editor_keys';
import { key_words, type Offer } from './key_words.svelte';
import { panel, said } from './panel.svelte';
import { problems } from './problems.svelte';
import { t } from './words.svelte';

async function press(
  key: CommandName,
  name: string,
  args: Command = {},
  offers: () => Offer[] = () => [],
): Promise<void> {
  key_words.clear();
  try {
    await panel.ask(name, args);
  } catch (reason) {
    if (!(reason instanceof Refusal)) throw reason;
    key_words.say(key, said(reason), offers());
  }
}

/** Nothing is under way that a start would go on with. */
const begins_anew = (): boolean => ['idle', 'end'].includes(panel.state.status);

/** The program of the machine, where the editor has another text of it. */
const edited = (): TextDocument | undefined =>
  documents.open.find(({ loaded, text }) => loaded !== null && loaded !== text);

const turn_to_auto: Offer = {
  label: '',
  is_main: true,
  act: async () => {
    if (await panel.act('mode', { mode: 'auto' })) await cycle_start();
  },
};

const start = (): Promise<void> =>
  press('cycle-start', 'cycle-start', {}, () =>
    panel.state.mode === 'auto' || !begins_anew()
      ? []
      : [{ ...turn_to_auto, label: t('start.turn-to-auto') }],
  );

async function load_then(document: TextDocument, begin: () => unknown): Promise<void> {
  const shown = documents.current;
  if (shown !== document.name) documents.show(document.name);
  await documents.load_text();
  if (shown !== document.name) documents.show(shown);
  if (!edited()) await begin();
}

/**
 * What begins the program: never with another text than the one that is seen without a question, which stands at the key.
 * `begin` finds its line after the answer.
 */
export async function begin_as_seen(key: CommandName, begin: () => unknown): Promise<void> {
  editor_keys.editor?.flush();
  const document = edited();
  if (!document || !begins_anew()) return void (await begin());
  key_words.say(key, t('start.edited', { name: document.name }), [
    {
      label: t('start.load-and-start'),
      is_main: true,
      act: () => load_then(document, begin),
    },
    { label: t('start.as-loaded'), act: begin },
  ]);
}

export const cycle_start = (): Promise<void> => begin_as_seen('cycle-start', start);

export const feed_hold = (): Promise<void> => press('feed-hold', 'feed-hold');
export const reset = (): Promise<void> => press('reset', 'reset');
export const interrupt = (): Promise<void> => press('interrupt', 'interrupt');
export const set_mode = (mode: Mode): Promise<void> => press(`mode-${mode}`, 'mode', { mode });
export const step = (how: StepHow): Promise<void> => {
  const take = () => press(`step-${how}`, 'step', { how });
  return how === 'back' ? take() : begin_as_seen(`step-${how}`, take);
};
export const toggle = (name: SwitchName): Promise<void> =>
  press(name, 'switch', { switch: name, on: !panel.state.switches[name] });
export const set_skip = (levels: number[]): Promise<void> =>
  press('block-skip', 'block-skip', { levels });

/** The key F8 holds the feed whatever happens; where nothing moves it also goes to the next mistake. */
export function hold_or_next_problem(): void {
  if (panel.moves) return void feed_hold();
  if (panel.operates) void panel.ask('feed-hold').catch(() => null);
  problems.beside(1);
}
