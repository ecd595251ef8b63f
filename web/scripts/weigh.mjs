// Says what the built page weighs compressed, and fails when it is heavier than it may be.
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';

const LIMIT_BYTES = 1.5 * 1024 * 1024;
const COMPRESSED = /\.(woff2|png|jpg)$/;

const files = (folder) =>
  readdirSync(folder).flatMap((name) => {
    const path = join(folder, name);
    return statSync(path).isDirectory() ? files(path) : [path];
  });

const weight = (path) => {
  const bytes = readFileSync(path);
  return COMPRESSED.test(path) ? bytes.length : gzipSync(bytes, { level: 9 }).length;
};

const total = files('dist').reduce((sum, path) => sum + weight(path), 0);
console.log(`the page weighs ${(total / 1024).toFixed(0)} KiB compressed`);
if (total > LIMIT_BYTES) {
  console.error(`that is more than ${LIMIT_BYTES / 1024} KiB`);
  process.exit(1);
}
