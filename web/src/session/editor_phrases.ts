/** What the editor itself says: its words are English, and the page's language may be another. */
import { EDITOR_PHRASES_ZH_HANT } from '../logic/i18n/editor_zh_hant';
import { preferences } from './preferences.svelte';

export const editor_phrases = (): Record<string, string> =>
  preferences.language === 'zh-Hant' ? EDITOR_PHRASES_ZH_HANT : {};
