/** A question that the page asks before it does something that cannot be taken back: one at a time, over everything else. */

export interface Choice {
  /** What the answer is; the same word in a test. */
  answer: string;
  label: string;
  tone?: 'main' | 'danger';
}

interface Asked {
  title: string;
  text: string;
  choices: Choice[];
  settle: (answer: string | null) => void;
}

class Question {
  asked = $state.raw<Asked | null>(null);

  /** The answer that was chosen; null: the question was closed. One that is open is closed by the next. */
  ask(title: string, text: string, choices: Choice[]): Promise<string | null> {
    this.answer(null);
    return new Promise((settle) => (this.asked = { title, text, choices, settle }));
  }

  answer(answer: string | null): void {
    const { asked } = this;
    this.asked = null;
    asked?.settle(answer);
  }
}

export const question = new Question();
