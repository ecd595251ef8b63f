/**
 * The path in the scene: one mesh for each block of at most BLOCK segments and each level of detail that was looked at; there
 * is no object for a segment. Blocks outside of the picture are left out by three; of the others the coarsest level is drawn
 * that leaves the path by less than a pixel (logic/thin.ts), so what a picture costs follows its pixels and not the length
 * of the program.
 */
import { Group, type Mesh } from 'three';
import type { Block, PathStore } from '../logic/path_store';
import { thinned } from '../logic/thin';
import type { PathMaterial } from './path_material';
import { dispose_path_mesh, path_mesh } from './path_mesh';

/** Level 0 is exact; level k leaves the path by at most TOLERANCES_MM[k]. */
const TOLERANCES_MM = [0, 0.01, 0.02, 0.04, 0.08, 0.16, 0.32, 0.64, 1.28, 2.56, 5.12, 10.24];
/** A level that saves less than this share of the vertices is not worth its memory. */
const WORTH = 0.8;

interface BlockView {
  block: Block;
  /** Vertices of the path before the block's chunk. */
  start: number;
  levels: Mesh[];
  drawn: Mesh | null;
}

export class PathLayer {
  readonly group = new Group();
  private views: BlockView[] = [];
  private store: PathStore | null = null;
  private run = -1;

  constructor(private readonly material: PathMaterial) {}

  /** Takes over the blocks that have arrived since the last time. */
  take(store: PathStore): void {
    if (store !== this.store || store.run !== this.run || store.blocks.length < this.views.length) {
      this.clear();
      this.store = store;
      this.run = store.run;
    }
    for (let i = this.views.length; i < store.blocks.length; i++) {
      const block = store.blocks[i];
      this.views.push({ block, start: chunk_start(store, block), levels: [], drawn: null });
    }
  }

  /** Chooses levels for a picture in which a pixel is `pixel_mm` wide; `slack` pixels may be lost. */
  choose_detail(pixel_mm: number, slack: number): void {
    const allowed = pixel_mm * slack;
    const level = TOLERANCES_MM.filter((tolerance) => tolerance <= allowed).length - 1;
    for (const view of this.views) this.show(view, this.mesh(view, level));
  }

  clear(): void {
    for (const { levels } of this.views)
      for (const mesh of new Set(levels.filter(Boolean))) dispose_path_mesh(mesh);
    this.views = [];
    this.group.clear();
  }

  private show(view: BlockView, mesh: Mesh): void {
    if (view.drawn === mesh) return;
    if (view.drawn) this.group.remove(view.drawn);
    this.group.add(mesh);
    view.drawn = mesh;
  }

  private mesh(view: BlockView, level: number): Mesh {
    view.levels[level] ??= level === 0 ? this.exact(view) : this.coarse(view, level);
    return view.levels[level];
  }

  private exact(view: BlockView): Mesh {
    const { first, last } = view.block;
    const all = Uint32Array.from({ length: last - first + 1 }, (_, i) => first + i);
    return this.make(view, all);
  }

  /** The exact mesh where thinning saves little. */
  private coarse(view: BlockView, level: number): Mesh {
    const kept = thinned(view.block, TOLERANCES_MM[level]);
    const all = view.block.last - view.block.first + 1;
    return kept.length > WORTH * all ? this.mesh(view, 0) : this.make(view, kept);
  }

  private make(view: BlockView, vertices: Uint32Array): Mesh {
    const { chunk, box } = view.block;
    return path_mesh(chunk, vertices, box, view.start, this.material);
  }
}

/** Vertices of the path before this block's chunk. */
function chunk_start(store: PathStore, block: Block): number {
  let start = 0;
  for (const chunk of store.chunks) {
    if (chunk === block.chunk) return start;
    start += chunk.vertices;
  }
  return start;
}
