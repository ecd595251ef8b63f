/**
 * A half section turned about its axis: the solid that a lathe has left, with a sector cut out of it so that its inside is seen.
 * Lines stay straight and arcs round: each of them has its own normals, so that an edge stays an edge. The frame is that of the
 * stock: Z along the axis, the sector opens from +X on towards +Y.
 */
import type { Thread } from './part_store';
import type { ProfileLoop } from './stock_frame';

/** A piece of the outline: its points, and of each the normal that points out of the material. */
export interface OutlinePiece {
  points: [z: number, rho: number][];
  normals: [z: number, rho: number][];
}

export interface TurnedSolid {
  positions: Float32Array;
  normals: Int8Array;
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

export function revolved(
  outline: readonly OutlinePiece[][],
  open_rad: number,
  threads: readonly Thread[] = [],
): TurnedSolid {
  const from = open_rad;
  const steps = Math.max(3, Math.ceil((TURN_STEPS * (2 * Math.PI - open_rad)) / (2 * Math.PI)));
  const angles = Array.from(
    { length: steps + 1 },
    (_, i) => from + ((2 * Math.PI - from) * i) / steps,
  );
  const ways = angles.map((angle) => [Math.cos(angle), Math.sin(angle)]);
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  const lines: number[] = [];
  for (const piece of outline.flat()) turn(piece, ways, positions, normals, indices);
  for (const pieces of outline) edge_lines(pieces, ways, open_rad > 0, lines);
  for (const thread of threads) helix(thread, from, lines);
  return {
    positions: new Float32Array(positions),
    normals: Int8Array.from(normals, Math.round),
    indices: new Uint32Array(indices),
    lines: new Float32Array(lines),
  };
}

/** The surface of a piece, as many rows as it has points. */
function turn(
  piece: OutlinePiece,
  ways: number[][],
  positions: number[],
  normals: number[],
  indices: number[],
): void {
  if (piece.points.every(([, rho]) => rho <= 0)) return;
  const first = positions.length / 3;
  piece.points.forEach(([z, rho], i) => {
    const [nz, nr] = piece.normals[i];
    for (const [c, s] of ways) {
      positions.push(rho * c, rho * s, z);
      normals.push(127 * nr * c, 127 * nr * s, 127 * nz, 0);
    }
  });
  for (let i = 0; i + 1 < piece.points.length; i++)
    stitch(first + i * ways.length, ways.length, indices);
}

/** Two rows of points that begin at `a`. */
function stitch(a: number, row: number, indices: number[]): void {
  for (let k = a; k + 1 < a + row; k++)
    indices.push(k, k + row + 1, k + 1, k, k + row, k + row + 1);
}

function pieces_of({ z, rho, bulge }: ProfileLoop): OutlinePiece[] {
  const pieces: OutlinePiece[] = [];
  for (let i = 0; i < z.length; i++) {
    const j = (i + 1) % z.length;
    if (z[i] === z[j] && rho[i] === rho[j]) continue;
    pieces.push(
      bulge[i] === 0 ? line(z[i], rho[i], z[j], rho[j]) : arc(z[i], rho[i], z[j], rho[j], bulge[i]),
    );
  }
  return pieces;
}

function line(z0: number, r0: number, z1: number, r1: number): OutlinePiece {
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
function arc(z0: number, r0: number, z1: number, r1: number, bulge: number): OutlinePiece {
  const sweep = 4 * Math.atan(bulge);
  const [dz, dr] = [z1 - z0, r1 - r0];
  // From the middle of the chord to the centre, on its left.
  const off = (1 - bulge * bulge) / (4 * bulge);
  const centre = [(z0 + z1) / 2 - off * dr, (r0 + r1) / 2 + off * dz];
  const radius = Math.hypot(z0 - centre[0], r0 - centre[1]);
  const begin = Math.atan2(r0 - centre[1], z0 - centre[0]);
  const chords = Math.max(1, Math.ceil(Math.abs(sweep) / CHORD_RAD));
  const points: [number, number][] = [];
  const normals: [number, number][] = [];
  const out = Math.sign(bulge);
  for (let k = 0; k <= chords; k++) {
    const angle = begin + (sweep * k) / chords;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    points.push([centre[0] + radius * c, centre[1] + radius * s]);
    normals.push([out * c, out * s]);
  }
  points[0] = [z0, r0];
  points[chords] = [z1, r1];
  return { points, normals };
}

/** Round the solid where two pieces meet in an edge, and the outline on both faces of the sector. */
function edge_lines(
  pieces: OutlinePiece[],
  ways: number[][],
  is_open: boolean,
  lines: number[],
): void {
  pieces.forEach((piece, i) => {
    const before = pieces[(i + pieces.length - 1) % pieces.length];
    const [az, ar] = before.normals[before.normals.length - 1];
    const [bz, br] = piece.normals[0];
    const [z, rho] = piece.points[0];
    if (az * bz + ar * br < EDGE && rho > 1e-6)
      for (let k = 0; k + 1 < ways.length; k++)
        lines.push(
          ...[rho * ways[k][0], rho * ways[k][1], z],
          ...[rho * ways[k + 1][0], rho * ways[k + 1][1], z],
        );
    if (!is_open) return;
    for (const [c, s] of [ways[0], ways[ways.length - 1]])
      for (let k = 0; k + 1 < piece.points.length; k++) {
        const [[z0, r0], [z1, r1]] = [piece.points[k], piece.points[k + 1]];
        lines.push(r0 * c, r0 * s, z0, r1 * c, r1 * s, z1);
      }
  });
}

const HELIX_STEPS = 48;
const MOST_TURNS = 400;

/** The crest of each start; so fine that they would be one face it is left out. */
function helix(
  { from, to, major, minor, pitch, starts }: Thread,
  open_rad: number,
  lines: number[],
) {
  const lead = pitch * Math.max(1, starts);
  const turns = Math.abs(to - from) / lead;
  if (!(pitch > 0) || turns > MOST_TURNS) return;
  const way = Math.sign(to - from);
  const rho = Math.max(major, minor) / 2;
  for (let start = 0; start < Math.max(1, starts); start++) {
    let before: number[] | null = null;
    for (let k = 0; k <= turns * HELIX_STEPS; k++) {
      const angle = 2 * Math.PI * (k / HELIX_STEPS + start / Math.max(1, starts));
      const place = angle % (2 * Math.PI);
      const z = from + (way * lead * k) / HELIX_STEPS;
      const is_there = place >= open_rad - 1e-9 && way * (to - z) >= 0;
      const point = [rho * Math.cos(angle), rho * Math.sin(angle), z];
      if (before && is_there) lines.push(...before, ...point);
      before = is_there ? point : null;
    }
  }
}

function reversed({ z, rho, bulge }: ProfileLoop): ProfileLoop {
  const n = z.length;
  return {
    z: z.slice().reverse(),
    rho: rho.slice().reverse(),
    bulge: Float64Array.from({ length: n }, (_, i) => -bulge[(2 * n - 2 - i) % n]),
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
  const ring = ring_of(pieces_of(outer));
  const [z, rho] = [inner.z[0], inner.rho[0]];
  let is_in = false;
  ring.forEach(([z0, r0], i) => {
    const [z1, r1] = ring[(i + 1) % ring.length];
    if (r0 > rho !== r1 > rho && z < z0 + ((rho - r0) / (r1 - r0)) * (z1 - z0)) is_in = !is_in;
  });
  return is_in;
}
