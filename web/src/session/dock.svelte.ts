/** Which tab of the dock is open. */
export const TABS = [
  'problems',
  'features',
  'setup',
  'variables',
  'stepping',
  'mdi',
  'teach',
  'offsets',
  'tools',
  'messages',
  'pulses',
  'speed',
  'training',
] as const;
export type Tab = (typeof TABS)[number];

class Dock {
  tab = $state<Tab>('variables');

  turn(by: 1 | -1): void {
    const at = TABS.indexOf(this.tab);
    this.tab = TABS[(at + by + TABS.length) % TABS.length];
  }
}

export const dock = new Dock();
