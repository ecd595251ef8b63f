/** The tool as its set-up describes it, in its true size: cutter, neck, shank and holder, or insert with its holder. */
import { Group, LatheGeometry, Mesh, type RawShaderMaterial, Vector2 } from 'three';
import type { PartKind, Point2, ToolShape } from '../logic/stock/tool_shape';
import { type Palette, dispose } from './furniture';
import { metal } from './metal';
import { plate } from './parts';

const COLOURS: Record<PartKind, 'tool' | 'metal' | 'metal_dark'> = {
  cutting: 'tool',
  neck: 'metal',
  shank: 'metal',
  holder: 'metal_dark',
};
const THICK_MM = 3;
const SIDES = 40;

export class ShapedTool {
  readonly group = new Group();

  constructor(
    readonly shape: ToolShape,
    palette: Palette,
  ) {
    const body = shape.turning ? flat : turned;
    for (const { kind, outline } of shape.parts) this.group.add(body(outline, kind, palette));
  }

  dispose(): void {
    dispose(this.group);
  }
}

function turned(outline: Point2[], kind: PartKind, palette: Palette): Mesh {
  const [first, last] = [outline[0], outline[outline.length - 1]];
  const closed: Point2[] = [[0, first[1]], ...outline, [0, last[1]]];
  const points = closed.map(([r, z]) => new Vector2(Math.max(0, r), z));
  const geometry = new LatheGeometry(points, SIDES).rotateX(Math.PI / 2);
  return new Mesh(geometry, material_of(kind, palette));
}

/** The holder lies behind the insert. */
function flat(outline: Point2[], kind: PartKind, palette: Palette): Mesh {
  const geometry =
    kind === 'holder' ? plate(outline, 2 * THICK_MM, THICK_MM) : plate(outline, THICK_MM);
  return new Mesh(geometry, material_of(kind, palette));
}

/** Through a holder the part below it is seen. */
const material_of = (kind: PartKind, palette: Palette): RawShaderMaterial =>
  metal({
    colour: palette[COLOURS[kind]],
    polish: kind === 'cutting' ? 1.1 : 0.8,
    opacity: kind === 'holder' ? 0.62 : 1,
    both_sides: kind !== 'holder',
  });
