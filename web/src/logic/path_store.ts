/**
 * The path of one run as it arrives: chunks in their order, each with its blocks. A block is the unit of culling and of
 * detail: at most BLOCK segments with the box around them. Nothing is kept per segment but the arrays of the chunk.
 *
 *   chunk   0 ─────────────────────────┬ 1 ──────────────
 *   vertex  0 1 2 …              65535 │ 0 1 …      vertex 0 of a chunk repeats the last one of the chunk before;
 *   segment   1 2 …              65535 │   1 …      segment i ends at vertex i and has its line, feed, kind and tool
 */
import { type Box, empty_box, grow, join } from './box';
import { type Chunk, Kind } from './chunk';

export const BLOCK = 8192;

export interface Block {
  chunk: Chunk;
  /** Segments first + 1 … last, vertices first … last. */
  first: number;
  last: number;
  box: Box;
}

/** A vertex of the path, and how far behind it the path has gone towards the next: 0 to 1. */
export interface PathPlace {
  chunk: number;
  vertex: number;
  fraction: number;
}

export interface Range {
  chunk: number;
  first: number;
  last: number;
}

export interface Facts {
  segments: number;
  end_s: number;
  bounds: Box;
  cuts: Box;
  feed: [number, number];
  speed: [number, number];
  /** That cut other things than threads, which have a colour of their own. */
  tools: number[];
  threads: boolean;
}

export class PathStore {
  readonly chunks: Chunk[] = [];
  readonly blocks: Block[] = [];
  run = -1;
  facts: Facts = no_facts();

  clear(run: number): void {
    this.chunks.length = 0;
    this.blocks.length = 0;
    this.run = run;
    this.facts = no_facts();
  }

  /** A chunk of a newer run begins a new path; one of an older run is left out. False: left out. */
  add(chunk: Chunk): boolean {
    if (chunk.run < this.run) return false;
    if (chunk.run > this.run) this.clear(chunk.run);
    this.chunks.push(chunk);
    for (let first = 0; first < chunk.vertices - 1; first += BLOCK) {
      const last = Math.min(chunk.vertices - 1, first + BLOCK);
      this.blocks.push({ chunk, first, last, box: box_of(chunk, first, last) });
    }
    this.take_facts(chunk);
    return true;
  }

  /** Where the path is at `time_s`; before the first vertex and behind the last one that vertex. Null: no path. */
  place_at(time_s: number): PathPlace | null {
    const index = this.chunk_at(time_s);
    if (index < 0) return null;
    const chunk = this.chunks[index];
    const within = time_s - chunk.time_base_s;
    const vertex = Math.max(0, last_not_above(chunk.time_s, within));
    if (vertex >= chunk.vertices - 1) return { chunk: index, vertex, fraction: 0 };
    const span = chunk.time_s[vertex + 1] - chunk.time_s[vertex];
    const fraction = span > 0 ? (within - chunk.time_s[vertex]) / span : 0;
    return { chunk: index, vertex, fraction: Math.min(1, Math.max(0, fraction)) };
  }

  /** Where the path is within a motion of the run, for a tool that stands at `tip`; null: the motion draws nothing yet. */
  place_of_motion(motion: number, tip: [number, number, number]): PathPlace | null {
    const index = this.chunk_of_motion(motion);
    if (index < 0) return null;
    const chunk = this.chunks[index];
    const first = Math.max(1, last_not_above(chunk.motion, motion - 1) + 1);
    const last = Math.min(chunk.vertices - 1, last_not_above(chunk.motion, motion));
    return { chunk: index, ...nearest_place(chunk, first, last, tip) };
  }

  /** The last vertex that a motion and those before it have made; null: there is no path. */
  end_of_motion(motion: number): PathPlace | null {
    const index = this.chunk_of_motion(motion);
    if (index < 0) return null;
    const vertex = Math.max(0, last_not_above(this.chunks[index].motion, motion));
    return { chunk: index, vertex, fraction: 0 };
  }

  point_at(place: PathPlace): [number, number, number] {
    const { xyz, vertices } = this.chunks[place.chunk];
    const at = (i: number): number => value_at(xyz, 3, i, vertices, place);
    return [at(0), at(1), at(2)];
  }

  rotary_at(place: PathPlace): [number, number] | null {
    const { rotary, vertices } = this.chunks[place.chunk];
    if (!rotary) return null;
    const at = (i: number): number => value_at(rotary, 2, i, vertices, place);
    return [at(0), at(1)];
  }

  seconds_at(place: PathPlace): number {
    const { time_s, vertices } = this.chunks[place.chunk];
    const end = Math.min(place.vertex + 1, vertices - 1);
    const span = time_s[end] - time_s[place.vertex];
    return this.time_of(place.chunk, place.vertex) + place.fraction * span;
  }

  /** All runs of segments that a line of a file made, or those from it to another. */
  ranges_of(file: number, line: number, last = line): Range[] {
    const ranges: Range[] = [];
    const lines: [number, number] = [line, last];
    this.chunks.forEach((chunk, index) => collect_ranges(ranges, chunk, index, file, lines));
    return ranges;
  }

  time_of(chunk: number, vertex: number): number {
    return this.chunks[chunk].time_base_s + this.chunks[chunk].time_s[vertex];
  }

