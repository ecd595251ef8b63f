/** What fits into one message to the server: docs/panel-protocol.md, "Limits". Longer texts go by HTTP. */

export const MOST_MESSAGE_BYTES = 1_048_576;
/** Of a program as an argument of `check`, `load`, `write`. */
export const MOST_TEXT_BYTES = 1_000_000;
/** Room for the other keys of a command beside the text: its name, and the names of file and machine. */
const FRAME_BYTES = 2_000;

const encoder = new TextEncoder();

/** In UTF-8. */
export const bytes_of = (text: string): number => encoder.encode(text).length;

export const message_fits = (frame: string): boolean =>
  frame.length <= MOST_MESSAGE_BYTES && bytes_of(frame) <= MOST_MESSAGE_BYTES;

/** A program fits into a command. In JSON each line end takes two bytes, so that short lines count more. */
export function text_fits(text: string): boolean {
  if (text.length > MOST_TEXT_BYTES || bytes_of(text) > MOST_TEXT_BYTES) return false;
  return bytes_of(JSON.stringify(text)) <= MOST_MESSAGE_BYTES - FRAME_BYTES;
}
