/**
 * Colours of the motions that have cut the part: by their tools, with those of one line standing out, or by a number of each on a
 * scale. A row of the table is red, green, blue and how far they hide the colour of the stock, 0 to 255.
 */
import { type Rgb, type Scheme, scale_colour, tool_colour } from '../colour_scale';
import type { Owner, PartFacts } from './part_store';

export type StockColouring = 'tool' | 'line' | 'engagement' | 'deviation' | 'stock' | 'energy';
export const MOST_OWNERS = 65536;

const TOOL_HIDES = 0.68;
const LINE_HIDES = 0.94;
const REST_HIDES = 0.22;
const SCALE_HIDES = 0.86;
/** Degrees: a full slot. */
export const MOST_ENGAGEMENT = 180;
const LINE: Record<Scheme, Rgb> = { dark: [1, 0.86, 0.36], light: [0.86, 0.42, 0.02] };

/** Where the scale of deviations ends, mm: twice the tolerance; 0: there is no design. */
export const most_deviation = ({ design }: Pick<PartFacts, 'design'>): number =>
  2 * (design?.tolerance_mm ?? 0);

export function fill_table(
  table: Uint8Array,
  owners: readonly Owner[],
  colouring: StockColouring,
  scheme: Scheme,
  chosen: { file: number; line: number } | null,
): void {
  owners.forEach((owner, i) => {
    if (i >= MOST_OWNERS) return;
    const is_chosen = chosen !== null && owner.line === chosen.line && owner.file === chosen.file;
    const [colour, hides] = look_of(owner, colouring, scheme, is_chosen);
    for (let c = 0; c < 3; c++) table[4 * i + c] = Math.round(255 * colour[c]);
    table[4 * i + 3] = Math.round(255 * (i === 0 ? 0 : hides));
  });
}

type Look = [colour: Rgb, hides: number];

function look_of(
  { tool, engagement_deg }: Owner,
  colouring: StockColouring,
  scheme: Scheme,
  is_chosen: boolean,
): Look {
  if (colouring === 'engagement') return engaged(engagement_deg, scheme);
  if (colouring === 'line')
    return is_chosen ? [LINE[scheme], LINE_HIDES] : [tool_colour(tool, scheme), REST_HIDES];
  if (colouring === 'tool') return [tool_colour(tool, scheme), TOOL_HIDES];
  return [scale_colour(0, scheme), 0];
}

const engaged = (angle_deg: number | null, scheme: Scheme): Look =>
  angle_deg === null
    ? [scale_colour(0, scheme), 0]
    : [scale_colour(angle_deg / MOST_ENGAGEMENT, scheme), SCALE_HIDES];
