/** The five-axis head: carriage, C with its arm r_c, A with the nozzle r_a above the focus. */
import {
  BoxGeometry,
  type BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  Group,
  type Mesh,
} from 'three';
import { head_pose } from '../logic/kinematics';
import type { Kinematics } from '../logic/protocol';
import type { Palette } from './furniture';
import { Beam, type Model, type Pose, part, pillar, translated } from './parts';

/** Its lengths, and the measure that all its parts are multiples of. */
interface Size {
  r_a: number;
  r_c: number;
  u: number;
}

export class HeadModel implements Model {
  readonly group = new Group();
  private readonly turning = new Group();
  private readonly tilting = new Group();
  private readonly beam: Beam;

  constructor(
    private readonly kinematics: Kinematics,
    palette: Palette,
  ) {
    const r_a = Number(kinematics.r_a);
    const size = { r_a, r_c: Number(kinematics.r_c), u: r_a / 10 };
    this.beam = new Beam(palette, r_a * 0.42, size.u * 0.22);
    this.tilting.add(translated(this.beam.mesh, 0, 0, -r_a), ...tilting_parts(size, palette));
    this.turning.add(...turning_parts(size, palette), translated(this.tilting, size.r_c, 0, 0));
    this.group.add(this.turning, ...carriage_parts(size, palette));
  }

  set(pose: Pose): void {
    const { carriage, a_rad, c_rad } = head_pose(this.kinematics, pose.joints);
    this.group.position.set(...carriage);
    this.turning.rotation.z = c_rad;
    this.tilting.rotation.x = a_rad;
    this.beam.set(pose.beam, pose.power);
  }
  scale(): void {}
}

/** About the axis of A: the nozzle, its tube and the motor across. */
function tilting_parts({ r_a, u }: Size, palette: Palette): Mesh[] {
  const motor = new CylinderGeometry(u * 1.25, u * 1.25, u * 6, 28).rotateZ(Math.PI / 2);
  return [
    part(nozzle(r_a, u), palette.metal),
    part(pillar(u * 1.5, u * 1.5, -r_a * 0.36, r_a * 0.3), palette.metal_dark),
    part(pillar(u * 2, u * 2, -r_a * 0.06, r_a * 0.16), palette.metal),
    part(motor, palette.metal_dark),
  ];
}

/** Open above, its tip towards the focus. */
const nozzle = (r_a: number, u: number): BufferGeometry =>
  new ConeGeometry(u * 1.5, r_a * 0.22, 28, 1, true)
    .rotateX(-Math.PI / 2)
    .translate(0, 0, -r_a * 0.47);

/** About the axis of C: its arm, and the fork that holds A. */
function turning_parts({ r_c, u }: Size, palette: Palette): Mesh[] {
  const box = (x: number, y: number, z: number): BoxGeometry =>
    new BoxGeometry(u * x, u * y, u * z);
  const arm = new BoxGeometry(r_c + u * 2.4, u * 1.6, u * 2).translate(r_c / 2, 0, u * 3.8);
  return [
    part(arm, palette.metal),
    part(box(1.2, 2.6, 5.2).translate(r_c + u * 3.3, 0, u * 1.3), palette.metal),
    part(box(6.6, 2.2, 1.6).translate(r_c + u * 0.6, 0, u * 3.9), palette.metal),
    part(pillar(u * 2.3, u * 2.3, u * 2.4, u * 2.8), palette.metal_dark),
  ];
}

function carriage_parts({ u }: Size, palette: Palette): Mesh[] {
  const slide = new BoxGeometry(u * 8.5, u * 8.5, u * 1.6).translate(0, 0, u * 9.2);
  return [
    part(pillar(u * 2.9, u * 2.9, u * 5.2, u * 3.2), palette.metal),
    part(slide, palette.metal_dark),
  ];
}
