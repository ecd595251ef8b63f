/** The manual that comes with the page: finding words in it, and where in it a message is explained. */

export interface ManualPage {
  /** As its file is called: `errors`, `dialect/text`. */
  name: string;
  title: string;
  html: string;
}

/** A place in the manual; an empty anchor is the head of the page. */
export interface ManualPlace {
  page: string;
  anchor: string;
}

/** A passage that holds all words that are looked for. */
export interface Passage extends ManualPlace {
  title: string;
  /** The heading that it stands under. */
  heading: string;
  text: string;
}

const FIRST_PAGE = 'panel';
const MOST_PASSAGES = 40;
/** How much is shown around the first word that was found. */
const AROUND = 70;

export const first_place = (): ManualPlace => ({ page: FIRST_PAGE, anchor: '' });

/** Where a link of the manual leads: `#manual/errors/PS0007`. A page's name may have a slash; null: it is none of the manual. */
export function place_of_link(href: string, pages: readonly ManualPage[]): ManualPlace | null {
  if (!href.startsWith('#manual/')) return null;
  const path = href.slice('#manual/'.length);
  if (pages.some(({ name }) => name === path)) return { page: path, anchor: '' };
  const slash = path.lastIndexOf('/');
  const page = path.slice(0, slash);
  return pages.some(({ name }) => name === page) ? { page, anchor: path.slice(slash + 1) } : null;
}

interface Message {
  code: string;
  message: string;
  cause: string;
  remedy: string;
}

/** Where a message is explained: its entry in the table of errors, and every page that it names itself. */
export function places_of_message({ code, message, cause, remedy }: Message): ManualPlace[] {
  // Alarms of programs have numbers of their own, all with one entry.
  const entry = /^MC\d+$/.test(code) ? 'MC3000' : code;
  const named = [...`${message} ${cause} ${remedy}`.matchAll(/docs\/([\w/-]+)\.md/g)].map(
    (match) => match[1],
  );
  const of_language = /^L[BW]\d+$/.test(code) ? ['laser-basic'] : [];
  const pages = [...new Set([...named, ...of_language])];
  return [
    { page: 'errors', anchor: entry },
    ...pages.map((page): ManualPlace => ({ page, anchor: '' })),
  ];
}

/** What is read of HTML: its words, with a blank where a tag was. */
export function plain_text(html: string): string {
  return html
    .replace(/<[^>]*>/g, ' ')
    .replace(/&lt;/g, '<')
    .replace(/&gt;/g, '>')
    .replace(/&quot;/g, '"')
    .replace(/&#39;/g, "'")
    .replace(/&amp;/g, '&')
    .replace(/\s+/g, ' ')
    .trim();
}

/** Passages with all words of the question: first those that have all of it as it is, then by the words in their heading. */
export function search_manual(pages: readonly ManualPage[], question: string): Passage[] {
  const words = question.toLowerCase().split(/\s+/).filter(Boolean);
  if (!words.length) return [];
  const found = pages.flatMap((page) =>
    parts_of(page).flatMap((part) => ranked(page, part, words)),
  );
  found.sort((a, b) => b.rank - a.rank);
  return found.slice(0, MOST_PASSAGES).map(({ passage }) => passage);
}

/** None where a word is missing. */
function ranked({ title, name }: ManualPage, part: Part, words: readonly string[]) {
  const text = part.text.toLowerCase();
  const heading = `${title} ${part.heading} ${part.anchor}`.toLowerCase();
  const in_heading = words.filter((word) => heading.includes(word));
  if (!words.every((word) => text.includes(word) || in_heading.includes(word))) return [];
  const passage: Passage = { ...part, title, page: name, text: around(part.text, words) };
  const is_phrase = text.includes(words.join(' '));
  return [{ passage, rank: in_heading.length + (is_phrase ? words.length : 0) }];
}

interface Part {
  anchor: string;
  heading: string;
  text: string;
}

/** A page cut where one can go: at its headings, and at the rows of codes. */
function parts_of({ html, title }: ManualPage): Part[] {
  const parts: Part[] = [];
  let heading = title;
  for (const piece of html.split(/(?=<(?:h\d|tr) id="manual-)/)) {
    const [, tag = '', anchor = ''] = /^<(h\d|tr) id="manual-([^"]*)"/.exec(piece) ?? [];
    if (tag.startsWith('h')) heading = plain_text(/>(.*?)<\/h\d>/s.exec(piece)?.[1] ?? title);
    parts.push({ anchor, heading, text: plain_text(piece) });
  }
  return parts;
}

function around(text: string, words: readonly string[]): string {
  const lower = text.toLowerCase();
  const places = words.map((word) => lower.indexOf(word)).filter((at) => at >= 0);
  const at = places.length ? Math.min(...places) : 0;
  const from = Math.max(0, at - AROUND);
  const to = Math.min(text.length, at + AROUND);
  return `${from > 0 ? '… ' : ''}${text.slice(from, to)}${to < text.length ? ' …' : ''}`;
}
