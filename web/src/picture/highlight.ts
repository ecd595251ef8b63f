/** The path of the chosen line, drawn over everything: wide, in one colour, with a dark edge that holds on any ground; and the region of a chosen feature. */
import { Color, Group, type Mesh } from 'three';
import type { Region } from '../logic/features/region';
import type { PathStore, Range } from '../logic/path_store';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import { dispose } from './furniture';
import { region_group } from './region_group';

export type { Region };

const MOST_SEGMENTS = 200_000;

export class Highlight {
  readonly group = new Group();
  private readonly edge = new LineMaterial({
    color: 0x000000,
    linewidth: 6,
    depthTest: false,
    transparent: true,
    opacity: 0.55,
  });
  /** Drawn behind the edge, as what is transparent is. */
  private readonly core = new LineMaterial({
    color: 0xffffff,
    linewidth: 3,
    depthTest: false,
    transparent: true,
  });

  private colour = '#ffffff';
  private region: Group | null = null;

  set_colour(colour: string): void {
    this.colour = colour;
    this.core.color = new Color(colour);
  }

  set(store: PathStore | null, ranges: Range[], region: Region | null): void {
    dispose(this.region);
    for (const child of this.group.children) (child as Mesh).geometry.dispose();
    this.group.clear();
    this.region = region && region_group(region, this.colour);
    if (this.region) this.group.add(this.region);
    if (region) this.add(outlines_of(region));
    if (store && ranges.length) this.add(segments_of(store, ranges));
  }

  private add(segments: Float32Array): void {
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(segments);
    [this.edge, this.core].forEach((material, i) => {
      const lines = new LineSegments2(geometry, material);
      lines.renderOrder = 5 + i;
      lines.frustumCulled = false;
      this.group.add(lines);
    });
  }
}

function outlines_of({ outlines, is_closed }: Region): Float32Array {
  const segments = outlines.flatMap((outline) =>
    outline.flatMap((place, i) => {
      const next = outline[(i + 1) % outline.length];
      return is_closed || i + 1 < outline.length ? [...place, ...next] : [];
    }),
  );
  return new Float32Array(segments);
}

function segments_of(store: PathStore, ranges: Range[]): Float32Array {
  const total = Math.min(
    MOST_SEGMENTS,
    ranges.reduce((sum, range) => sum + range.last - range.first, 0),
  );
  const points = new Float32Array(6 * total);
  let at = 0;
  for (const { chunk, first, last } of ranges) {
    const { xyz } = store.chunks[chunk];
    for (let i = first; i < last && at < points.length; i++, at += 6) {
      points.set(xyz.subarray(3 * i, 3 * i + 6), at);
    }
  }
  return points;
}
