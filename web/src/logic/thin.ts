/**
 * Fewer vertices for a picture: which vertices of a block are needed so that no point of the path is farther than
 * `tolerance_mm` from what is drawn. Kept always: both ends, and where kind, tool or power change, because the colour does.
 *
 * Guarantee: every vertex left out lies within tolerance_mm of the piece drawn over it. The path between the ends of a piece is
 * connected, so its feet cover the piece, and the piece lies within tolerance_mm of the path as well.
 */
import type { Block } from './path_store';

/** A piece replaces at most this many segments: what keeps the work in proportion to the vertices. */
const LONGEST = 32;

export function thinned(block: Block, tolerance_mm: number): Uint32Array {
  const { chunk, first, last } = block;
  const limit = tolerance_mm * tolerance_mm;
  const kept = new Uint32Array(last - first + 1);
  let count = 0;
  kept[count++] = first;
  for (let from = first; from < last;) {
    const to = piece_end(chunk, from, last, limit);
    kept[count++] = to;
    from = to;
  }
  return kept.slice(0, count);
}

type Path = Pick<Block['chunk'], 'xyz' | 'kind' | 'tool' | 'power_percent'>;

/** The farthest vertex that one piece from `from` may lead to. */
function piece_end(path: Path, from: number, last: number, limit: number): number {
  const end = Math.min(last, from + LONGEST);
  let to = from + 1;
  while (to < end && !changes_behind(path, to) && covers(path.xyz, from, to + 1, limit)) to++;
  return to;
}

/** Whether all vertices between `from` and `to` lie close enough to the piece between them. */
function covers(xyz: Float32Array, from: number, to: number, limit: number): boolean {
  const a = 3 * from;
  const dx = xyz[3 * to] - xyz[a];
  const dy = xyz[3 * to + 1] - xyz[a + 1];
  const dz = xyz[3 * to + 2] - xyz[a + 2];
  const length2 = dx * dx + dy * dy + dz * dz;
  for (let p = a + 3; p < 3 * to; p += 3) {
    const px = xyz[p] - xyz[a];
    const py = xyz[p + 1] - xyz[a + 1];
    const pz = xyz[p + 2] - xyz[a + 2];
    const dot = px * dx + py * dy + pz * dz;
    const share = dot <= 0 ? 0 : dot >= length2 ? 1 : dot / length2;
    const ox = px - share * dx;
    const oy = py - share * dy;
    const oz = pz - share * dz;
    if (ox * ox + oy * oy + oz * oz > limit) return false;
  }
  return true;
}

function changes_behind(path: Path, i: number): boolean {
  return (
    path.kind[i] !== path.kind[i + 1] ||
    path.tool[i] !== path.tool[i + 1] ||
    path.power_percent[i] !== path.power_percent[i + 1]
  );
}
