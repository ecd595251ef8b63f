/** The part from above (of a lathe its half section) as the tree of its features tells it: what is cut, the deeper the darker. */
import { type Feature, type FeaturesDocument, is_turned, type ToldVertex } from './document';
import { type Element, elements_of, type Point } from './elements';
import type { Extents } from './frame';
import type { Preview, Regions } from './preview';
import { path_of, path_of_told } from './svg_path';

/** Painted in their order. */
export interface Face {
  path: string;
  /** From 0, the top of the stock, to 1, its bottom; null: nothing is left there. */
  depth: number | null;
}

/** A feature that is edited: what the edits make of it. */
export interface Edited {
  feature: Feature;
  answer: Preview | null;
  /** Of a lathe: its contour as it is drawn. */
  elements: readonly Element[];
}

type Range = [number, number];
const whole = (range: Range | undefined): Range => range ?? [0, 0];

/** Of the set-up of what is edited, before the edits or behind them. */
export function faces_of(document: FeaturesDocument, edited: Edited, is_after: boolean): Face[] {
  const { setup } = edited.feature;
  const own = document.features.filter((feature) => feature.setup === setup);
  if (is_turned(edited.feature)) return turned_faces(document, own, edited, is_after);
  const { X, Y, Z } = document.stock.extents;
  const depth_of = ([low, high]: Range) => depth_in(low, Math.max(high, 0));
  const depth = depth_of(whole(Z));
  const faces = own
    .filter((feature) => !is_turned(feature))
    .flatMap((feature) =>
      is_after && feature.id === edited.feature.id
        ? changed_layers(edited, depth)
        : layers_of(feature, depth),
    );
  const holes = document.holes
    .filter((hole) => hole.setup === setup)
    .map(({ at, diameter, z }) => ({ path: circle(at, diameter / 2), depth: depth(z[1]) }));
  return [{ path: box(whole(X), whole(Y)), depth: 0 }, ...faces, ...holes];
}

type Depth = (z: number) => number;

const depth_in =
  (low: number, high: number): Depth =>
  (z) =>
    high > low ? Math.min(1, Math.max(0, (high - z) / (high - low))) : 0;

const layers_of = (feature: Feature, depth: Depth): Face[] =>
  feature.layers.map(({ contour, islands, z }) => ({
    path: path_of_told([contour, ...islands], true),
    depth: depth(z),
  }));

/** Whose contour is what stays, not what is cut. */
const STAYS = new Set(['outside-profile', 'inside-profile', 'boss', 'chamfer']);

/** What is cut from above downwards, then what stays standing from below upwards: that is how it is seen. */
function changed_layers({ feature, answer }: Edited, depth: Depth): Face[] {
  const told = (list: readonly Regions[] | undefined, n: number): string =>
    path_of_told(
      (list ?? [])
        .filter((each) => each.feature === feature.id && each.layer === n)
        .flatMap(({ regions }) => regions),
      true,
    );
  const own = (answer?.contours ?? []).filter((each) => each.feature === feature.id);
  const is_cut = !STAYS.has(feature.type);
  const cut: Face[] = [];
  const stays: Face[] = [];
  for (const layer of feature.layers) {
    const { n, z, top } = layer;
    const contours = is_cut ? own.filter((each) => each.layer === n) : [];
    const path = contours.map(({ elements, closed }) => path_of(elements, closed)).join('');
    const before = layers_of({ ...feature, layers: [layer] }, depth);
    cut.push(...(path ? [{ path, depth: depth(z) }] : before));
    if (!path) cut.push({ path: told(answer?.added, n), depth: depth(z) });
    stays.unshift({ path: told(path ? answer?.rest : answer?.removed, n), depth: depth(top) });
  }
  return [...cut, ...stays].filter((face) => face.path !== '');
}

const box = ([x, x2]: Range, [y, y2]: Range): string => `M${x} ${y}H${x2}V${y2}H${x}Z`;
const circle = ([x, y]: Point, r: number): string =>
  `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;

/** How large the picture is: the stock, of a lathe its half. */
export function extents_of_part({ stock }: FeaturesDocument, turned: boolean): Extents {
  const [x, x2] = whole(stock.extents.X);
  const [y, y2] = turned ? [0, 0] : whole(stock.extents.Y);
  const [z, z2] = whole(stock.extents.Z);
  return turned ? { low: [z, 0], high: [z2, x2 / 2] } : { low: [x, y], high: [x2, y2] };
}

/** The bar, and what is turned away between each contour and where its tool has come from. */
function turned_faces(
  document: FeaturesDocument,
  own: readonly Feature[],
  { feature, elements }: Edited,
  is_after: boolean,
): Face[] {
  const { X, Z } = document.stock.extents;
  const [low, high] = whole(Z);
  const bar: Range = [0, whole(X)[1] / 2];
  const cut = own
    .filter(({ type }) => type !== 'thread')
    .map((each) => {
      const told = (list: readonly ToldVertex[]) => elements_of(list, false, true);
      const shown = is_after && each.id === feature.id ? elements : told(each.contour);
      return { path: cut_away(each.type, shown, bar[1], high), depth: null };
    });
  const known = cut.filter(({ path }) => path !== '');
  return [{ path: box([low, high], bar), depth: 0 }, ...known];
}

const INNER = new Set(['boring', 'drilling']);
const FROM_FRONT = new Set(['facing', 'face-groove']);

function cut_away(type: string, elements: readonly Element[], radius: number, front: number) {
  const [first, last] = [elements[0], elements.at(-1)];
  if (!first || !last) return '';
  const way = path_of(elements, false);
  if (FROM_FRONT.has(type)) return `${way}L${front} ${last.to[1]}L${front} ${first.from[1]}Z`;
  const to = INNER.has(type) ? 0 : radius;
  return `${way}L${last.to[0]} ${to}L${first.from[0]} ${to}Z`;
}
