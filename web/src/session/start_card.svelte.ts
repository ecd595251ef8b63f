/** The card that greets a newcomer, until he sends it away. */
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

function is_away(): boolean {
  try {
    return localStorage.getItem(KEY) === AWAY;
  } catch {
    return false;
  }
}

class StartCard {
  shown = $state(!is_away());

  send_away(): void {
    this.shown = false;
    try {
      localStorage.setItem(KEY, AWAY);
    } catch {
      // A browser that keeps nothing is greeted each time.
    }
  }
}

export const start_card = new StartCard();
