/** Laser BASIC (docs/laser-basic.md). */
import { type Lexer, type Rule, first_match } from './token';

const STATEMENTS =
  'LET PRINT INPUT IF THEN ELSE FOR TO STEP NEXT GOTO GOSUB RETURN END LOCAL AND OR NOT'.split(' ');
const MOTION = 'HOME SPEED POWER MOVE LINE ARC CIRCLE'.split(' ');
const FUNCTIONS =
  'SIN COS TAN ASIN ACOS ATN ATAN ATAN2 DEG RAD SQR SQRT EXP LOG ABS SGN INT MIN MAX MOD XPOS YPOS ZPOS MOVED DIST PI'.split(
    ' ',
  );

function word_kind(text: string) {
  const word = text.toUpperCase();
  if (STATEMENTS.includes(word)) return 'keyword' as const;
  if (MOTION.includes(word)) return 'g-code' as const;
  if (FUNCTIONS.includes(word)) return 'function' as const;
  return 'variable' as const;
}

const rules: Rule[] = [
  [/\s+/y, 'plain'],
  [/'.*|REM\b.*/iy, 'comment'],
  [/"[^"]*"?/y, 'string'],
  [/(\d+\.?\d*|\.\d+)(e[-+]?\d+)?/iy, 'number'],
  [/[a-z_][a-z_0-9]*/iy, word_kind],
  [/==|<>|!=|<=|>=|[-+*/%^=<>(),;:]/y, 'operator'],
];

const label = /\s*(\d+(?=\s)|[a-z_][a-z_0-9]*\s*:)/iy;

export const basic: Lexer = {
  name: 'laser-basic',
  example: 'speed(20); move(10, 10)',
  line_comment: "'",
  next(line, start) {
    if (start === 0) {
      label.lastIndex = 0;
      const match = label.exec(line);
      if (match) return { kind: 'label', end: match[0].length };
    }
    return first_match(rules, line, start);
  },
};
