/**
 * What a tool looks like, from the keys of its `[[tool]]` table (docs/tools.md): half the outline of a rotating tool, radius and
 * height over the tip, in parts from below to above; of a turning tool the outline of insert and holder in Z and radius, from
 * its imaginary tip. For pictures only: what cuts is decided by the server.
 */
import { cutting_outline, widest } from './cutting_outline';
import { turning_parts } from './turning_shape';
import {
  is_turning,
  number_of,
  type Point2,
  type ToolPart,
  type ToolShape,
  type ToolTable,
  type ToolType,
  type_of,
} from './tool_table';

export * from './tool_table';

type Holders = readonly { name: string; segments: unknown }[];

/** Null: it says too little to be drawn. */
export function tool_shape(tool: ToolTable, holders: Holders = []): ToolShape | null {
  const type = type_of(tool);
  if (is_turning(type)) return { turning: true, parts: turning_parts(tool, type) };
  const diameter = number_of(tool, 'diameter', type === 'form' ? 2 * widest(tool) : 0);
  if (!(diameter > 0)) return null;
  const cutter = HEADED.includes(type) ? headed : straight;
  const parts = cutter(tool, cutting_outline(tool, type, diameter / 2), diameter);
  return { turning: false, parts: [...parts, ...above(tool, parts, holders)] };
}

/** What cuts is wider than the neck that carries it. */
const HEADED: readonly ToolType[] = [
  't-slot', 'saw', 'dovetail', 'lollipop', 'thread-mill', 'probe',
]; // prettier-ignore

function headed(tool: ToolTable, cutting: Point2[], diameter: number): ToolPart[] {
  const top = end_of(cutting)[1];
  const neck = number_of(tool, 'neck_diameter', 0.6 * diameter) / 2;
  const up = Math.max(top + 0.5 * diameter, number_of(tool, 'flute_length', 0));
  return [
    { kind: 'cutting', outline: cutting },
    { kind: 'neck', outline: tube(neck, top, up) },
  ];
}

/** Its flutes go on above the profile. */
function straight(tool: ToolTable, cutting: Point2[], diameter: number): ToolPart[] {
  const [wide, top] = end_of(cutting);
  const flutes = number_of(tool, 'flute_length', top + 2.5 * diameter);
  const outline: Point2[] = flutes > top ? [...cutting, [wide, flutes]] : cutting;
  return [{ kind: 'cutting', outline }];
}

/** Shank and holder; what is between is as wide as what is below it. */
function above(tool: ToolTable, below: ToolPart[], holders: Holders): ToolPart[] {
  const from = end_of(below[below.length - 1].outline);
  const shank = segment_outline(segments_of(tool.shank), from[1]);
  const named = holders.find(({ name }) => name === tool.holder_name)?.segments;
  const holder = segments_of(tool.holder ?? named);
  const stickout = number_of(tool, 'stickout', 0);
  const [wide, reach] = end_of([from, ...shank]);
  const between = stickout > reach ? tube(wide, reach, stickout) : [];
  const parts: ToolPart[] = [
    { kind: 'shank', outline: shank },
    { kind: 'shank', outline: between },
    { kind: 'holder', outline: segment_outline(holder, Math.max(stickout, from[1])) },
  ];
  return parts.filter(({ outline }) => outline.length);
}

const end_of = (outline: readonly Point2[]): Point2 => outline[outline.length - 1];
const tube = (radius: number, from: number, to: number): Point2[] => [
  [radius, from],
  [radius, to],
];

interface Segment {
  height: number;
  lower: number;
  upper: number;
}

export function segments_of(value: unknown): Segment[] {
  if (!Array.isArray(value)) return [];
  return value
    .map((raw) => segment_of(raw as ToolTable))
    .filter(({ height, lower, upper }) => height > 0 && lower + upper > 0);
}

function segment_of(table: ToolTable): Segment {
  const diameter = number_of(table, 'diameter', 0);
  return {
    height: number_of(table, 'height', 0),
    lower: number_of(table, 'lower', diameter),
    upper: number_of(table, 'upper', diameter),
  };
}

function segment_outline(segments: readonly Segment[], from: number): Point2[] {
  const outline: Point2[] = [];
  let height = from;
  for (const { height: by, lower, upper } of segments) {
    outline.push([lower / 2, height], [upper / 2, height + by]);
    height += by;
  }
  return outline;
}
