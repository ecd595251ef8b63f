/** What the built-in machines are, in the language of the page; one of the user's own is as he has written it. */
import type { Language } from './index';

export const MACHINE_TITLES_ZH_HANT: Record<string, string> = {
  'two-link engraving arm, driven T1 T2 T3 Z, programs in X Y Z C':
    '雙連桿雕刻手臂，驅動軸 T1 T2 T3 Z，程式軸 X Y Z C',
  'stepped X Y with a wheel C and a lift Z': '步進 X Y，附轉輪 C 與升降軸 Z',
  'laser over a turning work, driven X C Z, programs in X Y Z':
    '旋轉工件雷射，驅動軸 X C Z，程式軸 X Y Z',
  'laser engraver, X Y, Z for focus': '雷射雕刻機，X Y 軸，Z 軸對焦',
  'vertical machining centre, X Y Z': '立式加工中心，X Y Z',
  'vertical machining centre with a rotary table, X Y Z A': '立式加工中心附旋轉台，X Y Z A',
  'vertical machining centre with a tilting rotary table, X Y Z A C':
    '立式加工中心附傾斜旋轉台，X Y Z A C',
  'lathe, X Z': '車床，X Z',
  'lathe with a C axis, X Z C': '車床附 C 軸，X Z C',
  'five-axis laser with an A/C head, X Y Z A C': '五軸雷射，A/C 擺頭，X Y Z A C',
};

export function machine_title(language: Language, title: string): string {
  return (language === 'zh-Hant' && MACHINE_TITLES_ZH_HANT[title]) || title;
}
