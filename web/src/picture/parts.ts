/** What the models of machines are made of. */
import {
  BoxGeometry,
  CylinderGeometry,
  ExtrudeGeometry,
  Group,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Shape,
  Vector2,
  Vector3,
  type BufferGeometry,
} from 'three';
import type { Point } from '../logic/kinematics';
import type { Axes } from '../logic/protocol';
import type { Nose } from '../logic/turning_offsets';
import type { Palette } from './furniture';
import { metal } from './metal';

export interface Pose {
  tip: Point;
  joints: Axes;
  tool: number;
  beam: boolean;
  /** 0 to 1. */
  power: number;
  /** Of a lathe's tool. */
  nose?: Nose;
}

export interface Model {
  readonly group: Group;
  set(pose: Pose): void;
  /** Parts that keep their size in the picture whatever the scale, as a tool over a large table. */
  scale(mm_per_pixel: number): void;
}

export function part(geometry: BufferGeometry, colour: string, opacity = 1): Mesh {
  return new Mesh(geometry, metal({ colour, opacity }));
}

/** A cylinder along Z from `bottom` up. */
export function pillar(
  radius_low: number,
  radius_high: number,
  bottom: number,
  height: number,
): BufferGeometry {
  return new CylinderGeometry(radius_high, radius_low, height, 28)
    .rotateX(Math.PI / 2)
    .translate(0, 0, bottom + height / 2);
}

/** Of a shape the first coordinate goes along Z, the second along X, the third towards who looks at it. */
const INTO_SCENE = new Matrix4().set(0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1);

/** An outline in Z and X as a plate: from the plane of the path, or from so far behind it, on to -Y. */
export function plate(
  outline: readonly (readonly [z: number, x: number])[],
  depth: number,
  behind = 0,
): BufferGeometry {
  const shape = new Shape(outline.map(([z, x]) => new Vector2(z, x)));
  const geometry = new ExtrudeGeometry(shape, { depth, bevelEnabled: false });
  return geometry.translate(0, 0, -depth - behind).applyMatrix4(INTO_SCENE);
}

/** A bar along X with round ends, lying on `z`. */
export function link(
  length: number,
  width: number,
  thick: number,
  z: number,
  colour: string,
): Group {
  const group = new Group();
  const middle = z + thick / 2;
  const bar = new BoxGeometry(length, width, thick).translate(length / 2, 0, middle);
  const ends = [0, length].map((x) => pillar(width / 2, width / 2, z, thick).translate(x, 0, 0));
  group.add(...[bar, ...ends].map((geometry) => part(geometry, colour)));
  return group;
}

/** The beam between head and work: seen while it is on, brighter with power. */
export class Beam {
  readonly mesh: Mesh;
  constructor(palette: Palette, length: number, radius: number) {
    const geometry = new CylinderGeometry(radius, radius * 0.35, length, 12)
      .rotateX(Math.PI / 2)
      .translate(0, 0, length / 2);
    this.mesh = new Mesh(
      geometry,
      new MeshBasicMaterial({ color: palette.beam, transparent: true, depthWrite: false }),
    );
  }
  set(on: boolean, power: number): void {
    (this.mesh.material as MeshBasicMaterial).opacity = on ? 0.35 + 0.6 * power : 0.1;
  }
}

export function translated<T extends Group | Mesh>(object: T, x: number, y: number, z: number): T {
  object.position.copy(new Vector3(x, y, z));
  return object;
}
