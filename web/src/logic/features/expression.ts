/** A number as it is typed into a dimension: `60/2`, `2*(10+5)`, `12,5`. By recursive descent; a number is read as everywhere on the page. */
import { typed_number } from '../format';

const LONGEST = 80;

/** Undefined: it is none. */
export function calculated(text: string): number | undefined {
  if (text.length > LONGEST) return undefined;
  const reader = new Reader(
    text.replaceAll('\u2212', '-').replaceAll('×', '*').replaceAll('÷', '/'),
  );
  const value = reader.sum();
  return value !== undefined && reader.is_over && Number.isFinite(value) ? value : undefined;
}

const NUMBER = /^(\d+([.,]\d*)?|[.,]\d+)/;

class Reader {
  private rest: string;

  constructor(text: string) {
    this.rest = text.replace(/\s+/g, '');
  }

  get is_over(): boolean {
    return this.rest === '';
  }

  /** sum = product { ("+" | "-") product } */
  sum(): number | undefined {
    return this.chain('+-', () => this.product());
  }

  /** product = factor { ("*" | "/") factor } */
  private product(): number | undefined {
    return this.chain('*/', () => this.factor());
  }

  private chain(signs: string, part: () => number | undefined): number | undefined {
    let value = part();
    while (value !== undefined && this.rest && signs.includes(this.rest[0])) {
      const sign = this.take();
      const next = part();
      value = next === undefined ? undefined : combined(value, sign, next);
    }
    return value;
  }

  /** factor = ["-" | "+"] ( number | "(" sum ")" ) */
  private factor(): number | undefined {
    if (this.rest[0] === '-' || this.rest[0] === '+') {
      const sign = this.take() === '-' ? -1 : 1;
      const value = this.factor();
      return value === undefined ? undefined : sign * value;
    }
    return this.rest[0] === '(' ? this.bracket() : this.number();
  }

  private bracket(): number | undefined {
    this.take();
    const value = this.sum();
    return this.take() === ')' ? value : undefined;
  }

  private number(): number | undefined {
    const found = NUMBER.exec(this.rest)?.[0];
    if (!found) return undefined;
    this.rest = this.rest.slice(found.length);
    return typed_number(found) ?? undefined;
  }

  private take(): string {
    const first = this.rest.slice(0, 1);
    this.rest = this.rest.slice(1);
    return first;
  }
}

function combined(a: number, sign: string, b: number): number {
  if (sign === '+') return a + b;
  if (sign === '-') return a - b;
  return sign === '*' ? a * b : a / b;
}
