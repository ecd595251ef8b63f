import { describe, expect, it } from 'vitest';
import {
  EMPTY_SETUP,
  is_bad,
  read_setup,
  type Setup,
  with_coordinate,
  with_key,
  written_setup,
} from '../src/logic/stock/setup';
import {
  FRESH,
  read_shape,
  type ShapeKind,
  solid_of,
  wrong_field,
  written_shape,
} from '../src/logic/stock/setup_words';

const read = (toml: string): Setup => {
  const setup = read_setup(toml);
  if (is_bad(setup)) throw new Error(setup.message);
  return setup;
};

const TOML = `
[stock]
shape = "box:0,0,-20,100,60,0"
zero = "G55"
place = "0,0,5"
unit = "inch"

[[fixture]]
shape = "box:-10,0,-20,0,60,5"
name = "left jaw"
colour = "red"

[material]
group = "N"
energy_j_mm3 = 12.5

[checks]
touch_mm = 0.02
no_check = ["STOCK_MISSED"]
fail_on = "error"
lengths = "real"

[design]
file = "part.stl"
place = [10, 0, 0, 0, 0, 90]
tolerance = 0.1

[[tool]]
number = 5
type = "bull"
diameter = 12
corner_radius = 2
limits = {fz = 0.12}
holder_name = "ER32"

[[holder]]
name = "ER32"
segments = [ {height = 50, diameter = 63} ]
`;

describe('a set-up', () => {
  it('is read with all that the forms show', () => {
    expect(read(TOML)).toMatchObject({
      stock: 'box:0,0,-20,100,60,0',
      zero: 'G55',
      place: [0, 0, 5],
      stock_unit: 'inch',
      fixtures: [{ name: 'left jaw', shape: 'box:-10,0,-20,0,60,5', unit: '' }],
      material: { group: 'N', kc11: null, mc: null, energy_j_mm3: 12.5 },
      checks: {
        touch_mm: 0.02,
        no_check: ['STOCK_MISSED'],
        fail_on: 'error',
        lengths: 'real',
      },
      design: { file: 'part.stl', unit: '', place: [10, 0, 0, 0, 0, 90], tolerance: 0.1 },
      tools: [{ number: 5, type: 'bull', diameter: 12 }],
      holders: [{ name: 'ER32' }],
    });
  });

  it('comes back with what the forms do not know', () => {
    const again = read(written_setup({ ...read(TOML), stock: 'extents:2' }));
    expect(again.stock).toBe('extents:2');
    expect(again.whole).toMatchObject({
      material: { group: 'N', energy_j_mm3: 12.5 },
      checks: { touch_mm: 0.02, no_check: ['STOCK_MISSED'] },
      design: { file: 'part.stl' },
      fixture: [{ colour: 'red' }],
      tool: [{ limits: { fz: 0.12 } }],
    });
  });

  it('that is read and written is the same again', () => {
    const once = written_setup(read(TOML));
    expect(written_setup(read(once))).toBe(once);
  });

  it('without anything is an empty text, and an empty text is one', () => {
    expect(written_setup(EMPTY_SETUP)).toBe('');
    expect(read('')).toEqual(EMPTY_SETUP);
  });

  it('loses a key that is emptied', () => {
    const setup = read('[stock]\nshape = "extents:5"\nzero = "G54"\n');
    expect(written_setup({ ...setup, stock: '', zero: '' })).toBe('');
    expect(with_key({ number: 1, diameter: 6 }, 'diameter', undefined)).toEqual({ number: 1 });
  });

  it('that is no TOML says in which line', () => {
    expect(read_setup('[stock]\nshape = \n')).toMatchObject({ line: 2 });
  });

  it('of nonsense is read without a stumble', () => {
    const setup = read(
      'stock = 3\nfixture = "x"\ntool = [{type = "flat"}, 5]\nchecks = {no_check = 7, fail_on = "x"}\n' +
        'design = {place = ["a"], tolerance = "wide"}\nmaterial = []\n',
    );
    expect(setup).toEqual({ ...EMPTY_SETUP, whole: setup.whole });
  });

  it('keeps what its forms could not read until they change it', () => {
    const setup = read('[stock]\nplace = ["a"]\n[checks]\ntouch_mm = "wide"\nsplendid = 1\n');
    const again = read(written_setup({ ...setup, stock: 'extents:1' }));
    expect(again.whole).toEqual({
      stock: { place: ['a'], shape: 'extents:1' },
      checks: { touch_mm: 'wide', splendid: 1 },
    });
    const changed = { ...setup, checks: { ...setup.checks, touch_mm: 0.05 } };
    expect(read(written_setup(changed)).whole.checks).toEqual({ touch_mm: 0.05, splendid: 1 });
  });

  it('writes places as lists, as short as they can be', () => {
    expect(with_coordinate([], 2, 5)).toEqual([0, 0, 5]);
    expect(with_coordinate([0, 0, 5], 5, 90)).toEqual([0, 0, 5, 0, 0, 90]);
    expect(with_coordinate([0, 0, 5, 0, 0, 90], 5, null)).toEqual([0, 0, 5]);
    expect(with_coordinate([0, 0, 5], 2, 0)).toEqual([]);
    const text = written_setup({ ...EMPTY_SETUP, place: [0, 0, 5], stock: 'extents:5' });
    expect(text).toMatch(/place = \[\s*0,\s*0,\s*5\s*\]/);
  });

  it('has own numbers of a material instead of a group', () => {
    const own = { group: '', kc11: 850, mc: 0.24, energy_j_mm3: null };
    const again = read(written_setup({ ...read(TOML), material: own }));
    expect(again.whole.material).toEqual({ kc11: 850, mc: 0.24 });
  });
});

