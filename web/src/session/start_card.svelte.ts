/** The card that greets a newcomer, until he sends it away. */
import { keep, kept } from './browser_memory';

const KEY = 'kerf.start-card';
const AWAY = 'away';

/** A sample of each kind of machine; what is of no such kind takes that of the mills. */
const SAMPLES: Record<string, string> = {
  laser3: 'cardioid.bas',
  laser5: 'tube.tch',
  'laser-xtz': 'lens.bas',
  arm4: 'flower.nc',
};

export const sample_of = (definition: string): string => SAMPLES[definition] ?? 'flanges.nc';

class StartCard {
  shown = $state(kept(KEY) !== AWAY);

  send_away(): void {
    this.shown = false;
    keep(KEY, AWAY);
  }
}

export const start_card = new StartCard();
