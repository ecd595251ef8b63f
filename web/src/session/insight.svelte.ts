/** The card that tells what a program is like when it opens: once for each program that is loaded, until it is sent away. */
import type { Insight } from '../logic/features/insight';
import { keep, kept } from './browser_memory';
import { panel } from './panel.svelte';
import { start_card } from './start_card.svelte';

const KEY = 'kerf.insight-card';
const AWAY = 'away';
/** Until features are recognised and the preview has run to its end. */
const AGAIN_MS = 700;
const MOST_QUESTIONS = 20;

class InsightCard {
  facts = $state.raw<Insight | null>(null);
  is_shown = $state(false);
  /** A person who wants no card at all. */
  is_wanted = $state(kept(KEY) !== AWAY);
  private of = '';
  private questions = 0;
  private epoch = 0;

  /** A program is loaded. One that a machine has when the page comes to it (`epoch`) has been opened before. */
  async opened(program: string, epoch: number): Promise<void> {
    if (program === this.of) return;
    this.of = program;
    const has_come = epoch !== this.epoch;
    this.epoch = epoch;
    this.facts = null;
    this.is_shown = false;
    this.questions = 0;
    // Who is greeted has a card already, which says what comes next.
    const is_wanted = this.is_wanted && !start_card.shown;
    if (program && is_wanted && !has_come) await this.ask(program);
  }

  /** From the tab, also for who wants no cards. */
  async show(): Promise<void> {
    this.questions = 0;
    await this.ask(this.of);
  }

  close(): void {
    this.is_shown = false;
  }

  never_again(): void {
    this.is_wanted = this.is_shown = false;
    keep(KEY, AWAY);
  }

  private async ask(program: string): Promise<void> {
    const answer = await panel.ask('insight').catch(() => null);
    if (!answer || program !== this.of) return;
    this.facts = answer as unknown as Insight;
    if (this.questions === 0) this.is_shown = true;
    this.questions++;
    const is_all = this.facts.features !== null && this.facts.time_s !== null;
    if (is_all || this.questions >= MOST_QUESTIONS || !this.is_shown) return;
    setTimeout(() => program === this.of && this.is_shown && void this.ask(program), AGAIN_MS);
  }
}

export const insight = new InsightCard();
