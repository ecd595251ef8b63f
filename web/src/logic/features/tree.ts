/** The tree of what a program machines: set-ups, operations, features with their layers, holes, patterns, calls, and what was not recognised. */
import { elements_of } from './elements';
import { extents_of } from './frame';
import type {
  Feature,
  FeaturesDocument,
  Hole,
  Lines,
  Method,
  Operation,
  Pattern,
  Unrecognised,
} from './document';

export type NodeKind =
  | 'setup'
  | 'operation'
  | 'feature'
  | 'layer'
  | 'hole'
  | 'pattern'
  | 'call'
  | 'group'
  | 'unrecognised';

export interface TreeNode {
  /** `F1`; of a layer `F1/2`. */
  id: string;
  kind: NodeKind;
  /** The id of what an edit of it names; a layer's is its feature. */
  target: string;
  /** Of a layer, from 1. */
  layer?: number;
  /** Of features, holes, and of the pattern of holes. */
  type?: string;
  /** What the other method says, where both are asked and differ. */
  otherwise?: string;
  /** Numbers and names, in no language. */
  facts: string;
  /** As the program counts them; null: it has none of its own. */
  lines: Lines | null;
  /** Why it is doubtful. */
  doubts: string[];
  children: TreeNode[];
}

/** A row of the tree as it is shown. */
export interface Row {
  node: TreeNode;
  level: number;
  /** Null: it has no children. */
  is_open: boolean | null;
}

const short = (value: number): string => String(Math.round(value * 1000) / 1000);
const span = ([top, bottom]: [number, number]): string => `Z${short(top)}…${short(bottom)}`;
const times = (size: number[] | undefined): string => size?.map(short).join(' × ') ?? '';
const together = (parts: (string | undefined)[]): string => parts.filter(Boolean).join('  ');

/** From the first to the last of them. */
export function joined_lines(list: Lines[]): Lines | null {
  if (!list.length) return null;
  return [Math.min(...list.map(([first]) => first)), Math.max(...list.map(([, last]) => last))];
}

export function tree_of(document: FeaturesDocument, method: Method): TreeNode[] {
  return method === 'literal' ? literal_tree(document) : new TreeMaker(document, method).tree();
}

class TreeMaker {
  private readonly patterns: Map<string, Pattern>;
  private readonly features: Map<string, Feature>;
  private readonly holes: Map<string, Hole>;
  private readonly children = new Map<string, string[]>();
  /** What has its place already: of several operations that cut a feature the first one has it. */
  private readonly shown = new Set<string>();

  constructor(
    private readonly document: FeaturesDocument,
    private readonly method: Method,
  ) {
    this.patterns = new Map(document.patterns.map((pattern) => [pattern.id, pattern]));
    this.features = new Map(document.features.map((feature) => [feature.id, feature]));
    this.holes = new Map(document.holes.map((hole) => [hole.id, hole]));
    for (const { id, parent } of [...document.features, ...document.holes])
      if (parent) this.children.set(parent.id, [...(this.children.get(parent.id) ?? []), id]);
  }

  tree(): TreeNode[] {
    const { setups, calls, unrecognised } = this.document;
    return [
      ...setups.map(({ id, zero }) => this.setup(id, zero)),
      ...group(
        'calls',
        calls.map((call) => call_node(call)),
      ),
      ...group('unrecognised', unrecognised.map(unrecognised_node)),
    ];
  }

  private setup(id: string, zero: string): TreeNode {
    const operations = this.document.operations.filter(({ setup }) => setup === id);
    return {
      ...bare(id, 'setup'),
      facts: zero,
      children: operations.map((operation) => this.operation(operation)),
    };
  }

  private operation({ id, tool, lines, spindle_rpm, features }: Operation): TreeNode {
    const own = features.filter((part) => !this.has_parent(part));
    const children = own.flatMap((part) => this.part(part));
    const facts = spindle_rpm ? `T${tool}  S${short(spindle_rpm)}` : `T${tool}`;
    return { ...bare(id, 'operation'), facts, lines, children };
  }

  private has_parent(id: string): boolean {
    const parent = (this.features.get(id) ?? this.holes.get(id))?.parent;
    return Boolean(parent && (this.features.has(parent.id) || this.holes.has(parent.id)));
  }

  /** What stands at its place; the first hole of a pattern brings all of it. */
  private part(id: string): TreeNode[] {
    if (this.shown.has(id)) return [];
    this.shown.add(id);
    const feature = this.features.get(id);
    if (feature) return [this.feature(feature)];
    const hole = this.holes.get(id);
    if (!hole) return [];
    const pattern = hole.pattern === null ? undefined : this.patterns.get(hole.pattern);
    return [pattern ? this.pattern(pattern) : this.hole(hole)];
  }

  private parts_in(id: string): TreeNode[] {
    return (this.children.get(id) ?? []).flatMap((part) => this.part(part));
  }

  private feature(feature: Feature): TreeNode {
    const { id, type, z, reasons, layers, cuts } = feature;
    return {
      ...bare(id, 'feature'),
      type,
      ...this.otherwise(feature),
      facts: together([round_of(feature) ?? times(size_of(feature)), span(z)]),
      lines: joined_lines(cuts.map(({ lines }) => lines)),
      doubts: reasons,
      children: [
        ...layers.map((layer) => ({
          ...bare(`${id}/${layer.n}`, 'layer'),
          target: id,
          layer: layer.n,
          facts: `Z${short(layer.z)}`,
          lines: layer.lines,
        })),
        ...this.parts_in(id),
      ],
    };
  }

