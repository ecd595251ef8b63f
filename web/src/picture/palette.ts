/** The picture's colours are those of the page's style sheet. */
import type { Palette } from './furniture';

export function palette_of(root: HTMLElement): Palette {
  const style = getComputedStyle(root);
  const colour = (name: string): string => style.getPropertyValue(`--${name}`).trim() || '#888888';
  return {
    ground: colour('picture-2'),
    grid: colour('grid'),
    grid_strong: colour('grid-strong'),
    travel: colour('travel'),
    stock: colour('stock'),
    text: colour('text'),
    x: colour('axis-x'),
    y: colour('axis-y'),
    z: colour('axis-z'),
    metal: colour('metal'),
    metal_dark: colour('metal-dark'),
    tool: colour('tool'),
    beam: colour('beam'),
    mark: colour('mark'),
    blank: colour('blank'),
    face: colour('face'),
    hatch: colour('hatch'),
    edge: colour('edge'),
    fixture: colour('fixture'),
    alarm: colour('alarm'),
    hold: colour('hold'),
  };
}
