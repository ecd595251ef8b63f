/**
 * Step pulses of the last seconds as curves. An axis gets a lane of height 1; within it lies the direction of the step and,
 * where pulses stand too close to be seen one by one, their rate.
 */

/** Edges of one axis: time, direction (+1, -1), time, direction … */
export type Edges = number[];

/** The time in which one NC line moves the axes. */
export interface LineSpan {
  line: number;
  from_s: number;
  to_s: number;
}

export const line_spans = (rows: [from_s: number, to_s: number, line: number][]): LineSpan[] =>
  rows.map(([from_s, to_s, line]) => ({ line, from_s, to_s }));

export interface Lane {
  name: string;
  /** Sum of the steps over time: the place of the axis in steps, for the readout. */
  steps: number;
  peak_hz: number;
}

export interface Waves {
  time_s: Float64Array;
  /** For each axis the height of its curve at each time; NaN lifts the pen. */
  curves: Float64Array[];
  lanes: Lane[];
  lines: LineSpan[];
}

const FILL = 0.8;

/** `columns` is how many pixels there are: with fewer edges each pulse is drawn, otherwise their rate. */
export function waves(
  axes: Record<string, Edges>,
  lines: LineSpan[],
  from_s: number,
  to_s: number,
  columns: number,
): Waves {
  const time = (_: unknown, i: number): number => from_s + ((to_s - from_s) * i) / columns;
  const time_s = Float64Array.from({ length: columns + 1 }, time);
  const named = Object.entries(axes);
  const signed = named.map(([, edges]) => rates(edges, from_s, to_s, columns));
  const lanes = named.map(([name, edges], i) => lane_of(name, edges, signed[i]));
  const curves = signed.map((rate, i) => in_lane(rate, lanes[i].peak_hz, named.length - 1 - i));
  return { time_s, curves, lanes, lines };
}

function lane_of(name: string, edges: Edges, rate: Float64Array): Lane {
  return { name, steps: steps_of(edges), peak_hz: Math.max(0, ...rate.map(Math.abs)) };
}

/** Steps a second in each column, negative backwards; one value more than columns, the last repeated. */
export function rates(edges: Edges, from_s: number, to_s: number, columns: number): Float64Array {
  const width = (to_s - from_s) / columns;
  const rate = new Float64Array(columns + 1);
  for (let i = 0; i + 1 < edges.length; i += 2) {
    const column = Math.floor((edges[i] - from_s) / width);
    if (column >= 0 && column < columns) rate[column] += edges[i + 1] / width;
  }
  rate[columns] = rate[columns - 1];
  return rate;
}

function in_lane(rate: Float64Array, peak_hz: number, lane: number): Float64Array {
  const half = FILL / 2;
  return rate.map((value) => lane + 0.5 + (peak_hz > 0 ? (half * value) / peak_hz : 0));
}

function steps_of(edges: Edges): number {
  let sum = 0;
  for (let i = 1; i < edges.length; i += 2) sum += edges[i];
  return sum;
}
