/**
 * The set-up of a program as its forms have it, and the TOML that the server keeps (docs/stock.md, Set-up). What the forms do not
 * know, and what they have not changed, stays in it as it was but for comments and layout.
 */
import { parse, stringify, TomlError } from 'smol-toml';
import type { ToolTable } from './tool_shape';

/** Of an STL file; empty: millimetres. */
export type Unit = '' | 'mm' | 'inch';
/** X, Y, Z, and where it is turned A, B, C besides; empty: as its numbers say. */
export type Place = number[];
/** Null: nobody has said it. NaN: what was typed is no number. */
type Said = number | null;

export interface Fixture {
  name: string;
  shape: string;
  unit: Unit;
}

/** Of what is cut: a group (P M K N S H), or numbers of its own. */
export interface Material {
  group: string;
  /** N/mm². */
  kc11: Said;
  mc: Said;
  /** That a beam needs. */
  energy_j_mm3: Said;
}

export interface Checks {
  touch_mm: Said;
  /** Codes that are not checked. */
  no_check: string[];
  fail_on: '' | 'warning' | 'error' | 'never';
  lengths: '' | 'programmed' | 'real';
}

/** What the part shall be. */
export interface Design {
  file: string;
  unit: Unit;
  place: Place;
  /** mm. */
  tolerance: Said;
}

type Table = Record<string, unknown>;

export interface Setup {
  /** Empty: the extents of the cuts. */
  stock: string;
  stock_unit: Unit;
  /** Empty: the system in force at the first cut. */
  zero: string;
  place: Place;
  fixtures: Fixture[];
  material: Material;
  checks: Checks;
  design: Design;
  tools: ToolTable[];
  holders: { name: string; segments: unknown }[];
  /** All that stands there, of which the rest is kept. */
  whole: Table;
}

export interface BadSetup {
  line: number;
  message: string;
}

export function read_setup(toml: string): Setup | BadSetup {
  let whole: Table;
  try {
    whole = parse(toml) as Table;
  } catch (reason) {
    if (!(reason instanceof TomlError)) throw reason;
    return { line: reason.line, message: reason.message.split('\n')[0] };
  }
  return setup_of(whole);
}

function setup_of(whole: Table): Setup {
  const stock = table_of(whole.stock);
  return {
    stock: text_of(stock.shape),
    stock_unit: unit_of(stock.unit),
    zero: text_of(stock.zero),
    place: place_of(stock.place),
    fixtures: tables_of(whole.fixture).map(fixture_of),
    material: material_of(table_of(whole.material)),
    checks: checks_of(table_of(whole.checks)),
    design: design_of(table_of(whole.design)),
    tools: tables_of(whole.tool).filter((one): one is ToolTable => typeof one.number === 'number'),
    holders: tables_of(whole.holder).map(holder_of),
    whole,
  };
}

function fixture_of({ name, shape, unit }: Table): Fixture {
  return { name: text_of(name), shape: text_of(shape), unit: unit_of(unit) };
}
function material_of({ group, kc11, mc, energy_j_mm3 }: Table): Material {
  return {
    group: text_of(group),
    kc11: number_of(kc11),
    mc: number_of(mc),
    energy_j_mm3: number_of(energy_j_mm3),
  };
}
function checks_of({ touch_mm, no_check, fail_on, lengths }: Table): Checks {
  return {
    touch_mm: number_of(touch_mm),
    no_check: Array.isArray(no_check) ? no_check.map(text_of).filter(Boolean) : [],
    fail_on: one_of(fail_on, ['warning', 'error', 'never']),
    lengths: one_of(lengths, ['programmed', 'real']),
  };
}
function design_of({ file, unit, place, tolerance }: Table): Design {
  return {
    file: text_of(file),
    unit: unit_of(unit),
    place: place_of(place),
    tolerance: number_of(tolerance),
  };
}
function holder_of({ name, segments }: Table): Setup['holders'][number] {
  return { name: text_of(name), segments };
}

