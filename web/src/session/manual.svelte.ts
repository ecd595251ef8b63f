/** The manual: which page of it is open. Its pages come with the page, but not before they are asked for. */
import { first_place, type ManualPage, type ManualPlace, places_of_message } from '../logic/manual';
import type { Problem } from '../logic/problems';
import { dialogs } from './dialogs.svelte';
import { documents } from './documents.svelte';
import { panel } from './panel.svelte';
import { problems } from './problems.svelte';

class Manual {
  pages = $state.raw<ManualPage[]>([]);
  place = $state.raw<ManualPlace>(first_place());
  private before: ManualPlace[] = [];

  async open(place: ManualPlace): Promise<void> {
    this.go(place);
    dialogs.show('manual');
    if (!this.pages.length) this.pages = (await import('virtual:manual')).default;
  }

  go(place: ManualPlace): void {
    if (dialogs.open === 'manual') this.before.push(this.place);
    else this.before = [];
    this.place = place;
  }

  back(): void {
    this.place = this.before.pop() ?? this.place;
  }

  /** What F1 means: the alarm that stands, the mistake in the line of the cursor, or the whole. */
  async help(): Promise<void> {
    const here = (one: Problem): boolean =>
      one.file === documents.current && one.line === documents.cursor;
    const asked = panel.state.alarm ?? problems.list.find(here);
    await this.open(asked ? places_of_message(asked)[0] : first_place());
  }
}

export const manual = new Manual();
