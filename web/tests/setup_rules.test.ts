import { describe, expect, it } from 'vitest';
import { checks_of_machine, is_check } from '../src/logic/stock/check_codes';
import { is_group, MATERIAL_GROUPS, MATERIALS } from '../src/logic/stock/materials';
import { EMPTY_SETUP, type Setup } from '../src/logic/stock/setup';
import { wrong_in } from '../src/logic/stock/setup_rules';

const { material, checks, design } = EMPTY_SETUP;
const wrong = (change: Partial<Setup>): string[] =>
  wrong_in({ ...EMPTY_SETUP, ...change }).map(({ field, text }) => `${field}: ${text}`);

describe('of a set-up', () => {
  it('nothing is wrong when nothing is said, nor with all that can be', () => {
    expect(wrong({})).toEqual([]);
    expect(
      wrong({
        stock: 'part.kstock',
        place: [1, 2, 3, 0, 0, -90],
        fixtures: [{ name: '', shape: 'box:0,0,0,1,1,1', unit: '' }],
        material: { ...material, group: 'P' },
        checks: { ...checks, touch_mm: 0.001 },
        design: { file: 'Part.STL', unit: 'inch', place: [1, 0, 0], tolerance: 1e-6 },
        tools: [{ number: 5, diameter: 12, limits: { fz: 0.1 } }],
      }),
    ).toEqual([]);
  });

  it.each<[string, Partial<Setup>]>([
    ['stock shape: setup.wrong-shape', { stock: 'box:0,0,0,-1,1,1' }],
    ['stock shape: setup.wrong-shape', { stock: 'ball:3' }],
    ['stock place: setup.wrong-place', { place: [0, 0, 200_000] }],
    ['stock place: setup.wrong-place', { place: [NaN, 0, 0] }],
    [
      'fixture.1 shape: setup.wrong-shape',
      {
        fixtures: [
          { name: '', shape: 'box:0,0,0,1,1,1', unit: '' },
          { name: '', shape: 'tube:Z,0,0,0,9,5,6', unit: '' },
        ],
      },
    ],
    [
      'material group: setup.wrong-material-both',
      { material: { ...material, group: 'P', mc: 0.2 } },
    ],
    ['material mc: setup.wrong-material', { material: { ...material, kc11: 900 } }],
    ['material kc11: setup.wrong-material', { material: { ...material, mc: 0.2 } }],
    ['material kc11: setup.wrong-range', { material: { ...material, kc11: 0.5, mc: 0.2 } }],
    ['material mc: setup.wrong-range', { material: { ...material, kc11: 900, mc: 1 } }],
    ['material energy_j_mm3: setup.wrong-range', { material: { ...material, energy_j_mm3: 0 } }],
    ['checks touch_mm: setup.wrong-range', { checks: { ...checks, touch_mm: 1.5 } }],
    ['checks touch_mm: setup.wrong-range', { checks: { ...checks, touch_mm: NaN } }],
    ['design file: setup.wrong-design', { design: { ...design, tolerance: 0.1 } }],
    ['design file: setup.wrong-design-file', { design: { ...design, file: 'part.step' } }],
    [
      'design tolerance: setup.wrong-range',
      { design: { ...design, file: 'part.stl', tolerance: 0 } },
    ],
    [
      'design place: setup.wrong-place',
      { design: { ...design, file: 'part.stl', place: [0, -1e9, 0] } },
    ],
    ['tool.3: setup.wrong-number', { tools: [{ number: 3, diameter: NaN }] }],
    ['tool.3: setup.wrong-number', { tools: [{ number: 3, limits: { ap: NaN } }] }],
  ])('it is said where: %s', (sentence, change) => expect(wrong(change)).toEqual([sentence]));
});

describe('checks', () => {
  it('are those that the machine can have, and what is left out besides', () => {
    const mill = checks_of_machine({ laser: false, lathe: false }, false, []);
    expect(mill).toContain('RAPID_IN_STOCK');
    expect(mill).not.toContain('INSERT_COLLISION');
    expect(checks_of_machine({ laser: false, lathe: true }, false, [])).toContain(
      'INSERT_COLLISION',
    );
    expect(checks_of_machine({ laser: true, lathe: false }, false, [])).not.toContain('CUT_DEPTH');
    expect(checks_of_machine(null, true, ['SPLENDID', 'GOUGE'])).toEqual(
      expect.arrayContaining(['GOUGE', 'EXCESS', 'SPLENDID']),
    );
    expect(mill.filter((code) => !is_check(code))).toEqual([]);
    expect(is_check('SPLENDID')).toBe(false);
  });
});

it('groups of materials have the numbers of Kienzle', () => {
  expect(MATERIAL_GROUPS.join('')).toBe('PMKNSH');
  expect(MATERIALS.N).toEqual({ kc11: 600, mc: 0.25 });
  expect(is_group('own') || is_group('toString')).toBe(false);
});
