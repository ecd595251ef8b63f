/** What `kerf features` tells of a program: the command `features` answers with the same. mm, degrees, coordinates of the part. */

/** [x, y, bulge] or, of a lathe, [z, x, bulge], x a diameter; the bulge is that of the element that begins there. */
export type ToldVertex = [number, number, number];
/** The first line and the last one, of the program as it was run. */
export type Lines = [number, number];

export interface FeatureLayer {
  n: number;
  z: number;
  top: number;
  lines: Lines;
  visit: Lines;
  blocks: { file: string; program: string; first: number; last: number }[];
  contour: ToldVertex[];
  islands: ToldVertex[][];
  nominal: ToldVertex[];
  nominal_islands: ToldVertex[][];
  loops: { lines: Lines; contour: ToldVertex[] }[];
}

interface Placed {
  id: string;
  key: string;
  type: string;
  setup: string;
  tool: number;
  parent: { id: string; relation: string } | null;
  z: [number, number];
  depth: number;
  through: boolean;
  volume_mm3: number;
  /** What an edit may do: `contour`, `shared`, `unroll`, `argument` or `no`. */
  editable: string;
  origin: { kind: string; lines: Lines | null; call: string | null };
  confidence: number;
  reasons: string[];
}

export interface Feature extends Placed {
  area?: number;
  size?: [number, number];
  contour: ToldVertex[];
  islands?: ToldVertex[][];
  nominal?: ToldVertex[];
  nominal_islands?: ToldVertex[][];
  strategy?: string | null;
  direction?: string | null;
  cuts: { operation: string; tool: number; role: string; lines: Lines }[];
  layers: FeatureLayer[];
  /** Of a lathe. */
  elements?: { kind: string; lines: Lines }[];
  round?: { diameter: number } | null;
  literal: { type: string } | null;
  swept: { type: string } | null;
  agree: boolean;
}

export interface Hole extends Placed {
  form: string;
  at: [number, number];
  diameter: number;
  pattern: string | null;
  steps: { how: string; tool: number; lines: Lines }[];
}

export interface Pattern {
  id: string;
  kind: string;
  holes: string[];
  count: number;
}

export interface Operation {
  id: string;
  tool: number;
  setup: string;
  lines: Lines;
  spindle_rpm?: number | null;
  features: string[];
}

export interface CallArgument {
  letter: string | null;
  variable: number;
  value: number;
  text: string;
  literal: boolean;
}

export interface ProgramCall {
  id: string;
  line: number;
  code: string;
  program: string;
  arguments: CallArgument[];
  features: string[];
}

export interface Unrecognised {
  lines: Lines;
  moves: number;
  cut_mm: number;
  why: string;
}

export interface LiteralFeature {
  layers: number[];
  type: string;
  kind: number | null;
}

export interface FeaturesDocument {
  program: string;
  file: string;
  status: string;
  alarm: unknown;
  stock: { extents: Record<string, [number, number] | undefined> };
  setups: { id: string; zero: string; origin: Record<string, number> }[];
  operations: Operation[];
  features: Feature[];
  holes: Hole[];
  patterns: Pattern[];
  calls: ProgramCall[];
  literal: {
    layers: { lines: Lines; z: number; tool: number; loops: number }[];
    features: LiteralFeature[];
    holes: { at: [number, number]; z: number; tool: number; line: number }[];
  };
  disagreements: { feature: string; why: string }[];
  unrecognised: Unrecognised[];
}

export type Method = 'literal' | 'swept' | 'both';
export const METHODS: readonly Method[] = ['both', 'swept', 'literal'];

/** A feature of a lathe is a half section: it has elements, and no layers. */
export const is_turned = (feature: Feature): boolean => feature.elements !== undefined;

export const feature_of = (document: FeaturesDocument, id: string): Feature | undefined =>
  document.features.find((feature) => feature.id === id);
export const hole_of = (document: FeaturesDocument, id: string): Hole | undefined =>
  document.holes.find((hole) => hole.id === id);
