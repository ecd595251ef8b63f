// The manual of the page: docs/*.md as HTML, made while the page is built, so that reading it needs no network.
// `virtual:manual` is a list of { name, title, html }; a link within it is <a href="#manual/NAME/ANCHOR">.
import { readdirSync, readFileSync } from 'node:fs';
import { basename, join, posix } from 'node:path';
import { Marked } from 'marked';

const DOCS = new URL('../../docs/', import.meta.url).pathname;
const VIRTUAL = 'virtual:manual';
/** A row of a table that begins with a code can be gone to: PS0007, LB0001, OUT_OF_REACH. */
const CODE_ROW = /^<tr>\s*<td><code>([A-Z][A-Z0-9_]+)<\/code>/;

/** As GitHub names the headings of a document. */
export function anchor_of(heading) {
  return heading
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s_-]/gu, '')
    .trim()
    .replace(/\s/g, '-');
}

/** The name of a page of the manual that `href` on page `from` leads to, and the place there; null: it leads elsewhere. */
export function target_of(href, from, names) {
  const [path, anchor = ''] = href.split('#');
  if (/^[a-z]+:/i.test(path)) return null;
  const whole = path.startsWith('/')
    ? path.slice(1)
    : path
      ? posix.join(posix.dirname(from), path)
      : from;
  const name = whole.replace(/\.md$/, '');
  return names.includes(name) ? `#manual/${name}${anchor ? `/${anchor}` : ''}` : null;
}

/** A chapter that is nothing but links to pictures has nothing to say where there are none. */
function without_picture_chapters(text) {
  const chapters = text.split(/^(?=## )/m);
  return chapters.filter((chapter) => (chapter.match(/\]\(images\//g) ?? []).length < 10).join('');
}

/** Markdown wants a head above every table; one without words says nothing to who hears it. */
const without_empty_heads = (html) =>
  html.replace(/<thead>\s*<tr>\s*(?:<th[^>]*>\s*<\/th>\s*)+<\/tr>\s*<\/thead>\s*/g, '');

/** A document that is named in a sentence is a way to it: docs/dialect.md. */
const with_named_pages = (text) =>
  text.replace(/(?<![\w/([`-])docs\/([\w/-]+\.md)/g, '[docs/$1](/$1)');

/** One page: { name, title, html }. A picture is left out and leaves its words. */
export function page_of(name, text, names) {
  let title = name;
  const marked = new Marked({
    renderer: {
      heading({ tokens, depth, text: heading }) {
        const inner = this.parser.parseInline(tokens);
        const plain = heading.replace(/[`*]/g, '');
        if (depth === 1) title = plain;
        const level = Math.min(6, depth + 1); // the dialog's own heading stands above
        return `<h${level} id="manual-${anchor_of(plain)}">${inner}</h${level}>\n`;
      },
      link({ href, tokens }) {
        const inner = this.parser.parseInline(tokens);
        const target = target_of(href, name, names);
        if (target) return `<a href="${target}">${inner}</a>`;
        return /^https?:/.test(href)
          ? `<a href="${href}" target="_blank" rel="noreferrer">${inner}</a>`
          : inner;
      },
      image({ text: words }) {
        return words ? `<em class="picture">${words}</em>` : '';
      },
      tablerow({ text: cells }) {
        const row = `<tr>\n${cells}</tr>\n`;
        const code = CODE_ROW.exec(row)?.[1];
        return code ? row.replace('<tr>', `<tr id="manual-${code}">`) : row;
      },
      html: ({ text: tag }) => (tag.startsWith('<br') ? '<br>' : ''),
    },
  });
  const html = without_empty_heads(marked.parse(with_named_pages(without_picture_chapters(text))));
  return { name, title, html };
}

export function pages_of(folder) {
  const files = readdirSync(folder, { recursive: true })
    .map(String)
    .filter((file) => file.endsWith('.md') && !file.startsWith('decisions'))
    .sort();
  const names = files.map((file) => file.replace(/\.md$/, ''));
  return files.map((file) =>
    page_of(file.replace(/\.md$/, ''), readFileSync(join(folder, file), 'utf8'), names),
  );
}

/** The plugin of Vite. */
export function manual() {
  return {
    name: basename(import.meta.url, '.mjs'),
    resolveId: (id) => (id === VIRTUAL ? `\0${VIRTUAL}` : undefined),
    load(id) {
      if (id !== `\0${VIRTUAL}`) return undefined;
      const pages = pages_of(DOCS);
      // A string to be parsed weighs and takes less than the same as source text.
      return `export default JSON.parse(${JSON.stringify(JSON.stringify(pages))});`;
    },
  };
}
