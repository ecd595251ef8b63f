/** A page that is narrow shows one pane at a time; a newcomer is greeted in that of the picture. */
import { start_card } from './start_card.svelte';

export const PANES = ['position', 'program', 'picture', 'more'] as const;
export type Pane = (typeof PANES)[number];

const narrow = matchMedia('(max-width: 640px)');

class Phone {
  is_on = $state(narrow.matches);
  pane = $state<Pane>(start_card.shown ? 'picture' : 'position');

  constructor() {
    narrow.addEventListener('change', (event) => (this.is_on = event.matches));
  }
}

export const phone = new Phone();
