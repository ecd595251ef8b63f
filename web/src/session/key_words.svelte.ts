/** What a key of the operator's panel has to say: why it was refused, or what it asks before it does something. */
import type { CommandName } from '../logic/keymap';

export interface Offer {
  label: string;
  is_main?: boolean;
  act: () => unknown;
}

export interface KeyWord {
  key: CommandName;
  text: string;
  offers: Offer[];
}

/** A question stays until it is answered. */
const REFUSAL_S = 9;

class KeyWords {
  word = $state.raw<KeyWord | null>(null);

  say(key: CommandName, text: string, offers: Offer[] = []): void {
    const word = { key, text, offers };
    this.word = word;
    if (offers.length) return;
    setTimeout(() => this.word === word && this.clear(), 1000 * REFUSAL_S);
  }

  take(offer: Offer): void {
    this.clear();
    void offer.act();
  }

  clear(): void {
    this.word = null;
  }
}

export const key_words = new KeyWords();
