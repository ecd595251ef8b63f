/**
 * The set-up of a program as its forms have it, and the TOML that the server keeps (docs/stock.md, Set-up). What the forms do not
 * know stays in it, word by word but for comments and layout.
 */
import { parse, stringify, TomlError } from 'smol-toml';
import type { ToolTable } from './tool_shape';

export interface Fixture {
  name: string;
  shape: string;
}

type Table = Record<string, unknown>;

export interface Setup {
  /** Empty: the extents of the cuts. */
  stock: string;
  /** Empty: the system in force at the first cut. */
  zero: string;
  /** X,Y,Z[,A,B,C]; empty: as its numbers say. */
  place: string;
  fixtures: Fixture[];
  /** P M K N S H, `kc11,mc`, or empty. */
  material: string;
  /** Codes that are not checked. */
  no_check: string[];
  tools: ToolTable[];
  holders: { name: string; segments: unknown }[];
  /** All that stands there, of which the rest is kept. */
  whole: Table;
}

export const EMPTY_SETUP: Setup = {
  stock: '',
  zero: '',
  place: '',
  fixtures: [],
  material: '',
  no_check: [],
  tools: [],
  holders: [],
  whole: {},
};

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
  const { off } = table_of(whole.checks);
  return {
    stock: text_of(stock.shape),
    zero: text_of(stock.zero),
    place: text_of(stock.place),
    fixtures: tables_of(whole.fixture).map(fixture_of),
    material: text_of(table_of(whole.material).name),
    no_check: Array.isArray(off) ? off.map(text_of).filter(Boolean) : [],
    tools: tables_of(whole.tool).filter((one): one is ToolTable => typeof one.number === 'number'),
    holders: tables_of(whole.holder).map(holder_of),
    whole,
  };
}

function fixture_of({ name, shape }: Table): Fixture {
  return { name: text_of(name), shape: text_of(shape) };
}
function holder_of({ name, segments }: Table): Setup['holders'][number] {
  return { name: text_of(name), segments };
}

export const is_bad = (setup: Setup | BadSetup): setup is BadSetup => 'message' in setup;

export function written_setup(setup: Setup): string {
  const whole: Table = { ...setup.whole };
  put_table(whole, 'stock', { shape: setup.stock, zero: setup.zero, place: setup.place });
  put_table(whole, 'material', { name: setup.material });
  put_table(whole, 'checks', { off: setup.no_check.length ? setup.no_check : '' });
  put_list(whole, 'fixture', merged(tables_of(setup.whole.fixture), setup.fixtures));
  put_list(whole, 'tool', setup.tools);
  return Object.keys(whole).length ? stringify(whole) : '';
}

/** A tool with a key changed; undefined: without it. */
export function with_key(tool: ToolTable, key: string, value: unknown): ToolTable {
  const copy: ToolTable = { ...tool };
  if (value === undefined || value === '') delete copy[key];
  else copy[key] = value;
  return copy;
}

function put_table(whole: Table, name: string, values: Table): void {
  const table = { ...table_of(whole[name]) };
  for (const [key, value] of Object.entries(values)) {
    if (value === '') delete table[key];
    else table[key] = value;
  }
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
    const table: Table = { ...rest, shape: fixture.shape };
    if (fixture.name) table.name = fixture.name;
    else delete table.name;
    return table;
  });
}

const table_of = (value: unknown): Table =>
  value && typeof value === 'object' && !Array.isArray(value) ? (value as Table) : {};
const tables_of = (value: unknown): Table[] =>
  Array.isArray(value) ? value.map(table_of).filter((one) => Object.keys(one).length > 0) : [];
function text_of(value: unknown): string {
  if (typeof value === 'string') return value;
  if (typeof value === 'number') return String(value);
  return Array.isArray(value) ? value.map(text_of).join(',') : '';
}
