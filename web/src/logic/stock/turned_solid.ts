/**
 * A half section turned about its axis: the solid that a lathe has left, with a sector cut out of it so that its inside is seen.
 * Lines stay straight and arcs round: each of them has its own normals, so that an edge stays an edge. The frame is that of the
 * stock: Z along the axis, the sector opens from +X on towards +Y.
 */
import type { Thread } from './part_store';
import { NO_DEVIATION, type ProfileLoop } from './stock_frame';

type Flat = [z: number, rho: number];

/** A piece of the outline: its points, and of each the normal that points out of the material. */
export interface OutlinePiece {
  points: Flat[];
  normals: Flat[];
  /** The motion that has cut it; 0: none, or not known. */
  owner: number;
  /** Where it begins and where it ends, as deviations_of() has it. */
  deviation: [from: number, to: number];
}

/** A piece as its corners say. */
type Form = Pick<OutlinePiece, 'points' | 'normals'>;

export interface TurnedSolid {
  positions: Float32Array;
  normals: Int8Array;
  owners: Uint16Array;
  deviations: Float32Array;
  indices: Uint32Array;
  lines: Float32Array;
}

const CHORD_RAD = Math.PI / 24;
const TURN_STEPS = 96;
/** A cosine: neighbours that turn by more have an edge between them. */
const EDGE = Math.cos((18 * Math.PI) / 180);

/** Of all loops, those around holes turned so that the material lies on the left as well. */
export function outline_of(loops: readonly ProfileLoop[]): OutlinePiece[][] {
  const rings = loops.filter(({ z }) => z.length >= 2);
  return rings.map((loop) => {
    const depth = rings.filter((other) => other !== loop && holds(other, loop)).length;
    const turned = signed_area(loop) > 0 === (depth % 2 === 0);
    return pieces_of(turned ? loop : reversed(loop));
  });
}

/** The points of a loop one behind the other, without the last one. */
export const ring_of = (pieces: readonly OutlinePiece[]): [number, number][] =>
  pieces.flatMap(({ points }) => points.slice(0, -1));

/** Ways from the axis at which the solid has a row of points: all round, but for the sector. */
type Ways = readonly (readonly [cosine: number, sine: number])[];

export function revolved(
  outline: readonly OutlinePiece[][],
  open_rad: number,
  threads: readonly Thread[] = [],
): TurnedSolid {
  const ways = ways_round(open_rad);
  const surface = new Surface(ways);
  const lines: number[] = [];
  for (const piece of outline.flat()) surface.turn(piece);
  for (const pieces of outline) edge_lines(pieces, ways, open_rad > 0, lines);
  for (const thread of threads) helix(thread, open_rad, lines);
  return { ...surface.made(), lines: new Float32Array(lines) };
}

function ways_round(open_rad: number): Ways {
  const round = 2 * Math.PI - open_rad;
  const steps = Math.max(3, Math.ceil((TURN_STEPS * round) / (2 * Math.PI)));
  return Array.from({ length: steps + 1 }, (_, i) => {
    const angle = open_rad + (round * i) / steps;
    return [Math.cos(angle), Math.sin(angle)] as const;
  });
}

/** Triangles of the pieces that have been turned. */
class Surface {
  private readonly positions: number[] = [];
  private readonly normals: number[] = [];
  private readonly owners: number[] = [];
  private readonly deviations: number[] = [];
  private readonly indices: number[] = [];

  constructor(private readonly ways: Ways) {}

  made(): Omit<TurnedSolid, 'lines'> {
    return {
      positions: new Float32Array(this.positions),
      normals: Int8Array.from(this.normals, Math.round),
      owners: new Uint16Array(this.owners),
      deviations: new Float32Array(this.deviations),
      indices: new Uint32Array(this.indices),
    };
  }

  /** As many rows as the piece has points. */
  turn(piece: OutlinePiece): void {
    const { points, normals, owner } = piece;
    if (points.every(([, rho]) => rho <= 0)) return;
    const first = this.positions.length / 3;
    points.forEach((point, i) => {
      this.row(point, normals[i]);
      for (let k = 0; k < this.ways.length; k++) {
        this.owners.push(owner);
        this.deviations.push(deviation_at(piece, i));
      }
    });
    for (let i = 0; i + 1 < points.length; i++) this.stitch(first + i * this.ways.length);
  }

