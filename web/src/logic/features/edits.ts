/** The edits file of `kerf edit`, as the page writes it: it does nothing that the command cannot. */
import { type Point, rounded_point } from './elements';

export interface Edit {
  op: string;
  feature?: string;
  layer?: number;
  island?: number;
  layers?: 'rebuild' | 'all' | 'only';
  scope?: 'all' | 'this';
  unroll?: boolean;
  element?: number;
  elements?: [number, number];
  corner?: number;
  from?: Point;
  to?: Point;
  at?: Point;
  through?: Point[];
  center?: Point;
  radius?: number;
  length?: number;
  angle_deg?: number;
  r?: number;
  d1?: number;
  d2?: number;
  dx?: number;
  dy?: number;
  dz?: number;
  z?: number;
  x?: number;
  contour?: [number, number, number][];
  pattern?: string;
  call?: string;
  letter?: string;
  variable?: number;
  value?: number;
}

const POINTS = ['from', 'to', 'at', 'center'] as const;

/** Of a lathe, whose contours are drawn with radii and told with diameters. */
export function with_diameters(edit: Edit): Edit {
  const told = ([z, x]: Point): Point => rounded_point([z, 2 * x]);
  const points = POINTS.filter((name) => edit[name]).map((name) => [name, told(edit[name]!)]);
  const through = edit.through ? { through: edit.through.map(told) } : {};
  return { ...edit, ...Object.fromEntries(points), ...through };
}

/** One edit a line, so that a place in the file says which one is meant. */
export function edits_text(edits: readonly Edit[]): string {
  const lines = edits.map((edit) => `  ${JSON.stringify(edit)}`);
  return `{"version":1,"edits":[\n${lines.join(',\n')}\n]}\n`;
}

/** `part.nc` has its edits in `part-edits.json`. */
export const edits_name = (program: string): string =>
  `${program.replace(/\.[^.]*$/, '') || 'program'}-edits.json`;