  private chunk_at(time_s: number): number {
    let low = 0;
    let high = this.chunks.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.chunks[middle].time_base_s + this.chunks[middle].time_s[0] <= time_s) low = middle;
      else high = middle - 1;
    }
    return high < 0 ? -1 : low;
  }

  private chunk_of_motion(motion: number): number {
    for (let i = this.chunks.length - 1; i >= 0; i--) {
      const { motion: numbers, vertices } = this.chunks[i];
      if (vertices > 1 && numbers[1] <= motion) return i;
    }
    return this.chunks.length ? 0 : -1;
  }

  private take_facts(chunk: Chunk): void {
    const facts = this.facts;
    const tools = new Set(facts.tools);
    for (let i = 1; i < chunk.vertices; i++) {
      const { [i]: kind } = chunk.kind;
      if (kind !== Kind.cut && kind !== Kind.thread) continue;
      take_cut(facts, chunk, i);
      if (kind === Kind.thread) facts.threads = true;
      else tools.add(chunk.tool[i]);
    }
    for (const block of this.blocks) if (block.chunk === chunk) join(facts.bounds, block.box);
    facts.tools = [...tools].sort((a, b) => a - b);
    facts.segments += Math.max(0, chunk.vertices - 1);
    facts.end_s = chunk.time_base_s + (chunk.vertices ? chunk.time_s[chunk.vertices - 1] : 0);
    this.facts = { ...facts };
  }
}

/** Number i of the `width` that each vertex has, between a vertex and the next one. */
function value_at(
  values: Float32Array,
  width: number,
  i: number,
  vertices: number,
  { vertex, fraction }: PathPlace,
): number {
  const from = values[width * vertex + i];
  return from + fraction * (values[width * Math.min(vertex + 1, vertices - 1) + i] - from);
}

function no_facts(): Facts {
  return {
    segments: 0,
    end_s: 0,
    bounds: empty_box(),
    cuts: empty_box(),
    feed: [Infinity, -Infinity],
    speed: [Infinity, -Infinity],
    tools: [],
    threads: false,
  };
}

/** The segment that ends at a vertex. */
function take_cut(facts: Facts, { xyz, feed_mm_min, speed_mm_min }: Chunk, vertex: number): void {
  const a = 3 * vertex;
  grow(facts.cuts, xyz[a - 3], xyz[a - 2], xyz[a - 1]);
  grow(facts.cuts, xyz[a], xyz[a + 1], xyz[a + 2]);
  widen(facts.feed, feed_mm_min[vertex]);
  widen(facts.speed, speed_mm_min[vertex]);
}

function widen(range: [number, number], value: number): void {
  if (value < range[0]) range[0] = value;
  if (value > range[1]) range[1] = value;
}

/** Of the segments that end at vertices `first` to `last`; where there are none, the vertex before them. */
function nearest_place(
  { xyz, vertices }: Chunk,
  first: number,
  last: number,
  tip: number[],
): Omit<PathPlace, 'chunk'> {
  let best = { vertex: Math.min(first - 1, vertices - 1), fraction: 0 };
  let nearest = Infinity;
  for (let vertex = first; vertex <= last; vertex++) {
    const { distance, fraction } = foot(xyz, 3 * (vertex - 1), tip);
    if (distance >= nearest) continue;
    nearest = distance;
    best = { vertex: vertex - 1, fraction };
  }
  return best;
}

/** How far `tip` is from the segment that begins at `a`, and where its foot is: 0 to 1. */
function foot(xyz: Float32Array, a: number, tip: number[]): { distance: number; fraction: number } {
  const way = [0, 1, 2].map((i) => xyz[a + 3 + i] - xyz[a + i]);
  const off = [0, 1, 2].map((i) => tip[i] - xyz[a + i]);
  const dot = (p: number[], q: number[]) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  const length2 = dot(way, way);
  const fraction = length2 > 0 ? Math.min(1, Math.max(0, dot(off, way) / length2)) : 0;
  return { distance: Math.hypot(...off.map((value, i) => value - fraction * way[i])), fraction };
}

function box_of(chunk: Chunk, first: number, last: number): Box {
  const box = empty_box();
  for (let a = 3 * first; a <= 3 * last; a += 3)
    grow(box, chunk.xyz[a], chunk.xyz[a + 1], chunk.xyz[a + 2]);
  return box;
}

/** Index of the last value <= `limit` of values that do not fall; -1: all are above. */
export function last_not_above(values: Float32Array | Uint32Array, limit: number): number {
  let low = -1;
  let high = values.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (values[middle] <= limit) low = middle;
    else high = middle - 1;
  }
  return low;
}

function collect_ranges(
  ranges: Range[],
  chunk: Chunk,
  index: number,
  file: number,
  [from, to]: [number, number],
): void {
  let first = -1;
  const is_between = (line: number): boolean => line >= from && line <= to;
  for (let i = 1; i <= chunk.vertices; i++) {
    const is_ours = i < chunk.vertices && is_between(chunk.line[i]) && chunk.file[i] === file;
    if (is_ours && first < 0) first = i - 1;
    if (!is_ours && first >= 0) {
      ranges.push({ chunk: index, first, last: i - 1 });
      first = -1;
    }
  }
}
