/** Taught points (docs/teach.md): one record a line. */
import { type Lexer, type Rule, first_match } from './token';

const RECORDS = /(POINT|LINE|ARC|CIRCLE)\b/iy;
const SETTINGS = /(TEACH|UNITS|PERIOD|RADII|FEED|LASER|DWELL|END|ON|OFF|MM|DEG)\b/iy;

const rules: Rule[] = [
  [/[\s,]+/y, 'plain'],
  [/;.*/y, 'comment'],
  [RECORDS, 'g-code'],
  [SETTINGS, 'keyword'],
  [/[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?%?/iy, 'number'],
  [/[^\s,;]+/y, 'label'],
];

export const teach: Lexer = {
  name: 'teach',
  example: 'POINT 300 0 50 0 0',
  line_comment: ';',
  next: (line, start) => first_match(rules, line, start),
};
