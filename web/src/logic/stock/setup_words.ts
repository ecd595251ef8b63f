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
  const [head, ...rest] = text.split(':');
  const kind = head.toLowerCase();
  if (!is_kind(kind)) return /\.(stl|kstock)$/i.test(text) ? file_word(text) : null;
  const parts = rest.length ? rest.join(':').split(',') : [];
  const axis = has_axis(kind) ? axis_of(parts.shift() ?? '') : 'Z';
  if (kind === 'extents' && parts.length === 0) parts.push('5');
  const values = axis && read_values(kind, parts);
  return values && { kind, axis, values, file: '' };
}

type NumberedKind = Exclude<ShapeKind, 'file'>;
const is_kind = (kind: string): kind is NumberedKind => Object.hasOwn(SHAPE_FIELDS, kind);
export const has_axis = (kind: ShapeKind): boolean => kind === 'cylinder' || kind === 'tube';
const file_word = (file: string): ShapeWord => ({ kind: 'file', axis: 'Z', values: {}, file });

function axis_of(part: string): ShapeWord['axis'] | null {
  const letter = part.trim().toUpperCase();
  return letter === 'X' || letter === 'Y' || letter === 'Z' ? letter : null;
}

/** Null: too many, too few, or not all of them numbers. */
function read_values(kind: NumberedKind, parts: string[]): ShapeWord['values'] | null {
  const fields = SHAPE_FIELDS[kind];
  const values = fields.map((field, i) =>
    parts[i] === undefined && may_be_missing(kind, field) ? null : number_in(parts[i]),
  );
  if (parts.length > fields.length || values.includes(undefined)) return null;
  return Object.fromEntries(fields.map((field, i) => [field, values[i] as number | null]));
}

const may_be_missing = (kind: ShapeKind, field: string): boolean =>
  kind === 'bar' && field === 'bore';

function number_in(part = ''): number | undefined {
  const text = part.trim();
  return text !== '' && Number.isFinite(Number(text)) ? Number(text) : undefined;
}

export function written_shape({ kind, axis, values, file }: ShapeWord): string {
  if (kind === 'file') return file;
  const numbers = SHAPE_FIELDS[kind].map((field) => values[field]);
  while (numbers.length && numbers[numbers.length - 1] === null) numbers.pop();
  const words = numbers.map((value) => String(value ?? 0));
  return `${kind}:${[...(has_axis(kind) ? [axis] : []), ...words].join(',')}`;
}

const LOW_AND_HIGH: readonly (readonly [low: string, high: string])[] = [
  ['x0', 'x1'],
  ['y0', 'y1'],
  ['z0', 'z1'],
  ['w0', 'w1'],
];

/** What cannot be, by the field that says it; null: nothing. */
export function wrong_field({ kind, values }: ShapeWord): string | null {
  if (kind === 'file') return null;
  const fields = SHAPE_FIELDS[kind];
  const at = (field: string): number => values[field] ?? 0;
  const turned = LOW_AND_HIGH.find(([low, high]) => fields.includes(high) && !(at(low) < at(high)));
  if (turned) return turned[1];
  const flat = ['diameter', 'thickness'].find((f) => fields.includes(f) && !(at(f) > 0));
  if (flat) return flat;
  if (is_wide(values.bore, at('diameter'))) return 'bore';
  return kind === 'extents' && at('margin') < 0 ? 'margin' : null;
}

const is_wide = (bore: number | null | undefined, diameter: number): boolean =>
  bore !== undefined && bore !== null && !(bore > 0 && bore < diameter);

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
  const { kind } = shape;
  if (kind === 'box' || kind === 'sheet') return box_of(shape);
  return kind === 'extents' || kind === 'file' ? null : round_of(shape);
}

function box_of({ kind, values: v }: ShapeWord): Solid {
  const n = (field: string): number => v[field] ?? 0;
  const [low, high] = kind === 'sheet' ? [-n('thickness'), 0] : [n('z0'), n('z1')];
  return { kind: 'box', low: [n('x0'), n('y0'), low], high: [n('x1'), n('y1'), high] };
}

function round_of({ kind, axis, values: v }: ShapeWord): Solid {
  const n = (field: string): number => v[field] ?? 0;
  return {
    kind: 'round',
    axis: kind === 'bar' ? 2 : (['X', 'Y', 'Z'].indexOf(axis) as 0 | 1 | 2),
    centre: [n('u'), n('v')],
    ...{ from: n('w0'), to: n('w1') },
    ...{ radius: n('diameter') / 2, bore: n('bore') / 2 },
  };
}
