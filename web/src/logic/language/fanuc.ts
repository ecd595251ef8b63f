/** FANUC G-code with Custom Macro B: words of an address and a number, macro statements, comments in brackets. */
import { type Lexer, type Rule, type TokenKind, first_match } from './token';

const KEYWORD = /(IF|THEN|GOTO|WHILE|DO|END|POPEN|PCLOS|DPRNT|BPRNT|SETVN)(?=[^A-Z]|$)/iy;
const RELATION = /(EQ|NE|GT|GE|LT|LE|AND|OR|XOR|MOD)(?=[^A-Z]|$)/iy;
const FUNCTION =
  /(SIN|COS|TAN|ASIN|ACOS|ATAN|SQRT|ABS|BIN|BCD|ROUND|FIX|FUP|LN|EXP|POW|ADP|PRM)(?=\s*[[/]|\d|$)/iy;

const rules: Rule[] = [
  [/\s+/y, 'plain'],
  // What DPRNT and BPRNT print is text but for its variables.
  [/(?<=[DB]PRNT\[[^#]*)[^#\[\]]+/iy, 'string'],
  [/(?<=[DB]PRNT\[.*\])[^#\[\]]+(?=.*\])/iy, 'string'],
  [/%.*/y, 'program'],
  [/#\d+|#_[A-Z0-9_]+(\[\d+\])?|#/iy, 'variable'],
  [KEYWORD, 'keyword'],
  [/(GE|GT|LE|LT|EQ|NE|AND|OR|XOR|MOD)/iy, 'operator'],
  [RELATION, 'operator'],
  [FUNCTION, 'function'],
  [/O\d+|:\d+/iy, 'program'],
  [/N\d+/iy, 'sequence'],
  [/G\d*\.?\d*/iy, 'g-code'],
  [/M\d*/iy, 'm-code'],
  [/[XYZUVWABCIJKRQ](?=[-+.\d[#\s]|$)[-+]?\d*\.?\d*/iy, 'axis'],
  [/[FSTHDPLE](?=[-+.\d[#\s]|$)[-+]?\d*\.?\d*/iy, 'technology'],
  [/\d+\.?\d*|\.\d+/y, 'number'],
  [/[-+*/=[\]<>,;]/y, 'operator'],
];

function skip_or_divide(line: string, start: number): TokenKind {
  return line.slice(0, start).trim().replace(/^N\d+/i, '').trim() === '' ? 'skip' : 'operator';
}

export const fanuc: Lexer = {
  name: 'fanuc-mill',
  example: 'G91 G01 X10. F500',
  next(line, start, in_comment) {
    if (in_comment || line[start] === '(') return comment(line, start);
    if (line[start] === '/') {
      const kind = skip_or_divide(line, start);
      const digit = kind === 'skip' && /[1-9]/.test(line[start + 1] ?? '') ? 1 : 0;
      return { kind, end: start + 1 + digit };
    }
    return first_match(rules, line, start);
  },
};

/** A comment ends with its bracket, at the latest with its line. */
function comment(line: string, start: number) {
  const close = line.indexOf(')', start);
  return { kind: 'comment' as const, end: close < 0 ? line.length : close + 1 };
}
