import { describe, expect, it } from 'vitest';
import { decoded } from '../src/logic/text_bytes';

const bytes = (...values: number[]) => new Uint8Array(values);

describe('the bytes of a program are read', () => {
  it('as UTF-8 where they are', () => {
    const text = '(程式)\r\nM30\r\n';
    expect(decoded(new TextEncoder().encode(text))).toEqual({ text, read_as: 'utf-8' });
  });
  it('with the byte order mark, which saving writes again', () => {
    const { text } = decoded(bytes(0xef, 0xbb, 0xbf, 0x25, 0x0a));
    expect([...new TextEncoder().encode(text)]).toEqual([0xef, 0xbb, 0xbf, 0x25, 0x0a]);
  });
  it('as Big5 where they are no UTF-8', () => {
    // (中文) in Big5
    expect(decoded(bytes(0x28, 0xa4, 0xa4, 0xa4, 0xe5, 0x29, 0x0a))).toEqual({
      text: '(中文)\n',
      read_as: 'big5',
    });
  });
  it('as Windows-1252 where they are neither', () => {
    // (SCHLÜSSEL 5 °) in Windows-1252
    const text = '(Ü 5 °)';
    expect(decoded(bytes(0x28, 0xdc, 0x20, 0x35, 0x20, 0xb0, 0x29))).toEqual({
      text,
      read_as: 'windows-1252',
    });
  });
});
