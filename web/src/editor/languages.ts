/** The lexers of logic/language as languages of the editor. */
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from '@codemirror/language';
import { Tag } from '@lezer/highlight';
import type { Extension } from '@codemirror/state';
import type { Lexer, TokenKind } from '../logic/language/token';

const KINDS: TokenKind[] = [
  'program',
  'comment',
  'sequence',
  'g-code',
  'm-code',
  'axis',
  'technology',
  'variable',
  'keyword',
  'function',
  'number',
  'string',
  'operator',
  'label',
  'skip',
];

const TAGS = Object.fromEntries(KINDS.map((kind) => [kind, Tag.define()])) as Record<
  TokenKind,
  Tag
>;

const COLOURS: Record<Exclude<TokenKind, 'plain'>, [string, string?]> = {
  program: ['syntax-keyword', '600'],
  comment: ['syntax-comment'],
  sequence: ['syntax-quiet'],
  'g-code': ['syntax-g', '500'],
  'm-code': ['syntax-m', '500'],
  axis: ['syntax-axis'],
  technology: ['syntax-technology'],
  variable: ['syntax-variable'],
  keyword: ['syntax-keyword', '500'],
  function: ['syntax-function'],
  number: ['syntax-axis'],
  string: ['syntax-string'],
  operator: ['syntax-quiet'],
  label: ['syntax-variable', '500'],
  skip: ['syntax-m', '600'],
};

const style = HighlightStyle.define(
  Object.entries(COLOURS).map(([kind, [colour, weight]]) => ({
    tag: TAGS[kind as TokenKind],
    color: `var(--${colour})`,
    fontWeight: weight ?? '400',
  })),
);

export function language_of(lexer: Lexer): Extension {
  const language = StreamLanguage.define<{ in_comment: boolean }>({
    name: lexer.name,
    startState: () => ({ in_comment: false }),
    token(stream, state) {
      if (stream.sol()) state.in_comment = false;
      const token = lexer.next(stream.string, stream.pos, state.in_comment);
      stream.pos = token.end;
      state.in_comment = token.in_comment ?? false;
      return token.kind === 'plain' ? null : token.kind;
    },
    tokenTable: TAGS,
    languageData: lexer.line_comment ? { commentTokens: { line: lexer.line_comment } } : {},
  });
  return [language, syntaxHighlighting(style)];
}
