/** The page's texts in the language that is chosen now. */
import { type TextKey, text_of } from '../logic/i18n';
import { preferences } from './preferences.svelte';

export const t = (key: TextKey, values: Record<string, string | number> = {}): string =>
  text_of(preferences.language, key, values);
