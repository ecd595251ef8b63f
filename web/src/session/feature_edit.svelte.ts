/** Edits of features before they are made: what they would change, why they cannot be, and the way to make them. */
import type { Refusal } from '../logic/connection';
import { type Edit, edits_name, edits_text } from '../logic/features/edits';
import { Newest } from '../logic/features/newest';
import { type Offer, offer_of, with_offer } from '../logic/features/offers';
import type { EditProblem, Preview } from '../logic/features/preview';
import { after } from './after';
import { documents } from './documents.svelte';
import { features } from './features.svelte';
import { notices } from './notices.svelte';
import { panel, said } from './panel.svelte';
import { t } from './words.svelte';

/** A hand that is still for so long has ended its drag: the result is run and compared. */
const REST_MS = 450;

interface Wish {
  edits: Edit[];
  until: 'paths' | 'verified';
}

class FeatureEdit {
  /** As they are asked for, without the offers that were taken. */
  wished = $state.raw<Edit[]>([]);
  /** What was taken of that which a refusal offers. */
  taken = $state.raw<Offer[]>([]);
  answer = $state.raw<Preview | null>(null);
  /** For what edits the answer is. */
  answered = $state.raw<Edit[]>([]);
  refused = $state('');
  is_busy = $state(false);
  is_applying = $state(false);
  /** How many applied edits can be taken back; null: not known. */
  left = $state<number | null>(null);

  edits = $derived(this.taken.reduce<Edit[]>(with_offer, this.wished));
  problem = $derived<EditProblem | null>(this.answer?.problem ?? null);
  /** The answer is for what is wished now. */
  is_current = $derived(this.answered === this.edits);
  offer = $derived(
    this.problem && this.is_current
      ? offer_of(this.problem.code, (features.document?.calls.length ?? 0) > 0)
      : null,
  );
  is_stale = $derived(documents.is_ahead && documents.current === panel.state.file);
  can_apply = $derived(
    this.edits.length > 0 &&
      this.is_current &&
      this.answer !== null &&
      !this.problem &&
      !this.is_applying &&
      !this.is_stale &&
      panel.operates,
  );

  private call_off: (() => void) | null = null;
  private readonly newest = new Newest<Wish, Preview | string | null>(
    (wish) => this.asked(wish),
    (answer, wish, is_newest) => this.take(answer, wish, is_newest),
  );

  /** `listens`: told each answer that is for the newest edits. */
  listens: ((answer: Preview) => void) | null = null;

  want(edits: Edit[]): void {
    this.wished = edits;
    this.call_off?.();
    if (!edits.length) return this.empty();
    this.ask('paths');
    this.call_off = after(REST_MS, () => this.ask('verified'));
  }

  forget(): void {
    this.taken = [];
    this.want([]);
  }

  /** What a refusal offers. */
  take_offer(offer: Offer): void {
    this.taken = [...this.taken, offer];
    this.want(this.wished);
  }

  async apply(): Promise<boolean> {
    if (!this.can_apply) return false;
    this.is_applying = true;
    this.call_off?.();
    this.newest.forget();
    const text = edits_text(this.edits);
    const answer = await panel.ask('feature_apply', { edits: text }).catch((r: Refusal) => r);
    this.is_applying = false;
    if (!('ok' in answer)) {
      this.refused = said(answer);
      return false;
    }
    this.forget();
    this.left = (this.left ?? 0) + 1;
    await documents.take_loaded(String(answer.name));
    notices.say(t('feature.applied', { name: String(answer.name) }));
    return true;
  }

  async undo(): Promise<void> {
    const answer = await panel.act('feature_undo');
    if (!answer) return;
    this.left = Number(answer.left);
    await documents.take_loaded(String(answer.name));
    notices.say(t('feature.undone', { name: String(answer.name) }));
  }

  /** As the file that `kerf edit` reads. */
  save(): void {
    const link = document.createElement('a');
    const blob = new Blob([edits_text(this.edits)], { type: 'application/json' });
    link.href = URL.createObjectURL(blob);
    link.download = edits_name(panel.state.file);
    link.click();
    URL.revokeObjectURL(link.href);
  }

  private empty(): void {
    this.newest.forget();
    this.answer = null;
    this.refused = '';
  }

  private ask(until: Wish['until']): void {
    this.is_busy = true;
    this.newest.want({ edits: this.edits, until });
  }

  /** Null: another one has come in its place. */
  private async asked({ edits, until }: Wish): Promise<Preview | string | null> {
    const text = edits_text(edits);
    const answer = await panel
      .ask('feature_preview', { edits: text, until })
      .catch((reason: Refusal) => reason);
    if ('ok' in answer) return answer as unknown as Preview;
    return answer.code === REPLACED ? null : said(answer);
  }

  private take(answer: Preview | string | null, { edits }: Wish, is_newest: boolean): void {
    if (is_newest) this.is_busy = false;
    if (answer === null || !this.wished.length) return;
    if (typeof answer === 'string') {
      this.refused = answer;
      return;
    }
    this.refused = '';
    this.answer = with_paths(answer, this.answer, edits === this.answered);
    this.answered = edits;
    if (edits === this.edits) this.listens?.(this.answer);
  }
}

const REPLACED = 'preview-replaced';

/** One that is verified tells the report, and perhaps not again what stands already. */
function with_paths(answer: Preview, before: Preview | null, is_of_same: boolean): Preview {
  return is_of_same && before && !answer.problem ? { ...before, ...answer } : answer;
}

export const feature_edit = new FeatureEdit();
