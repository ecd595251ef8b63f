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

/** Null: it says too little to be drawn. */
export function tool_shape(
  tool: ToolTable,
  holders: readonly { name: string; segments: unknown }[] = [],
): ToolShape | null {
  const type = type_of(tool);
  if (is_turning(type)) return { turning: true, parts: turning_parts(tool, type) };
  const diameter = number_of(tool, 'diameter', type === 'form' ? 2 * widest(tool) : 0);
  if (!(diameter > 0)) return null;
  const cutting = cutting_outline(tool, type, diameter / 2);
  const top = cutting[cutting.length - 1];
  const flutes = number_of(tool, 'flute_length', top[1] + (is_headed(type) ? 0 : 2.5 * diameter));
  const parts: ToolPart[] = [];
  if (is_headed(type)) {
    parts.push({ kind: 'cutting', outline: cutting });
    const neck = number_of(tool, 'neck_diameter', 0.6 * diameter) / 2;
    const up = Math.max(top[1] + 0.5 * diameter, number_of(tool, 'flute_length', 0));
    parts.push({
      kind: 'neck',
      outline: stack([
        [neck, top[1]],
        [neck, up],
      ]),
    });
    return { turning: false, parts: with_holder(tool, parts, up, neck, holders) };
  }
  const height = Math.max(flutes, top[1]);
  parts.push({
    kind: 'cutting',
    outline: height > top[1] ? [...cutting, [top[0], height]] : cutting,
  });
  return { turning: false, parts: with_holder(tool, parts, height, top[0], holders) };
}

const is_headed = (type: ToolType): boolean =>
  ['t-slot', 'saw', 'dovetail', 'lollipop', 'thread-mill', 'probe'].includes(type);

function with_holder(
  tool: ToolTable,
  parts: ToolPart[],
  from: number,
  radius: number,
  holders: readonly { name: string; segments: unknown }[],
): ToolPart[] {
  const shank = segments_of(tool.shank);
  const named = holders.find(({ name }) => name === tool.holder_name)?.segments;
  const holder = segments_of(tool.holder ?? named);
  const stickout = number_of(tool, 'stickout', 0);
  const above = shank.length ? segment_outline(shank, from) : null;
  const reach = above ? above[above.length - 1][1] : from;
  if (above) parts.push({ kind: 'shank', outline: above });
  const wide = above ? above[above.length - 1][0] : radius;
  // What is between is as wide as what is below it.
  if (stickout > reach)
    parts.push({
      kind: 'shank',
      outline: [
        [wide, reach],
        [wide, stickout],
      ],
    });
  if (holder.length)
    parts.push({ kind: 'holder', outline: segment_outline(holder, Math.max(stickout, from)) });
  return parts;
}

interface Segment {
  height: number;
  lower: number;
  upper: number;
}

export function segments_of(value: unknown): Segment[] {
  if (!Array.isArray(value)) return [];
  return value.flatMap((raw) => {
    const table = raw as ToolTable;
    const diameter = number_of(table, 'diameter', 0);
    const segment = {
      height: number_of(table, 'height', 0),
      lower: number_of(table, 'lower', diameter),
      upper: number_of(table, 'upper', diameter),
    };
    return segment.height > 0 && segment.lower + segment.upper > 0 ? [segment] : [];
  });
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

const stack = (outline: Point2[]): Point2[] => outline;
