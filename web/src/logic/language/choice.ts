/** Which language a text is in, as the machine itself decides: by its name's ending, by its first word, else the machine's. */
import { basic } from './basic';
import { fanuc } from './fanuc';
import { is_pattern, pattern } from './pattern';
import { teach } from './teach';
import type { Lexer } from './token';

const LEXERS: Lexer[] = [fanuc, basic, teach, pattern];

export function lexer_for(name: string, text: string, dialect: string): Lexer {
  if (is_pattern(name)) return pattern;
  if (/\.bas$/i.test(name)) return basic;
  if (/\.tch$/i.test(name) || /^\s*TEACH\s/i.test(text)) return teach;
  if (/\.(nc|tap|cnc|mpf|ngc|gcode)$/i.test(name)) return fanuc;
  return LEXERS.find((lexer) => lexer.name === dialect) ?? fanuc;
}
