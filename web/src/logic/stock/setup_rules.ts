/** What of a set-up cannot be, before the server is asked: the field, and the sentence that says why (docs/stock.md, Set-up). */
import type { TextKey } from '../i18n';
import type { Design, Material, Place, Setup } from './setup';
import type { ToolTable } from './tool_shape';
import { read_shape, wrong_field } from './setup_words';

export interface Wrong {
  /** The part of the set-up, and within it the field: `material kc11`, `fixture.2 shape`. */
  field: string;
  text: TextKey;
  values?: Record<string, string | number>;
}

export const FARTHEST_MM = 100_000;
const DESIGN_ENDINGS = /\.stl$/i;

/** By the name of its field, what a number may be. */
const RANGES: Record<string, readonly [low: number, high: number]> = {
  kc11: [1, 1e6],
  mc: [0, 0.99],
  energy_j_mm3: [1e-6, 1e6],
  touch_mm: [0.001, 1],
  tolerance: [1e-6, 1000],
};

export function wrong_in(setup: Setup): Wrong[] {
  return [
    ...of_shape('stock', setup.stock),
    ...of_place('stock', setup.place),
    ...setup.fixtures.flatMap(({ shape }, i) => of_shape(`fixture.${i}`, shape)),
    ...of_material(setup.material),
    ...of_range('checks', 'touch_mm', setup.checks.touch_mm),
    ...of_design(setup.design),
    ...setup.tools.flatMap(of_tool),
  ];
}

/** Its dimensions are the server's to judge; but what is no number none can. */
function of_tool(tool: ToolTable): Wrong[] {
  const limits = Object.values((tool.limits ?? {}) as object);
  const is_wrong = [...Object.values(tool), ...limits].some(Number.isNaN);
  return is_wrong ? [{ field: `tool.${tool.number}`, text: 'setup.wrong-number' }] : [];
}

function of_shape(part: string, word: string): Wrong[] {
  const shape = word ? read_shape(word) : null;
  const is_wrong = word !== '' && (!shape || wrong_field(shape) !== null);
  return is_wrong ? [{ field: `${part} shape`, text: 'setup.wrong-shape' }] : [];
}

function of_place(part: string, place: Place): Wrong[] {
  const is_wrong = !place.every((value) => Math.abs(value) <= FARTHEST_MM);
  const values = { most: FARTHEST_MM };
  return is_wrong ? [{ field: `${part} place`, text: 'setup.wrong-place', values }] : [];
}

function of_range(part: string, key: string, value: number | null): Wrong[] {
  const [low, high] = RANGES[key];
  if (value === null || (value >= low && value <= high)) return [];
  return [{ field: `${part} ${key}`, text: 'setup.wrong-range', values: { low, high } }];
}

function of_material(material: Material): Wrong[] {
  const { group, kc11, mc } = material;
  const has_numbers = kc11 !== null || mc !== null;
  if (has_numbers && group) return [{ field: 'material group', text: 'setup.wrong-material-both' }];
  if (has_numbers && (kc11 === null || mc === null))
    return [{ field: `material ${kc11 === null ? 'kc11' : 'mc'}`, text: 'setup.wrong-material' }];
  return (['kc11', 'mc', 'energy_j_mm3'] as const).flatMap((key) =>
    of_range('material', key, material[key]),
  );
}

function of_design(design: Design): Wrong[] {
  const { file, unit, place, tolerance } = design;
  const is_meant = unit !== '' || place.length > 0 || tolerance !== null;
  if (!file && is_meant) return [{ field: 'design file', text: 'setup.wrong-design' }];
  const wrong_file: Wrong[] =
    file && !DESIGN_ENDINGS.test(file)
      ? [{ field: 'design file', text: 'setup.wrong-design-file' }]
      : [];
  return [
    ...wrong_file,
    ...of_place('design', place),
    ...of_range('design', 'tolerance', tolerance),
  ];
}
