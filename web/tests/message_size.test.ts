import { describe, expect, it } from 'vitest';
import {
  bytes_of,
  message_fits,
  MOST_MESSAGE_BYTES,
  MOST_TEXT_BYTES,
  text_fits,
} from '../src/logic/message_size';

describe('a text fits into a command', () => {
  it('up to as many bytes as the server takes of a program', () => {
    expect(text_fits('x'.repeat(MOST_TEXT_BYTES))).toBe(true);
    expect(text_fits('x'.repeat(MOST_TEXT_BYTES + 1))).toBe(false);
  });
  it('by its bytes, not by its characters', () => {
    expect(bytes_of('(程式)')).toBe(8);
    expect(text_fits('程'.repeat(MOST_TEXT_BYTES / 3))).toBe(true);
    expect(text_fits('程'.repeat(MOST_TEXT_BYTES / 2))).toBe(false);
  });
  it('only if the message around it fits, in which a line end takes two bytes', () => {
    const short_lines = 'X1.\n'.repeat(MOST_TEXT_BYTES / 4);
    expect(bytes_of(short_lines)).toBe(MOST_TEXT_BYTES);
    expect(text_fits(short_lines)).toBe(false);
  });
  it('so that the message with the longest names fits, too', () => {
    const text = 'X1. Y2. Z3.\n'.repeat(79_000);
    expect(text_fits(text)).toBe(true);
    const name = '程'.repeat(33);
    const frame = JSON.stringify({ id: 1e9, do: 'check', text, name, machine: name });
    expect(message_fits(frame)).toBe(true);
  });
  it('and a message at most to its limit', () => {
    expect(message_fits('x'.repeat(MOST_MESSAGE_BYTES))).toBe(true);
    expect(message_fits('x'.repeat(MOST_MESSAGE_BYTES - 1) + 'é')).toBe(false);
  });
});
