/** What a program is like, told when it opens: by the preview run and the recognition of the server. */
import type { Lines } from './document';

export interface InsightTool {
  tool: number;
  description: string;
  time_s: number;
  cut_mm: number;
  lines: Lines;
}

export interface AxisTravel {
  axis: string;
  from: number;
  to: number;
  limit_from: number | null;
  limit_to: number | null;
}

export interface Insight {
  size: { lines: number; bytes: number };
  time_s: number | null;
  tools: InsightTool[];
  /** How many of each type; null: not recognised yet. */
  features: Record<string, number> | null;
  travel: AxisTravel[];
  /** `program` is null where the call names none. */
  missing: { program: string | null; message: string; line: number }[];
  not_understood: { line: number; code: string; message: string }[];
  unrecognised: { lines: Lines }[] | null;
}

/** Of all that the axis may go, from 0 to 100; null: it has no ends. */
export function travel_share({ from, to, limit_from, limit_to }: AxisTravel): number | null {
  if (limit_from === null || limit_to === null || limit_to <= limit_from) return null;
  return Math.round((100 * (to - from)) / (limit_to - limit_from));
}

/** However the work is clamped: the tool's tip goes farther than the axis does. Where it lies in the travel, the offsets say. */
export const is_too_long = (travel: AxisTravel): boolean => (travel_share(travel) ?? 0) > 100;
