import { describe, expect, it } from 'vitest';
import { random } from './random';
import { type Encoding, decoded, encoded, is_text, read } from '../src/logic/text_bytes';

const bytes = (...values: number[]) => new Uint8Array(values);
const of_hex = (hex: string) => Uint8Array.from(hex.match(/../g) ?? [], (h) => parseInt(h, 16));
/** A program whose comment is these bytes. */
const program = (hex: string) => of_hex(`250a4f310a28${hex}290a473031580a4d33300a`);
const comment = (text: string) => `%\nO1\n(${text})\nG01X\nM30\n`;

/** Bytes of the comments as the encodings of Python have them. */
const SAMPLES: [Encoding, string, string][] = [
  ['big5', '工件原點設定', 'a475a5f3adecc249b35da977'],
  ['big5', '粗銑外形 刀具直徑10', 'b2cabbd1a57ea7ce20a44da8e3aabdae7c3130'],
  ['big5', '第一工程 鑽孔', 'b2c4a440a475b57b20c670a4d5'],
  ['big5', '鋁合金底座 左側', 'be54a658aaf7a9b3ae7920a5aab0bc'],
  ['gbk', '工件坐标设定', 'b9a4bcfed7f8b1eac9e8b6a8'],
  ['gbk', '粗铣外形 刀具直径10', 'b4d6cfb3cde2d0ce20b5b6bedfd6b1beb63130'],
  ['gbk', '铝合金底座 左侧', 'c2c1bacfbdf0b5d7d7f920d7f3b2e0'],
  ['gbk', '精加工', 'beabbcd3b9a4'],
  ['shift_jis', 'ワーク座標', '838f815b834e8dc09557'],
  ['shift_jis', '工具交換 主軸停止', '8d488bef8cf08ab7208ee58eb292e28e7e'],
  ['shift_jis', '仕上げ加工', '8e648fe382b089c18d48'],
  ['windows-1252', 'Schlüsselfläche fräsen', '5363686cfc7373656c666ce4636865206672e473656e'],
  ['windows-1252', 'Pièce n° 3 ébauche', '5069e86365206eb0203320e9626175636865'],
  ['windows-1252', 'Tiefe 5 µm ± 2', '5469656665203520b56d20b12032'],
];

describe('the bytes of a program are read', () => {
  it('as UTF-8 where they are', () => {
    const text = '(程式)\r\nM30\r\n';
    expect(decoded(new TextEncoder().encode(text))).toEqual({ text, read_as: 'utf-8' });
  });
  it('with the byte order mark, which saving writes again', () => {
    const { text } = decoded(bytes(0xef, 0xbb, 0xbf, 0x25, 0x0a))!;
    expect([...new TextEncoder().encode(text)]).toEqual([0xef, 0xbb, 0xbf, 0x25, 0x0a]);
  });
  it.each(SAMPLES)('as %s: %s', (read_as, text, hex) => {
    expect(decoded(program(hex))).toEqual({ text: comment(text), read_as });
  });
  it('as UTF-16, with its mark and without', () => {
    const text = comment('程式');
    const little = [...text].flatMap((c) => [c.charCodeAt(0) & 255, c.charCodeAt(0) >> 8]);
    const big = [...text].flatMap((c) => [c.charCodeAt(0) >> 8, c.charCodeAt(0) & 255]);
    expect(decoded(bytes(0xff, 0xfe, ...little))).toEqual({ text, read_as: 'utf-16le' });
    expect(decoded(bytes(0xfe, 0xff, ...big))).toEqual({ text, read_as: 'utf-16be' });
    expect(decoded(bytes(...little))).toEqual({ text, read_as: 'utf-16le' });
    expect(decoded(bytes(...big))).toEqual({ text, read_as: 'utf-16be' });
  });
  it('as the operator says, whatever they are', () => {
    const gbk = program('b9a4bcfed7f8b1eac9e8b6a8');
    expect(read('gbk', gbk)).toBe(comment('工件坐标设定'));
    expect(read('utf-8', gbk)).toContain('\ufffd');
  });
});

describe('what is no text', () => {
  it('is random bytes, also without a zero', () => {
    const next = random(3);
    const noise = Uint8Array.from({ length: 200_000 }, () => Math.floor(next() * 256));
    expect(decoded(noise)).toBeNull();
    expect(decoded(noise.map((byte) => byte || 1))).toBeNull();
  });
  it('has zeros here and there', () => {
    expect(is_text(bytes(0x25, 0x0a, 0x00, 0x00, 0x4f, 0x31, 0x0a))).toBe(false);
  });
  it('is not an empty file, nor a tape with a few control codes', () => {
    expect(is_text(bytes())).toBe(true);
    expect(is_text(bytes(0x12, 0x25, 0x0d, 0x0a, 0x4d, 0x33, 0x30, 0x0a, 0x25, 0x14))).toBe(true);
  });
});

describe('a text is written', () => {
  it.each(SAMPLES)('in %s as it was read: %s', (encoding, text, hex) => {
    expect(encoded(comment(text), encoding)).toEqual({ bytes: program(hex) });
  });
  it('or the character is told that the encoding does not have', () => {
    expect(encoded('(ä 中)', 'windows-1252')).toEqual({ missing: '中' });
    expect(encoded('(中 ä)', 'big5')).toEqual({ missing: 'ä' });
  });
  it('in UTF-8 where it was UTF-16', () => {
    expect(encoded('(中)', 'utf-16le')).toEqual({ bytes: new TextEncoder().encode('(中)') });
  });
});
