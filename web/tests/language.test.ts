import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { basic } from '../src/logic/language/basic';
import { lexer_for } from '../src/logic/language/choice';
import { fanuc } from '../src/logic/language/fanuc';
import { teach } from '../src/logic/language/teach';
import { tokens_of } from '../src/logic/language/token';

const kinds = (lexer: typeof fanuc, line: string) =>
  tokens_of(lexer, line).map(({ kind, text }) => `${text}:${kind}`);

describe('G-code', () => {
  it('without blanks falls into words', () => {
    expect(kinds(fanuc, 'N10G90G01X-10.5Y.5F200M08')).toEqual([
      'N10:sequence',
      'G90:g-code',
      'G01:g-code',
      'X-10.5:axis',
      'Y.5:axis',
      'F200:technology',
      'M08:m-code',
    ]);
  });
  it('has macro statements with operators glued to variables', () => {
    expect(kinds(fanuc, 'IF[#33GE#13]GOTO2').join(' ')).toBe(
      'IF:keyword [:operator #33:variable GE:operator #13:variable ]:operator GOTO:keyword 2:number',
    );
    expect(kinds(fanuc, 'WHILE[#32LT#6]DO1')).toContain('DO:keyword');
  });
  it('tells functions from axes', () => {
    expect(kinds(fanuc, 'X[#18*COS[#31]]')).toEqual([
      'X:axis',
      '[:operator',
      '#18:variable',
      '*:operator',
      'COS:function',
      '[:operator',
      '#31:variable',
      ']:operator',
      ']:operator',
    ]);
  });
  it('skips a block by the slash at its head, and divides by any other', () => {
    expect(kinds(fanuc, '/2 N5 G00')[0]).toBe('/2:skip');
    expect(kinds(fanuc, '#1=#2/2')).toContain('/:operator');
  });
  it('has comments that end with their bracket', () => {
    expect(kinds(fanuc, 'G00 (TO THE CORNER) X1.')).toEqual([
      'G00:g-code',
      '(TO THE CORNER):comment',
      'X1.:axis',
    ]);
    expect(kinds(fanuc, '(OPEN')).toEqual(['(OPEN:comment']);
  });
});

describe('laser BASIC', () => {
  it('has statements, functions, variables and texts', () => {
    expect(kinds(basic, 'if i=0 then move(r*COS(a),0): print "x"')).toEqual([
      'if:keyword',
      'i:variable',
      '=:operator',
      '0:number',
      'then:keyword',
      'move:g-code',
      '(:operator',
      'r:variable',
      '*:operator',
      'COS:function',
      '(:operator',
      'a:variable',
      '):operator',
      ',:operator',
      '0:number',
      '):operator',
      '::operator',
      'print:keyword',
      '"x":string',
    ]);
  });
  it('has labels at the beginning of a line and comments to its end', () => {
    expect(kinds(basic, "koch: d=1 ' one third")).toEqual([
      'koch::label',
      'd:variable',
      '=:operator',
      '1:number',
      "' one third:comment",
    ]);
    expect(kinds(basic, '100 next')[0]).toBe('100:label');
  });
});

it('taught points have records, numbers and names', () => {
  expect(kinds(teach, 'POINT 1 -2.5 3 90 55.6 above ; there')).toEqual([
    'POINT:g-code',
    '1:number',
    '-2.5:number',
    '3:number',
    '90:number',
    '55.6:number',
    'above:label',
    '; there:comment',
  ]);
});

it('the ending of the name decides, then the text, then the machine', () => {
  expect(lexer_for('a.bas', '', 'fanuc-mill')).toBe(basic);
  expect(lexer_for('a.NC', 'x', 'laser-basic')).toBe(fanuc);
  expect(lexer_for('a', 'TEACH 1', 'fanuc-mill')).toBe(teach);
  expect(lexer_for('a', 'speed(1)', 'laser-basic')).toBe(basic);
  expect(lexer_for('', '', 'unknown')).toBe(fanuc);
});

describe('every example', () => {
  const folder = join(__dirname, '../../examples');
  const files = readdirSync(folder, { recursive: true })
    .map(String)
    .filter((f) => /\.(nc|bas|tch)$/.test(f));
  it('is there to be read', () => expect(files.length).toBeGreaterThan(10));
  it.each(files)('%s has no character without a meaning', (file) => {
    const text = readFileSync(join(folder, file), 'utf8');
    const lexer = lexer_for(file, text, '');
    for (const line of text.split(/\r?\n/)) {
      const lost = tokens_of(lexer, line).filter(({ kind }) => kind === 'plain');
      expect(lost, line).toEqual([]);
    }
  });
});