  private row([z, rho]: Flat, [nz, nr]: Flat): void {
    for (const [c, s] of this.ways) {
      this.positions.push(rho * c, rho * s, z);
      this.normals.push(127 * nr * c, 127 * nr * s, 127 * nz, 0);
    }
  }

  /** The row of points that begins at `a` and the next one. */
  private stitch(a: number): void {
    const row = this.ways.length;
    for (let k = a; k + 1 < a + row; k++)
      this.indices.push(k, k + row + 1, k + 1, k, k + row, k + row + 1);
  }
}

/** Along a piece it runs evenly; where an end has none there is none. */
function deviation_at({ deviation: [from, to], points }: OutlinePiece, i: number): number {
  if (from === NO_DEVIATION || to === NO_DEVIATION) return NO_DEVIATION;
  return from + ((to - from) * i) / (points.length - 1);
}

function pieces_of(loop: ProfileLoop): OutlinePiece[] {
  const { z, rho } = loop;
  const pieces: OutlinePiece[] = [];
  for (let i = 0; i < z.length; i++) {
    const j = (i + 1) % z.length;
    if (z[i] !== z[j] || rho[i] !== rho[j]) pieces.push(piece_of(loop, i, j));
  }
  return pieces;
}

function piece_of(
  { z, rho, bulge, owner, deviation }: ProfileLoop,
  i: number,
  j: number,
): OutlinePiece {
  const ends = [z[i], rho[i], z[j], rho[j]] as const;
  return {
    ...(bulge[i] === 0 ? line(...ends) : arc(...ends, bulge[i])),
    owner: owner?.[i] ?? 0,
    deviation: [deviation?.[i] ?? NO_DEVIATION, deviation?.[j] ?? NO_DEVIATION],
  };
}

function line(z0: number, r0: number, z1: number, r1: number): Form {
  const length = Math.hypot(z1 - z0, r1 - r0);
  const normal: [number, number] = [(r1 - r0) / length, -(z1 - z0) / length];
  return {
    points: [
      [z0, r0],
      [z1, r1],
    ],
    normals: [normal, normal],
  };
}

/** Counterclockwise where the bulge is positive; z goes to the right and the radius up. */
function arc(z0: number, r0: number, z1: number, r1: number, bulge: number): Form {
  const sweep = 4 * Math.atan(bulge);
  const [z, rho] = centre_of(z0, r0, z1, r1, bulge);
  const radius = Math.hypot(z0 - z, r0 - rho);
  const begin = Math.atan2(r0 - rho, z0 - z);
  const chords = Math.max(1, Math.ceil(Math.abs(sweep) / CHORD_RAD));
  const ways = Array.from({ length: chords + 1 }, (_, k): Flat => {
    const angle = begin + (sweep * k) / chords;
    return [Math.cos(angle), Math.sin(angle)];
  });
  const points = ways.map(([c, s]): Flat => [z + radius * c, rho + radius * s]);
  points[0] = [z0, r0];
  points[chords] = [z1, r1];
  const out = Math.sign(bulge);
  return { points, normals: ways.map(([c, s]): Flat => [out * c, out * s]) };
}

/** From the middle of the chord so far to its left. */
function centre_of(z0: number, r0: number, z1: number, r1: number, bulge: number): Flat {
  const off = (1 - bulge * bulge) / (4 * bulge);
  return [(z0 + z1) / 2 - off * (r1 - r0), (r0 + r1) / 2 + off * (z1 - z0)];
}

/** Round the solid where two pieces meet in an edge, and the outline on both faces of the sector. */
function edge_lines(pieces: OutlinePiece[], ways: Ways, is_open: boolean, lines: number[]): void {
  pieces.forEach((piece, i) => {
    const before = pieces[(i + pieces.length - 1) % pieces.length];
    if (has_edge(before, piece)) lines.push(...ring_lines(piece.points[0], ways));
    if (!is_open) return;
    for (const way of [ways[0], ways[ways.length - 1]]) lines.push(...face_lines(piece, way));
  });
}

