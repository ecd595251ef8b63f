/** Refusals in words. The server says them in English, with a code and values for who speaks another language. */
import type { Language } from './index';
import { REFUSALS_ZH_HANT } from './refusals_zh_hant';

/** One without a code, or with one that is not known, stays as the server said it. */
export function refusal_words(
  language: Language,
  sentence: string,
  code: string | undefined,
  values: Record<string, string> = {},
): string {
  const known = language === 'zh-Hant' && code ? REFUSALS_ZH_HANT[code] : undefined;
  return known?.replace(/\{(\w+)\}/g, (whole, name: string) => values[name] ?? whole) ?? sentence;
}
