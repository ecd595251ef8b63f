/** What the editor colours. A lexer is a pure function: text of a line, place in it, state behind the token before. */

export type TokenKind =
  | 'program'
  | 'comment'
  | 'sequence'
  | 'g-code'
  | 'm-code'
  | 'axis'
  | 'technology'
  | 'variable'
  | 'keyword'
  | 'function'
  | 'number'
  | 'string'
  | 'operator'
  | 'label'
  | 'skip'
  | 'plain';

export interface Token {
  kind: TokenKind;
  /** Column behind the token. */
  end: number;
  /** An open comment goes on in the next line. */
  in_comment?: boolean;
}

export interface Lexer {
  name: string;
  /** What a line of it looks like. */
  example: string;
  /** The token at `start` of `line`; blanks are tokens of kind plain. */
  next(line: string, start: number, in_comment: boolean): Token;
  line_comment?: string;
}

/** The first rule that matches at `start`. Rules are sticky expressions. */
export type Rule = [RegExp, TokenKind | ((text: string) => TokenKind)];

export function first_match(rules: Rule[], line: string, start: number): Token {
  for (const [expression, kind] of rules) {
    expression.lastIndex = start;
    const match = expression.exec(line);
    if (match && match[0].length > 0) {
      return {
        kind: typeof kind === 'function' ? kind(match[0]) : kind,
        end: start + match[0].length,
      };
    }
  }
  return { kind: 'plain', end: start + 1 };
}

export function tokens_of(lexer: Lexer, line: string): { kind: TokenKind; text: string }[] {
  const tokens: { kind: TokenKind; text: string }[] = [];
  let in_comment = false;
  for (let at = 0; at < line.length;) {
    const token = lexer.next(line, at, in_comment);
    in_comment = token.in_comment ?? false;
    const text = line.slice(at, token.end);
    if (text.trim()) tokens.push({ kind: token.kind, text });
    at = token.end;
  }
  return tokens;
}