describe('a word for a shape', () => {
  it.each(Object.keys(FRESH).filter((kind) => kind !== 'file') as ShapeKind[])(
    'comes back as it was, and a fresh one is right: %s',
    (kind) => {
      const shape = read_shape(FRESH[kind]);
      expect(shape?.kind).toBe(kind);
      expect(written_shape(shape!)).toBe(FRESH[kind]);
      expect(wrong_field(shape!)).toBeNull();
    },
  );
  it('may be a file, and a bar without a bore', () => {
    expect(read_shape('part.stl')).toMatchObject({ kind: 'file', file: 'part.stl' });
    expect(read_shape('bar:50,-80,0')?.values.bore).toBeNull();
    expect(written_shape(read_shape('bar:50,-80,0,20')!)).toBe('bar:50,-80,0,20');
    expect(read_shape('extents')?.values.margin).toBe(5);
  });
  it.each([
    '',
    'ball:3',
    'box:1,2,3',
    'box:1,2,3,4,5,x',
    'cylinder:0,0,0,1,2',
    'box:0,0,0,1,1,1,1',
    'box:1,,3,4,5,6',
  ])('is none: %s', (word) => expect(read_shape(word)).toBeNull());
  it.each([
    ['box:0,0,0,-1,1,1', 'x1'],
    ['box:0,0,0,1,1,0', 'z1'],
    ['cylinder:X,0,0,0,10,0', 'diameter'],
    ['tube:Z,0,0,0,10,20,20', 'bore'],
    ['sheet:0,0,10,10,0', 'thickness'],
    ['extents:-1', 'margin'],
  ])('%s cannot be: %s', (word, field) => expect(wrong_field(read_shape(word)!)).toBe(field));

  it('stands for a body, if it says one', () => {
    expect(solid_of('sheet:0,0,20,10,3')).toEqual({
      kind: 'box',
      low: [0, 0, -3],
      high: [20, 10, 0],
    });
    expect(solid_of('tube:X,1,2,-5,5,20,8')).toEqual({
      kind: 'round',
      axis: 0,
      centre: [1, 2],
      from: -5,
      to: 5,
      radius: 10,
      bore: 4,
    });
    expect(solid_of('extents:5')).toBeNull();
    expect(solid_of('box:0,0,0,0,0,0')).toBeNull();
  });
});
