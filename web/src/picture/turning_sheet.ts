/** What stands behind the path of a lathe: a sheet in Z and X with its scales, X as diameters, and the centre line. */
import { Group, type LineSegments, type Sprite } from 'three';
import { type Box, empty_box, is_empty, join, size } from '../logic/box';
import { DIAMETER } from '../logic/diameters';
import { type Palette, label, lines, round_step } from './furniture';

const LINES = 24;
const STRONG = 5;
const LABEL_PX = 15;
const MARGIN = 0.12;
/** Where the middle of a label of Z lies, in heights of it over the centre line. */
const BELOW_THE_LINE = 1.2;
/** Of the centre line: strokes and gaps in parts of a line of the grid. */
const DASHES: readonly [from: number, to: number][] = [
  [0, 0.62],
  [0.76, 0.86],
];

/** Where the work has its zero, in the scene: on the centre line. */
export interface WorkZero {
  x: number;
  z: number;
}

/** With the half beyond the centre line that the work has as well. */
export function with_mirrored(box: Box, { x }: WorkZero): Box {
  if (is_empty(box)) return box;
  const whole = structuredClone(box);
  join(whole, {
    min: [2 * x - box.max[0], box.min[1], box.min[2]],
    max: [2 * x - box.min[0], box.max[1], box.max[2]],
  });
  return whole;
}

/** Around the cuts, or the travel where nothing cuts. Its scales count from the zero of the work. */
export function turning_sheet(cuts: Box, travel: Box, zero: WorkZero, palette: Palette): Group {
  const group = new Group();
  const box = from_zero(widened(is_empty(cuts) ? travel : with_mirrored(cuts, zero)), zero);
  const step = round_step(Math.max(size(box)[0], size(box)[2]) / LINES);
  const fine = rounded(box, step);
  group.add(
    grid(fine, step, palette.grid),
    grid(fine, step * STRONG, palette.grid_strong),
    centre_line(fine, step, palette.text),
    ...scale_labels(fine, step * STRONG, palette.text),
  );
  group.position.set(zero.x, 0, zero.z);
  return group;
}

const from_zero = ({ min, max }: Box, { x, z }: WorkZero): Box => ({
  min: [min[0] - x, min[1], min[2] - z],
  max: [max[0] - x, max[1], max[2] - z],
});

function widened(box: Box): Box {
  const [x, , z] = size(box);
  const by = MARGIN * Math.max(x, z);
  const wide = empty_box();
  join(wide, box);
  wide.min = [box.min[0] - by, 0, box.min[2] - by];
  wide.max = [box.max[0] + by, 0, box.max[2] + by];
  return wide;
}

const rounded = (box: Box, step: number): Box => ({
  min: box.min.map((value) => Math.floor(value / step) * step) as Box['min'],
  max: box.max.map((value) => Math.ceil(value / step) * step) as Box['max'],
});

/** Multiples of a step from `low` to `high`. */
function multiples(low: number, high: number, step: number): number[] {
  const first = Math.ceil(low / step - 1e-9);
  const count = Math.max(0, Math.floor(high / step + 1e-9) - first + 1);
  return Array.from({ length: count }, (_, i) => (first + i) * step || 0);
}

function grid({ min, max }: Box, step: number, colour: string): LineSegments {
  const points: number[] = [];
  for (const x of multiples(min[0], max[0], step)) points.push(x, 0, min[2], x, 0, max[2]);
  for (const z of multiples(min[2], max[2], step)) points.push(min[0], 0, z, max[0], 0, z);
  const sheet = lines(points, colour);
  sheet.position.y = -0.5; // behind the path
  return sheet;
}

function centre_line({ min, max }: Box, step: number, colour: string): LineSegments {
  const points: number[] = [];
  for (const z of multiples(min[2], max[2] - step, step))
    for (const [from, to] of DASHES) points.push(0, 0, z + from * step, 0, 0, z + to * step);
  return lines(points, colour);
}

function scale_labels({ min, max }: Box, step: number, colour: string): Sprite[] {
  const at = (text: string, x: number, z: number, above: number): Sprite => {
    const sprite = label(text, colour, LABEL_PX);
    sprite.position.set(x, 0, z);
    sprite.center.set(0.5, above);
    return sprite;
  };
  const number = (value: number): string => String(Number(value.toFixed(3)));
  return [
    ...multiples(0, max[0], step).map((x) => at(`${DIAMETER}${number(2 * x)}`, x, min[2], 0.5)),
    ...multiples(min[2], max[2], step).map((z) => at(`Z${number(z)}`, 0, z, BELOW_THE_LINE)),
  ];
}
