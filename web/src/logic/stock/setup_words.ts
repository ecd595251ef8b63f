/** Words for what lies on the table (docs/stock.md): `box:0,0,-20,100,60,0`, as fields of a form and back. */

export type ShapeKind = 'extents' | 'box' | 'cylinder' | 'tube' | 'bar' | 'sheet' | 'file';

/** Numbers behind the word, by the names of their fields; of a bar the last one may be missing. */
export const SHAPE_FIELDS: Record<Exclude<ShapeKind, 'file'>, readonly string[]> = {
  extents: ['margin'],
  box: ['x0', 'y0', 'z0', 'x1', 'y1', 'z1'],
  cylinder: ['u', 'v', 'w0', 'w1', 'diameter'],
  tube: ['u', 'v', 'w0', 'w1', 'diameter', 'bore'],
  bar: ['diameter', 'w0', 'w1', 'bore'],
  sheet: ['x0', 'y0', 'x1', 'y1', 'thickness'],
};
const MAY_BE_MISSING: readonly string[] = ['bore'];

export interface ShapeWord {
  kind: ShapeKind;
  /** Of a cylinder or tube. */
  axis: 'X' | 'Y' | 'Z';
  values: Record<string, number | null>;
  file: string;
}

export const FRESH: Record<ShapeKind, string> = {
  extents: 'extents:5',
  box: 'box:0,0,-20,100,60,0',
  cylinder: 'cylinder:Z,0,0,-20,0,80',
  tube: 'tube:Z,0,0,-20,0,80,30',
  bar: 'bar:50,-80,0',
  sheet: 'sheet:0,0,200,150,3',
  file: '',
};

/** Null: it is no such word. */
export function read_shape(word: string): ShapeWord | null {
  const text = word.trim();
  const blank: ShapeWord = { kind: 'file', axis: 'Z', values: {}, file: text };
  const [head, ...rest] = text.split(':');
  const kind = head.toLowerCase() as ShapeKind;
  if (kind === 'file' || !(kind in SHAPE_FIELDS))
    return /\.(stl|kstock)$/i.test(text) ? blank : null;
  const fields = SHAPE_FIELDS[kind as Exclude<ShapeKind, 'file'>];
  const parts = rest.length ? rest.join(':').split(',') : [];
  let axis: ShapeWord['axis'] = 'Z';
  if (kind === 'cylinder' || kind === 'tube') {
    const letter = (parts.shift() ?? '').trim().toUpperCase();
    if (letter !== 'X' && letter !== 'Y' && letter !== 'Z') return null;
    axis = letter;
  }
  if (kind === 'extents' && parts.length === 0) parts.push('5');
  if (parts.length > fields.length) return null;
  const values: Record<string, number | null> = {};
  for (const [i, field] of fields.entries()) {
    const part = parts[i]?.trim();
    if (part === undefined) {
      if (kind !== 'bar' || !MAY_BE_MISSING.includes(field)) return null;
      values[field] = null;
      continue;
    }
    const value = Number(part);
    if (part === '' || !Number.isFinite(value)) return null;
    values[field] = value;
  }
  return { kind, axis, values, file: '' };
}

export function written_shape({ kind, axis, values, file }: ShapeWord): string {
  if (kind === 'file') return file;
  const numbers = SHAPE_FIELDS[kind].map((field) => values[field]);
  while (numbers.length && numbers[numbers.length - 1] === null) numbers.pop();
  const words = numbers.map((value) => String(value ?? 0));
  return `${kind}:${[...(kind === 'cylinder' || kind === 'tube' ? [axis] : []), ...words].join(',')}`;
}

/** What cannot be, by the field that says it; null: nothing. */
export function wrong_field({ kind, values }: ShapeWord): string | null {
  const at = (field: string): number => values[field] ?? 0;
  const pairs: [string, string][] = [
    ['x0', 'x1'],
    ['y0', 'y1'],
    ['z0', 'z1'],
    ['w0', 'w1'],
  ];
  if (kind === 'file') return null;
  for (const [low, high] of pairs)
    if (SHAPE_FIELDS[kind].includes(high) && !(at(low) < at(high))) return high;
  for (const field of ['diameter', 'thickness'])
    if (SHAPE_FIELDS[kind].includes(field) && !(at(field) > 0)) return field;
  const { bore } = values;
  if (bore !== undefined && bore !== null && !(bore > 0 && bore < at('diameter'))) return 'bore';
  if (kind === 'extents' && at('margin') < 0) return 'margin';
  return null;
}

/** The box or body of revolution that a word stands for, from the zero of the stock; null: it has to be computed. */
export type Solid =
  | { kind: 'box'; low: [number, number, number]; high: [number, number, number] }
  | {
      kind: 'round';
      axis: 0 | 1 | 2;
      centre: [number, number];
      from: number;
      to: number;
      radius: number;
      bore: number;
    };

export function solid_of(word: string): Solid | null {
  const shape = read_shape(word);
  if (!shape || wrong_field(shape)) return null;
  const { kind, values: v } = shape;
  const n = (field: string): number => v[field] ?? 0;
  if (kind === 'box')
    return { kind, low: [n('x0'), n('y0'), n('z0')], high: [n('x1'), n('y1'), n('z1')] };
  if (kind === 'sheet')
    return { kind: 'box', low: [n('x0'), n('y0'), -n('thickness')], high: [n('x1'), n('y1'), 0] };
  if (kind === 'extents' || kind === 'file') return null;
  const axis = kind === 'bar' ? 2 : (['X', 'Y', 'Z'].indexOf(shape.axis) as 0 | 1 | 2);
  return {
    kind: 'round',
    axis,
    centre: [n('u'), n('v')],
    from: n('w0'),
    to: n('w1'),
    radius: n('diameter') / 2,
    bore: n('bore') / 2,
  };
}
