// node tools/pack_web.mjs FOLDER FILE: packs the built page into one file that the program takes in.
// A line `path TAB content type TAB etag TAB bytes` for each file, an empty line, then the files, compressed by gzip.
// The same page gives the same bytes.
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, readdirSync, renameSync, writeFileSync } from 'node:fs';
import { dirname, extname, join, relative, sep } from 'node:path';
import { gzipSync } from 'node:zlib';

const TYPES = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.ico': 'image/x-icon',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json',
  '.map': 'application/json',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain; charset=utf-8',
  '.webmanifest': 'application/manifest+json',
  '.woff': 'font/woff',
  '.woff2': 'font/woff2',
};

const files_in = (folder) =>
  readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? files_in(path) : [path];
  });

function asset_of(folder, file) {
  const type = TYPES[extname(file)];
  if (!type) throw new Error(`${file}: no content type for this ending; tools/pack_web.mjs has the list`);
  const name = '/' + relative(folder, file).split(sep).join('/');
  const bytes = readFileSync(file);
  const etag = `"${createHash('sha256').update(bytes).digest('hex').slice(0, 20)}"`;
  return { path: name === '/index.html' ? '/' : name, type, etag, gzip: gzipSync(bytes, { level: 9 }) };
}

const [folder, target] = process.argv.slice(2);
if (!folder || !target) {
  console.error('usage: node tools/pack_web.mjs FOLDER FILE');
  process.exit(2);
}
const assets = files_in(folder)
  .sort()
  .map((file) => asset_of(folder, file));
const head = assets.map((a) => `${a.path}\t${a.type}\t${a.etag}\t${a.gzip.length}\n`).join('');
mkdirSync(dirname(target), { recursive: true });
writeFileSync(`${target}.new`, Buffer.concat([Buffer.from(`${head}\n`), ...assets.map((a) => a.gzip)]));
renameSync(`${target}.new`, target);