  private otherwise({ literal, type, agree }: Feature): { otherwise?: string } {
    const differs = this.method === 'both' && !agree && literal && literal.type !== type;
    return differs ? { otherwise: literal.type } : {};
  }

  private hole({ id, at, diameter, z, reasons, steps, form }: Hole): TreeNode {
    return {
      ...bare(id, 'hole'),
      type: form,
      facts: `Ø${short(diameter)}  X${short(at[0])} Y${short(at[1])}  ${span(z)}`,
      lines: joined_lines(steps.map(({ lines }) => lines)),
      doubts: reasons,
      children: this.parts_in(id),
    };
  }

  private pattern({ id, kind, holes, count }: Pattern): TreeNode {
    holes.forEach((hole) => this.shown.add(hole));
    const children = holes.flatMap((hole) => this.holes.get(hole) ?? []).map((h) => this.hole(h));
    const lines = joined_lines(children.flatMap((child) => (child.lines ? [child.lines] : [])));
    return { ...bare(id, 'pattern'), type: kind, facts: String(count), lines, children };
  }
}

/** What is milled around something is as large as that. */
const STANDING = new Set(['outside-profile', 'boss']);

function size_of({ type, size, nominal }: Feature): number[] | undefined {
  const box = STANDING.has(type) && extents_of(elements_of(nominal ?? [], true));
  return box ? box.high.map((value, i) => value - box.low[i]) : size;
}

function round_of({ round }: Feature): string | undefined {
  return round ? `Ø${short(round.diameter)}` : undefined;
}

function call_node({ id, line, code, program, arguments: words }: FeaturesDocument['calls'][0]) {
  const texts = words.map(({ letter, variable, text }) =>
    letter ? `${letter}${text}` : `#${variable}=${text}`,
  );
  const facts = [code, program, ...texts].filter(Boolean).join(' ');
  return { ...bare(id, 'call'), facts, lines: [line, line] as Lines };
}

function unrecognised_node({ lines, moves, cut_mm, why }: Unrecognised, i: number): TreeNode {
  return {
    ...bare(`U${i + 1}`, 'unrecognised'),
    facts: `${moves} · ${short(cut_mm)} mm`,
    lines,
    doubts: [why],
  };
}

function group(id: string, children: TreeNode[]): TreeNode[] {
  return children.length ? [{ ...bare(id, 'group'), children }] : [];
}

function bare(id: string, kind: NodeKind): TreeNode {
  return { id, kind, target: id, facts: '', lines: null, doubts: [], children: [] };
}

/** By the pattern of the rows alone: nothing of it has an id that an edit could name. */
function literal_tree({ literal }: FeaturesDocument): TreeNode[] {
  const features = literal.features.map(({ layers, type }, i): TreeNode => {
    const own = layers.map((n) => literal.layers[n - 1]).filter(Boolean);
    return {
      ...bare(`L${i + 1}`, 'feature'),
      type,
      facts: `T${own[0]?.tool ?? 0}`,
      lines: joined_lines(own.map(({ lines }) => lines)),
      children: own.map((layer, k) => ({
        ...bare(`L${i + 1}/${k + 1}`, 'layer'),
        target: '',
        facts: `Z${short(layer.z)}`,
        lines: layer.lines,
      })),
    };
  });
  const holes = literal.holes.map(({ at, z, tool, line }, i): TreeNode => {
    const facts = `T${tool}  X${short(at[0])} Y${short(at[1])}  Z${short(z)}`;
    return { ...bare(`LH${i + 1}`, 'hole'), type: 'plain', facts, lines: [line, line] };
  });
  return [...features, ...holes];
}

/** The rows that are seen: those below a closed node are not. */
export function rows_of(nodes: TreeNode[], closed: ReadonlySet<string>, level = 1): Row[] {
  return nodes.flatMap((node) => {
    const is_open = node.children.length ? !closed.has(node.id) : null;
    const below = is_open ? rows_of(node.children, closed, level + 1) : [];
    return [{ node, level, is_open }, ...below];
  });
}

export function node_by_id(nodes: TreeNode[], id: string): TreeNode | null {
  for (const node of nodes) {
    const found = node.id === id ? node : node_by_id(node.children, id);
    if (found) return found;
  }
  return null;
}

/** From the root to the node. */
export function path_to(nodes: TreeNode[], id: string): TreeNode[] {
  for (const node of nodes) {
    if (node.id === id) return [node];
    const below = path_to(node.children, id);
    if (below.length) return [node, ...below];
  }
  return [];
}

const length_of = (lines: Lines | null): number => (lines ? lines[1] - lines[0] : Infinity);

/** The smallest node that this line is of; null: none. */
export function node_at_line(nodes: TreeNode[], line: number): TreeNode | null {
  let best: TreeNode | null = null;
  for (const node of nodes) {
    const is_in = node.lines !== null && line >= node.lines[0] && line <= node.lines[1];
    const found = node_at_line(node.children, line) ?? (is_in ? node : null);
    if (found && (!best || length_of(found.lines) < length_of(best.lines))) best = found;
  }
  return best;
}
