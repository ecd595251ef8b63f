/** Contours as paths of an SVG whose up is upwards: one unit is a mm, arcs are arcs. */
import type { ToldVertex } from './document';
import { type Element, radius, elements_of } from './elements';

const n = (value: number): string => String(Math.round(value * 1e4) / 1e4);

function to_end(element: Element): string {
  const { to, bulge } = element;
  if (bulge === 0) return `L${n(to[0])} ${n(to[1])}`;
  const r = n(radius(element));
  const is_large = Math.abs(bulge) > 1 ? 1 : 0;
  return `A${r} ${r} 0 ${is_large} ${bulge > 0 ? 1 : 0} ${n(to[0])} ${n(to[1])}`;
}

export const path_of_element = (element: Element): string =>
  `M${n(element.from[0])} ${n(element.from[1])}${to_end(element)}`;

/** Element by element: where one does not begin at the end of the one before it, there is a gap. */
export function path_of(elements: readonly Element[], is_closed: boolean): string {
  const parts = elements.map((element, i) => {
    const before = elements[i - 1];
    const goes_on = before && before.to[0] === element.from[0] && before.to[1] === element.from[1];
    return goes_on ? to_end(element) : path_of_element(element);
  });
  return parts.join('') + (is_closed && parts.length ? 'Z' : '');
}

/** Contours as they are told, together: what an even number of them encloses is outside. */
export const path_of_told = (
  contours: readonly (readonly ToldVertex[])[],
  is_closed: boolean,
  turned = false,
): string =>
  contours.map((told) => path_of(elements_of(told, is_closed, turned), is_closed)).join('');
