/** The region of a feature in the picture: what its outlines enclose, seen through. */
import {
  Group,
  Mesh,
  MeshBasicMaterial,
  DoubleSide,
  Path,
  Shape,
  ShapeGeometry,
  Vector2,
} from 'three';
import type { Place, Region } from '../logic/features/region';

const OPACITY = 0.28;

export function region_group({ outlines, is_closed }: Region, colour: string): Group {
  const group = new Group();
  if (is_closed) group.add(...shapes_of(outlines).map((shape) => filled(shape, colour)));
  return group;
}

interface Filled {
  shape: Shape;
  z: number;
}

/** What lies in another outline is an island of it. */
function shapes_of(outlines: Place[][]): Filled[] {
  const flat = outlines.map((outline) => outline.map(([x, y]) => new Vector2(x, y)));
  const shapes: (Filled & { points: Vector2[] })[] = [];
  flat.forEach((points, i) => {
    const around = shapes.find((each) => is_inside(points[0], each.points));
    if (around) around.shape.holes.push(new Path(points));
    else shapes.push({ shape: new Shape(points), z: outlines[i][0][2], points });
  });
  return shapes;
}

function filled({ shape, z }: Filled, colour: string): Mesh {
  const looks = { color: colour, opacity: OPACITY, side: DoubleSide };
  const material = new MeshBasicMaterial({ ...looks, transparent: true, depthTest: false });
  const mesh = new Mesh(new ShapeGeometry(shape), material);
  mesh.position.z = z;
  mesh.renderOrder = 4;
  return mesh;
}

/** By the crossings of a ray to the right. */
function is_inside({ x, y }: Vector2, outline: Vector2[]): boolean {
  let inside = false;
  outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length];
    if (a.y > y !== b.y > y && x < a.x + ((y - a.y) / (b.y - a.y)) * (b.x - a.x)) inside = !inside;
  });
  return inside;
}
