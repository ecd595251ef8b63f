/** By what the part can be coloured, and what its colours mean. */
import { deviation_stops, type Rgb, scale_stops, type Scheme } from '../colour_scale';
import { MOST_ENGAGEMENT, most_deviation, type StockColouring } from './owner_colours';
import type { Owner, PartFacts, Shape } from './part_store';

/** What a colour of the part can tell of. */
interface Known {
  facts: PartFacts;
  owners: readonly Owner[];
  shape: Shape | null;
}

/** The first one is that of a part that nobody has coloured yet. */
export function colourings_of({ facts, owners, shape }: Known): StockColouring[] {
  if (shape?.kind === 'sheet') return ['stock', 'energy'];
  const list: StockColouring[] = knows_owners(shape) ? ['tool', 'line'] : [];
  if (list.length && owners.some(({ engagement_deg }) => engagement_deg !== null))
    list.push('engagement');
  if (facts.design) list.push('deviation');
  return [...list, 'stock'];
}

/** Of a turned part they are told apart from its outline. */
const knows_owners = (shape: Shape | null): boolean =>
  shape?.kind !== 'profile' || shape.loops.some(({ owner }) => owner !== undefined);

/** What a legend says: which tools have which colour, or where on a scale which number is. */
export type PartLegend =
  | { kind: 'tools'; tools: number[] }
  | {
      kind: 'scale';
      low: number;
      high: number;
      stops: readonly Rgb[];
      /** Numbers that stand below it; otherwise round ones. */
      marks?: readonly number[];
    };

/** Degrees: a quarter, a half, all of the circle that can be in the material. */
const ENGAGEMENT_MARKS = [0, 45, 90, 135, MOST_ENGAGEMENT];

/** Null: the colours mean nothing. */
export function legend_of(
  colouring: StockColouring,
  { facts, owners, shape }: Known,
  scheme: Scheme,
): PartLegend | null {
  if (colouring === 'tool') return { kind: 'tools', tools: tools_of(owners) };
  if (colouring === 'engagement') return of_engagement(scheme);
  if (colouring === 'deviation') return of_deviation(most_deviation(facts));
  if (colouring !== 'energy' || shape?.kind !== 'sheet') return null;
  return { kind: 'scale', low: 0, high: shape.field.peak, stops: scale_stops(scheme) };
}

const of_engagement = (scheme: Scheme): PartLegend => ({
  kind: 'scale',
  low: 0,
  high: MOST_ENGAGEMENT,
  stops: scale_stops(scheme),
  marks: ENGAGEMENT_MARKS,
});

const of_deviation = (most: number): PartLegend => ({
  kind: 'scale',
  low: -most,
  high: most,
  stops: deviation_stops(),
});

/** Of those that have cut, in order. */
function tools_of(owners: readonly Owner[]): number[] {
  const tools = new Set(owners.slice(1).map(({ tool }) => tool));
  return [...tools].sort((a, b) => a - b);
}
