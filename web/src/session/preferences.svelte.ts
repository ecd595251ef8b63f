/** What a person has set for himself, kept by his browser. */
import { type Language, chosen_language } from '../logic/i18n';
import type { Colouring, Scheme } from '../logic/colour_scale';
import { keep, kept_value } from './browser_memory';

export type Theme = 'system' | Scheme;

interface Stored {
  theme: Theme;
  language: Language;
  colouring: Colouring;
  show_rapids: boolean;
  show_travel: boolean;
  show_stock: boolean;
  /** The path, while the part is shown. */
  show_path: boolean;
  /** A picture at rest has the finest cells. */
  stock_fine: boolean;
  follow: boolean;
  editor_share: number;
  dock_px: number;
  jog_mm_min: number;
  jog_step: number;
  watches: string[];
  /** A change of an offset or a tool by more than this, mm or °, is asked about. */
  ask_above: number;
  /** As the person at this browser is called; empty: he has not said it. */
  person: string;
  /** The best of each exercise. */
  scores: Record<string, number>;
}

const KEY = 'kerf.preferences';

/** Of a browser that has chosen nothing yet; its language is asked for as well. */
const AT_FIRST: Omit<Stored, 'language'> = {
  theme: 'system',
  colouring: 'tool',
  show_rapids: true,
  show_travel: true,
  show_stock: true,
  show_path: false,
  stock_fine: true,
  follow: true,
  editor_share: 0.34,
  dock_px: 208,
  jog_mm_min: 1000,
  jog_step: 0,
  watches: [],
  ask_above: 10,
  person: '',
  scores: {},
};

const defaults = (): Stored => ({
  ...structuredClone(AT_FIRST),
  language: chosen_language(navigator.languages),
});

export const preferences = $state<Stored>({
  ...defaults(),
  ...kept_value<Partial<Stored>>(KEY, {}),
});

const asks_for_light = matchMedia('(prefers-color-scheme: light)');
let system_scheme = $state<Scheme>(asks_for_light.matches ? 'light' : 'dark');
asks_for_light.addEventListener('change', (e) => (system_scheme = e.matches ? 'light' : 'dark'));

export const scheme = (): Scheme =>
  preferences.theme === 'system' ? system_scheme : preferences.theme;

/** Keeps what changes; called once by the page. */
export function keep_preferences(): void {
  $effect(() => keep(KEY, JSON.stringify(preferences)));
}
