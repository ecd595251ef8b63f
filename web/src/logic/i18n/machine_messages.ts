/** What the machine itself says, in the language of the page; what a program says is as it has said it. */
import type { Language } from './index';

export const MACHINE_MESSAGES_ZH_HANT: Record<string, string> = {
  'all axes are at their reference points': '所有軸皆在參考點',
  'an interrupt signal came while no M96 was in force: it did nothing':
    '中斷訊號到達時 M96 未生效：訊號沒有作用',
  'machine lock is off: the position is that of the axes again':
    '機械鎖定已解除：座標恢復為各軸的位置',
};

export function machine_message(language: Language, message: string): string {
  return (language === 'zh-Hant' && MACHINE_MESSAGES_ZH_HANT[message]) || message;
}