function has_edge(before: OutlinePiece, piece: OutlinePiece): boolean {
  const [az, ar] = before.normals[before.normals.length - 1];
  const [bz, br] = piece.normals[0];
  return az * bz + ar * br < EDGE && piece.points[0][1] > 1e-6;
}

/** Of the circle that a point goes along. */
function ring_lines([z, rho]: Flat, ways: Ways): number[] {
  const at = ([c, s]: Ways[number]): number[] => [rho * c, rho * s, z];
  return ways.slice(1).flatMap((way, k) => [...at(ways[k]), ...at(way)]);
}

/** The outline itself, in the plane of a way. */
function face_lines({ points }: OutlinePiece, [c, s]: Ways[number]): number[] {
  const at = ([z, rho]: Flat): number[] => [rho * c, rho * s, z];
  return points.slice(1).flatMap((point, k) => [...at(points[k]), ...at(point)]);
}

const HELIX_STEPS = 48;
const MOST_TURNS = 400;

/** The crest of each start; so fine that they would be one face it is left out. */
function helix(thread: Thread, open_rad: number, lines: number[]): void {
  const starts = Math.max(1, thread.starts);
  const turns = Math.abs(thread.to - thread.from) / (thread.pitch * starts);
  if (!(thread.pitch > 0) || turns > MOST_TURNS) return;
  for (let start = 0; start < starts; start++) {
    let before: number[] | null = null;
    for (let k = 0; k <= turns * HELIX_STEPS; k++) {
      const point = crest(thread, k / HELIX_STEPS, start / starts, open_rad);
      if (before && point) lines.push(...before, ...point);
      before = point;
    }
  }
}

/** Behind so many turns of a start that begins at a share of one; null: in the open sector, or beyond the end. */
function crest(thread: Thread, turns: number, share: number, open_rad: number): number[] | null {
  const { from, to, major, minor, pitch, starts } = thread;
  const way = Math.sign(to - from);
  const angle = 2 * Math.PI * (turns + share);
  const z = from + way * pitch * Math.max(1, starts) * turns;
  if (angle % (2 * Math.PI) < open_rad - 1e-9 || way * (to - z) < 0) return null;
  const rho = Math.max(major, minor) / 2;
  return [rho * Math.cos(angle), rho * Math.sin(angle), z];
}

function reversed({ z, rho, bulge, owner, deviation }: ProfileLoop): ProfileLoop {
  const n = z.length;
  // The piece that began at a corner now ends there.
  const of_piece = (i: number): number => (2 * n - 2 - i) % n;
  return {
    z: z.slice().reverse(),
    rho: rho.slice().reverse(),
    bulge: bulge.map((_, i) => -bulge[of_piece(i)]),
    owner: owner?.map((_, i) => owner[of_piece(i)]),
    deviation: deviation?.slice().reverse(),
  };
}

function signed_area({ z, rho, bulge }: ProfileLoop): number {
  let sum = 0;
  for (let i = 0; i < z.length; i++) {
    const j = (i + 1) % z.length;
    sum += (z[i] * rho[j] - z[j] * rho[i]) / 2;
    const chord2 = (z[j] - z[i]) ** 2 + (rho[j] - rho[i]) ** 2;
    const half = 2 * Math.atan(bulge[i]);
    // The segment between chord and arc.
    if (half) sum += (chord2 * (2 * half - Math.sin(2 * half))) / (8 * Math.sin(half) ** 2);
  }
  return sum;
}

/** Whether the first corner of a loop lies within another one. */
function holds(outer: ProfileLoop, inner: ProfileLoop): boolean {
  return is_in_ring([inner.z[0], inner.rho[0]], ring_of(pieces_of(outer)));
}

/** Whether a line from the point on meets the ring an odd number of times. */
export function is_in_ring([z, rho]: Flat, ring: readonly Flat[]): boolean {
  const crossed = ring.filter(([z0, r0], i) => {
    const [z1, r1] = ring[(i + 1) % ring.length];
    return r0 > rho !== r1 > rho && z < z0 + ((rho - r0) / (r1 - r0)) * (z1 - z0);
  });
  return crossed.length % 2 === 1;
}
