/** The tool as its set-up describes it, in its true size: cutter, neck, shank and holder, or insert with its holder. */
import {
  DoubleSide,
  ExtrudeGeometry,
  Group,
  LatheGeometry,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  Shape,
  Vector2,
} from 'three';
import type { PartKind, Point2, ToolShape } from '../logic/stock/tool_shape';
import { type Palette, dispose } from './furniture';

/** Z of the part goes along Z of the scene, the radius along X, what is thick towards -Y. */
const INTO_SCENE = new Matrix4().set(0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1);
const THICK_MM = 3;
const SIDES = 40;

export class ShapedTool {
  readonly group = new Group();

  constructor(
    readonly shape: ToolShape,
    palette: Palette,
  ) {
    for (const { kind, outline } of shape.parts)
      this.group.add(
        shape.turning ? plate(outline, kind, palette) : turned(outline, kind, palette),
      );
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

function plate(outline: Point2[], kind: PartKind, palette: Palette): Mesh {
  const shape = new Shape(outline.map(([z, r]) => new Vector2(z, r)));
  const depth = kind === 'holder' ? 2 * THICK_MM : THICK_MM;
  const geometry = new ExtrudeGeometry(shape, { depth, bevelEnabled: false });
  geometry.translate(0, 0, kind === 'holder' ? -depth - THICK_MM : -depth);
  return new Mesh(geometry.applyMatrix4(INTO_SCENE), material_of(kind, palette));
}

function material_of(kind: PartKind, palette: Palette): MeshStandardMaterial {
  const colours: Record<PartKind, string> = {
    cutting: palette.tool,
    neck: palette.metal,
    shank: palette.metal,
    holder: palette.metal_dark,
  };
  return new MeshStandardMaterial({
    color: colours[kind],
    roughness: kind === 'cutting' ? 0.32 : 0.5,
    metalness: 0.35,
    side: DoubleSide,
    transparent: kind === 'holder',
    opacity: kind === 'holder' ? 0.55 : 1,
  });
}
