/** Refusals in words. The server says them in English, with a code and values for who speaks another language. */
import { ALARMS_ZH_HANT } from './alarms_zh_hant';
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
  const told = with_alarm(values);
  return known?.replace(/\{(\w+)\}/g, (whole, name: string) => told[name] ?? whole) ?? sentence;
}

/** Where an alarm is the reason, `why` is its message, and `alarm` its number. */
function with_alarm(values: Record<string, string>): Record<string, string> {
  const { alarm = '', why = '' } = values;
  const [message] = ALARMS_ZH_HANT[alarm] ?? [];
  return message ? { ...values, why: `${message} (${why})` } : values;
}
