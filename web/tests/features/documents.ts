/** What `kerf features --format json` prints of two programs: P1, which the browser scenarios run too, and the shaft of theirs. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { FeaturesDocument } from '../../src/logic/features/document';

const read = (name: string): FeaturesDocument =>
  JSON.parse(readFileSync(join(__dirname, name), 'utf8')) as FeaturesDocument;

export const p1 = read('p1.json');
export const shaft = read('shaft.json');