export const is_bad = (setup: Setup | BadSetup): setup is BadSetup => 'message' in setup;

/** What stands under which key of a table that is there once. */
const TABLES: Record<string, (setup: Setup) => Table> = {
  stock: ({ stock, stock_unit, zero, place }) => ({ shape: stock, unit: stock_unit, zero, place }),
  material: ({ material }) => ({ ...material }),
  checks: ({ checks }) => ({ ...checks }),
  design: ({ design }) => ({ ...design }),
};

export function written_setup(setup: Setup): string {
  const whole: Table = { ...setup.whole };
  const before = setup_of(setup.whole);
  for (const [name, values] of Object.entries(TABLES))
    put_table(whole, name, values(setup), values(before));
  put_list(whole, 'fixture', merged(tables_of(setup.whole.fixture), setup.fixtures));
  put_list(whole, 'tool', setup.tools);
  return Object.keys(whole).length ? stringify(whole) : '';
}

/** A table with a key changed; undefined or empty: without it. */
export function with_key<T extends Table>(table: T, key: string, value: unknown): T {
  const copy: Table = { ...table };
  if (is_said(value)) copy[key] = value;
  else delete copy[key];
  return copy as T;
}

const is_said = (value: unknown): boolean =>
  value !== undefined && value !== null && value !== '' && !(Array.isArray(value) && !value.length);

/** Only what is another value than before: what the forms could not read stays as it is. */
function put_table(whole: Table, name: string, values: Table, before: Table): void {
  const changed = Object.keys(values).filter(
    (key) => JSON.stringify(values[key]) !== JSON.stringify(before[key]),
  );
  if (!changed.length) return;
  const table = changed.reduce((t, key) => with_key(t, key, values[key]), table_of(whole[name]));
  if (Object.keys(table).length) whole[name] = table;
  else delete whole[name];
}
function put_list(whole: Table, name: string, list: readonly Table[]): void {
  if (list.length) whole[name] = list;
  else delete whole[name];
}
/** Fixtures with the keys that the forms do not know, as long as they stand in the same order. */
function merged(known: Table[], fixtures: readonly Fixture[]): Table[] {
  return fixtures.map((fixture, i) => {
    const rest = known.length === fixtures.length ? known[i] : {};
    const named = with_key({ ...rest, shape: fixture.shape }, 'name', fixture.name);
    return with_key(named, 'unit', fixture.unit);
  });
}

const table_of = (value: unknown): Table =>
  value && typeof value === 'object' && !Array.isArray(value) ? (value as Table) : {};
const tables_of = (value: unknown): Table[] =>
  Array.isArray(value) ? value.map(table_of).filter((one) => Object.keys(one).length > 0) : [];
function text_of(value: unknown): string {
  if (typeof value === 'string') return value;
  return typeof value === 'number' ? String(value) : '';
}
const number_of = (value: unknown): Said => (typeof value === 'number' ? value : null);
const one_of = <T extends string>(value: unknown, choices: readonly T[]): T | '' =>
  choices.find((choice) => choice === value) ?? '';
const unit_of = (value: unknown): Unit => one_of(value, ['mm', 'inch']);
/** A list, or a text as the command line has it. */
function place_of(value: unknown): Place {
  const numbers = typeof value === 'string' ? value.split(',').map(Number) : value;
  return Array.isArray(numbers) && numbers.every((one) => typeof one === 'number') ? numbers : [];
}

/** A place with one of its six numbers changed: as short as it can be said. */
export function with_coordinate(place: Place, i: number, value: number | null): Place {
  const all = [0, 1, 2, 3, 4, 5].map((k) => (k === i ? (value ?? 0) : (place[k] ?? 0)));
  if (all.every((one) => one === 0)) return [];
  return all.slice(3).every((one) => one === 0) ? all.slice(0, 3) : all;
}

export const EMPTY_SETUP: Setup = setup_of({});
