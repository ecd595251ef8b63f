/** The picture's colours are those of the page's style sheet. */
import type { Palette } from './furniture';

/** By which custom property each is called there. */
const PROPERTIES: Record<keyof Palette, string> = {
  ground: 'picture-2',
  grid: 'grid',
  grid_strong: 'grid-strong',
  travel: 'travel',
  stock: 'stock',
  text: 'text',
  x: 'axis-x',
  y: 'axis-y',
  z: 'axis-z',
  metal: 'metal',
  metal_dark: 'metal-dark',
  tool: 'tool',
  beam: 'beam',
  mark: 'mark',
  blank: 'blank',
  face: 'face',
  hatch: 'hatch',
  edge: 'edge',
  fixture: 'fixture',
  shadow: 'part-shadow',
  alarm: 'alarm',
  hold: 'hold',
};
const MISSING = '#888888';

export function palette_of(root: HTMLElement): Palette {
  const style = getComputedStyle(root);
  const colours = Object.entries(PROPERTIES).map(([key, name]) => [
    key,
    style.getPropertyValue(`--${name}`).trim() || MISSING,
  ]);
  return Object.fromEntries(colours) as Palette;
}
