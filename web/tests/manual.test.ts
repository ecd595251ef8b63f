import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { anchor_of, page_of, pages_of, target_of } from '../scripts/manual.mjs';
import {
  place_of_link,
  places_of_message,
  plain_text,
  search_manual,
  type ManualPage,
} from '../src/logic/manual';

const pages: ManualPage[] = pages_of(join(__dirname, '../../docs'));
const html_of = (name: string): string => pages.find((page) => page.name === name)?.html ?? '';
const ids = (name: string): string[] =>
  [...html_of(name).matchAll(/id="manual-([^"]+)"/g)].map((match) => match[1]);

describe('the manual', () => {
  it('has the documents, and not the decisions of those who write it', () => {
    const names = pages.map(({ name }) => name);
    for (const name of ['panel', 'errors', 'laser-basic', 'dialect/text', 'serve'])
      expect(names).toContain(name);
    expect(names.filter((name) => name.startsWith('decisions'))).toEqual([]);
  });
  it('leads by each of its links to a place that is there', () => {
    for (const { name, html } of pages) {
      const links = [...html.matchAll(/href="(#manual[^"]+)"/g)].map((match) => match[1]);
      for (const link of links) {
        const place = place_of_link(link, pages);
        expect(place, `${name}: ${link}`).not.toBeNull();
        if (place?.anchor) expect(ids(place.page), `${name}: ${link}`).toContain(place.anchor);
      }
    }
  });
  it('needs nothing from the network: no picture, no script, no style', () => {
    for (const { html } of pages) expect(html).not.toMatch(/<(img|script|link|style|iframe)\b/);
  });
  it('has no head of a table without words', () => {
    for (const { name, html } of pages) {
      expect(html.match(/<th[^>]*>\s*<\/th>\s*<th[^>]*>\s*<\/th>/), name).toBeNull();
    }
    expect(html_of('errors')).toContain('<thead>');
  });
  it('has an entry for every code that Kerf reports', () => {
    const table = readFileSync(join(__dirname, '../../src/base/diagnostic_codes.def'), 'utf8');
    const codes = [...table.matchAll(/^CODE\(\w+, "(\w+)"/gm)].map((match) => match[1]);
    expect(codes.length).toBeGreaterThan(100);
    const entries = ids('errors');
    for (const code of codes) expect(entries).toContain(code);
  });
});

describe('a page', () => {
  it('takes its title from the first heading, and the headings one lower', () => {
    const { title, html } = page_of('a', '# The `A`\n\n## G43.4, or not\n', ['a']);
    expect(title).toBe('The A');
    expect(html).toContain('<h3 id="manual-g434-or-not">G43.4, or not</h3>');
  });
  it('keeps the words of links to elsewhere, and of pictures', () => {
    const { html } = page_of('a', '[mills](../machines) ![The panel](images/x.png)', ['a']);
    expect(plain_text(html)).toBe('mills The panel');
    expect(html).not.toContain('href');
  });
  it('leads to a page that a sentence names', () => {
    const { html } = page_of('dialect/text', 'Look into docs/errors.md; `docs/errors.md`.', [
      'errors',
    ]);
    expect(html.match(/<a href="#manual\/errors">/g)).toHaveLength(1);
  });
  it('leaves out a chapter that is pictures alone', () => {
    const links = Array.from({ length: 12 }, (_, i) => `[p${i}](images/${i}.png)`).join(' ');
    const { html } = page_of('a', `# A\n\n## One\nwords\n\n## Pictures\n${links}\n`, ['a']);
    expect(plain_text(html)).toBe('A One words');
  });
  it('is linked from where it stands', () => {
    expect(target_of('text.md#a', 'dialect/macros', ['dialect/text'])).toBe(
      '#manual/dialect/text/a',
    );
    expect(target_of('../errors.md', 'dialect/macros', ['errors'])).toBe('#manual/errors');
    expect(target_of('#here', 'errors', ['errors'])).toBe('#manual/errors/here');
    expect(target_of('../src/x.cpp', 'errors', ['errors'])).toBeNull();
    expect(target_of('https://example.org/', 'errors', ['errors'])).toBeNull();
  });
});

it('headings are named as in the documents', () => {
  expect(anchor_of('M03, M04 and S')).toBe('m03-m04-and-s');
});

describe('a message', () => {
  const message = { code: 'PS0007', message: '', cause: '', remedy: '' };
  it('is explained in the table of errors', () => {
    expect(places_of_message(message)).toEqual([{ page: 'errors', anchor: 'PS0007' }]);
  });
  it('of a program itself has the entry of all of them', () => {
    expect(places_of_message({ ...message, code: 'MC3017' })[0].anchor).toBe('MC3000');
  });
  it('leads to each page that it names, once, and to its language', () => {
    const cause = 'docs/laser-basic.md has its grammar; see docs/dialect/text.md';
    const places = places_of_message({ ...message, code: 'LB0001', cause, remedy: cause });
    expect(places.map(({ page }) => page)).toEqual(['errors', 'laser-basic', 'dialect/text']);
  });
});

describe('searching', () => {
  it('finds passages with all words, those with them in the heading first', () => {
    const found = search_manual(pages, 'PS0007');
    expect(found[0]).toMatchObject({ page: 'errors', anchor: 'PS0007' });
    expect(search_manual(pages, 'feed hold').length).toBeGreaterThan(0);
    expect(search_manual(pages, 'xyzzy plugh')).toEqual([]);
    expect(search_manual(pages, '  ')).toEqual([]);
  });
  it('prefers the words as they were asked', () => {
    expect(search_manual(pages, 'one decimal point at most')[0].anchor).toBe('PS0007');
  });
  it('does not care for capitals and shows the word', () => {
    const [first] = search_manual(pages, 'DECIMAL point');
    expect(first.text.toLowerCase()).toMatch(/decimal|point/);
  });
  it('reads no tags', () => {
    expect(plain_text('<p>a &lt; b &amp;&amp; <b>c</b></p>')).toBe('a < b && c');
  });
});
