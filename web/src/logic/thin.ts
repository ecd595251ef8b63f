/**
 * Fewer vertices for a picture: which vertices of a block are needed so that no point of the path is farther than
 * `tolerance_mm` from what is drawn. A vertex is left out while it lies within the tolerance of the last one kept. Kept
 * always: both ends, and where kind, tool or power change, because the colour does.
 *
 * Guarantee: a vertex left out lies within tolerance_mm of a kept one, and of every piece drawn one end is kept and the
 * other at most tolerance_mm from where the path has it. So the drawn line leaves the path by at most tolerance_mm.
 */
import type { Block } from './path_store';

export function thinned(block: Block, tolerance_mm: number): Uint32Array {
  const { chunk, first, last } = block;
  const { xyz } = chunk;
  const kept = new Uint32Array(last - first + 1);
  let count = 0;
  kept[count++] = first;
  let at = 3 * first;
  const limit = tolerance_mm * tolerance_mm;
  for (let i = first + 1; i < last; i++) {
    const b = 3 * i;
    const dx = xyz[b] - xyz[at];
    const dy = xyz[b + 1] - xyz[at + 1];
    const dz = xyz[b + 2] - xyz[at + 2];
    if (dx * dx + dy * dy + dz * dz <= limit && !changes_behind(chunk, i)) continue;
    kept[count++] = i;
    at = b;
  }
  if (last > first) kept[count++] = last;
  return kept.slice(0, count);
}

type Looks = Pick<Block['chunk'], 'kind' | 'tool' | 'power_percent'>;

function changes_behind(chunk: Looks, i: number): boolean {
  return (
    chunk.kind[i] !== chunk.kind[i + 1] ||
    chunk.tool[i] !== chunk.tool[i + 1] ||
    chunk.power_percent[i] !== chunk.power_percent[i + 1]
  );
}
