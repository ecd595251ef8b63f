/** The page's texts: one table a language, the same keys in each (a test holds that). */
import { en as en_panel } from './en';
import { en_features } from './en_features';
import { en_guide } from './en_guide';
import { en_setup } from './en_setup';
import { en_stock } from './en_stock';
import { en_trust } from './en_trust';
import { en_turning } from './en_turning';
import { zh_hant } from './zh_hant';
import { zh_hant_features } from './zh_hant_features';
import { zh_hant_guide } from './zh_hant_guide';
import { zh_hant_setup } from './zh_hant_setup';
import { zh_hant_stock } from './zh_hant_stock';
import { zh_hant_trust } from './zh_hant_trust';
import { zh_hant_turning } from './zh_hant_turning';

const en = {
  ...en_panel,
  ...en_features,
  ...en_guide,
  ...en_setup,
  ...en_stock,
  ...en_trust,
  ...en_turning,
};
export type TextKey = keyof typeof en;
export type Language = 'en' | 'zh-Hant';

export const TABLES: Record<Language, Record<TextKey, string>> = {
  en,
  'zh-Hant': {
    ...zh_hant,
    ...zh_hant_features,
    ...zh_hant_guide,
    ...zh_hant_setup,
    ...zh_hant_stock,
    ...zh_hant_trust,
    ...zh_hant_turning,
  },
};

/** How each language calls itself. */
export const LANGUAGE_NAMES: Record<Language, string> = { en: 'English', 'zh-Hant': '繁體中文' };

/** `{name}` in a text stands for a value. */
export function text_of(
  language: Language,
  key: TextKey,
  values: Record<string, string | number> = {},
): string {
  return TABLES[language][key].replace(/\{(\w+)\}/g, (whole, name: string) =>
    name in values ? String(values[name]) : whole,
  );
}

/** The first language of the browser that there is a table for. Any Chinese reads the Chinese table. */
export function chosen_language(wishes: readonly string[]): Language {
  const first = wishes.find((wish) => /^(zh|en)/i.test(wish)) ?? 'en';
  return /^zh/i.test(first) ? 'zh-Hant' : 'en';
}
