/** Programs of the library as files, by HTTP: however long they are, they do not stand before what the machine says. */
import { type Decoded, decoded, is_text } from '../logic/text_bytes';
import { notices } from './notices.svelte';
import { t } from './words.svelte';

/** Where a file of the library is had. */
export const address = (name: string): string =>
  `library/${encodeURIComponent(name)}${location.search}`;

/** Into the library as it is, byte by byte. False: refused, and the sentence is told. */
export async function put_file(name: string, body: Blob | string): Promise<boolean> {
  const answer = await fetch(address(name), { method: 'PUT', body }).catch(() => null);
  if (!answer?.ok) await tell_refusal(answer);
  return answer?.ok ?? false;
}

/** In the words of the server, where it has answered. */
async function tell_refusal(answer: Response | null): Promise<null> {
  notices.say((await answer?.text()) || t('connection.refused'), 'refused');
  return null;
}

/** `begins`: told the first bytes, while the others are still on their way. Null: refused, and told. */
export async function get_bytes(
  name: string,
  begins: (first: Uint8Array) => void = () => {},
): Promise<Uint8Array | null> {
  const answer = await fetch(address(name)).catch(() => null);
  if (!answer?.ok || !answer.body) return tell_refusal(answer);
  const pieces: Uint8Array[] = [];
  const reader = answer.body.getReader();
  for (;;) {
    const piece = await reader.read().catch(() => null);
    if (!piece) return tell_refusal(null);
    if (pieces.length === 0) begins(piece.value ?? new Uint8Array());
    if (piece.done) return joined(pieces);
    pieces.push(piece.value);
  }
}

/** Null: it is no text, or refused; both are told. */
export async function get_text(
  name: string,
  begins?: (first: Uint8Array) => void,
): Promise<Decoded | null> {
  const bytes = await get_bytes(name, begins);
  if (!bytes) return null;
  const found = decoded(bytes);
  if (!found) notices.say(t('notice.no-text', { name }), 'refused');
  return found;
}

const LOOKED_AT = 1 << 16;

export async function is_text_file(file: File): Promise<boolean> {
  return is_text(new Uint8Array(await file.slice(0, LOOKED_AT).arrayBuffer()));
}

function joined(pieces: Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(pieces.reduce((sum, piece) => sum + piece.length, 0));
  let at = 0;
  for (const piece of pieces) {
    whole.set(piece, at);
    at += piece.length;
  }
  return whole;
}
