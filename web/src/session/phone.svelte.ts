/** A page that is narrow shows one pane at a time. */
export const PANES = ['position', 'program', 'picture', 'more'] as const;
export type Pane = (typeof PANES)[number];

const narrow = matchMedia('(max-width: 640px)');

class Phone {
  is_on = $state(narrow.matches);
  pane = $state<Pane>('position');

  constructor() {
    narrow.addEventListener('change', (event) => (this.is_on = event.matches));
  }
}

export const phone = new Phone();
