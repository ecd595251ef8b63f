/** Files from this computer into the library: never over another one without a question, as programs never what is no text. */
import type { ProgramEntry } from '../logic/protocol';
import { is_listing } from '../logic/dialects';
import { free_name, mended_name } from '../logic/program_name';
import { get_bytes, is_text_file, put_file } from './library_files';
import { languages } from './languages.svelte';
import { notices } from './notices.svelte';
import { question } from './question.svelte';
import { t } from './words.svelte';

/** The name under which a program went into the library; null: it did not. */
export async function upload(
  file: File,
  programs: readonly ProgramEntry[],
): Promise<string | null> {
  if (is_listing(languages.dialects, file.name) || (await is_text_file(file)))
    return upload_shape(file, programs);
  notices.say(t('notice.no-text', { name: file.name }), 'refused');
  return null;
}

/** The same of any bytes, as those of a part. */
export async function upload_shape(
  file: File,
  programs: readonly ProgramEntry[],
): Promise<string | null> {
  if (await is_there_already(file, programs)) return file.name;
  const taken = programs.map((program) => program.name);
  const name = await name_for(file.name, taken);
  if (!name || !(await put_file(name, file))) return null;
  notices.say(t('notice.uploaded', { name }));
  return name;
}

/** The same bytes under the same name: there is nothing to ask, and nothing to write. */
async function is_there_already(file: File, programs: readonly ProgramEntry[]): Promise<boolean> {
  const there = programs.find(({ name }) => name === file.name);
  if (there?.bytes !== file.size) return false;
  const [old, fresh] = await Promise.all([get_bytes(file.name), file.arrayBuffer()]);
  const bytes = new Uint8Array(fresh);
  if (!old?.every((byte, i) => byte === bytes[i])) return false;
  notices.say(t('notice.uploaded', { name: file.name }));
  return true;
}

/** Null: the operator wants none of what was offered. */
async function name_for(wanted: string, taken: readonly string[]): Promise<string | null> {
  const name = mended_name(wanted);
  // Some systems name files with accents apart: that is the same name.
  if (name !== wanted.normalize('NFC') && (await asked_to_mend(wanted, name)) === null) return null;
  if (!taken.includes(name)) return name;
  const other = free_name(name, taken);
  const answer = await question.ask(t('upload.exists', { name }), t('upload.exists-why'), [
    { answer: 'other', label: t('upload.other-name', { name: other }), tone: 'main' },
    { answer: 'replace', label: t('upload.replace'), tone: 'danger' },
  ]);
  return answer === 'replace' ? name : answer === 'other' ? other : null;
}

const asked_to_mend = (wanted: string, name: string): Promise<string | null> =>
  question.ask(t('upload.bad-name', { name: wanted }), t('upload.bad-name-why'), [
    { answer: 'mend', label: t('upload.as', { name }), tone: 'main' },
  ]);
