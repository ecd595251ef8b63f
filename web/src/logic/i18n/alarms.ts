/** Alarms in words. The server says them in English; for Chinese there is a table by their codes. */
import { ALARMS_ZH_HANT } from './alarms_zh_hant';
import type { Language } from './index';

export interface AlarmWords {
  message: string;
  cause: string;
  remedy: string;
}

/** What has no Chinese entry, as a message of the program itself, stays as the server said it. */
export function alarm_words(language: Language, alarm: AlarmWords & { code: string }): AlarmWords {
  const { message, cause, remedy } = alarm;
  const known = language === 'zh-Hant' ? ALARMS_ZH_HANT[alarm.code] : undefined;
  if (!known) return { message, cause, remedy };
  return { message: `${known[0]} (${message})`, cause: known[1], remedy: known[2] };
}
