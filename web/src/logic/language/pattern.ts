/** The listing of a pattern (docs/pattern.md): one record a line. */
import { type Lexer, type Rule, first_match } from './token';

const rules: Rule[] = [
  [/\s+/y, 'plain'],
  [/#.*/y, 'comment'],
  [/[FS]\b/y, 'g-code'],
  [/(T1|T2|T3|Z)\b/y, 'axis'],
  [/[-+]?\d+/y, 'number'],
  [/[^\s#]+/y, 'label'],
];

export const pattern: Lexer = {
  name: 'pattern',
  example: 'F T2 4000',
  line_comment: '#',
  next: (line, start) => first_match(rules, line, start),
};

/** The library has the bytes of such a program, and this page its listing, which the server makes of them and reads back. */
export const is_pattern = (name: string): boolean => /\.pat$/i.test(name);
