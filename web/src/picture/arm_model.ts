/** The two-link arm: column, upper arm, forearm, and the wheel that grinds, its heading marked. */
import {
  type BufferGeometry,
  CylinderGeometry,
  Group,
  type Mesh,
  type Object3D,
  TorusGeometry,
} from 'three';
import { arm_pose } from '../logic/kinematics';
import type { Kinematics } from '../logic/protocol';
import { lines, type Palette } from './furniture';
import { link, type Model, type Pose, part, pillar, translated } from './parts';

export class ArmModel implements Model {
  readonly group = new Group();
  private readonly lift = new Group();
  private readonly upper = new Group();
  private readonly fore = new Group();
  private readonly wheel = new Group();

  constructor(
    private readonly kinematics: Kinematics,
    palette: Palette,
  ) {
    const upper_mm = Number(kinematics.upper_arm);
    const fore_mm = Number(kinematics.forearm);
    const u = (upper_mm + fore_mm) / 26;
    this.wheel.add(...wheel_parts(u, palette));
    this.fore.add(...fore_parts(u, fore_mm, palette), translated(this.wheel, fore_mm, 0, 0));
    this.upper.add(...upper_parts(u, upper_mm, palette), translated(this.fore, upper_mm, 0, 0));
    this.lift.add(this.upper, part(pillar(u * 1.25, u * 1.25, u * 2.2, u * 3), palette.metal_dark));
    this.group.add(this.lift, ...column_parts(u, palette));
  }

  set(pose: Pose): void {
    const { upper_arm_rad, forearm_rad, wheel_rad, wrist } = arm_pose(this.kinematics, pose.joints);
    this.lift.position.z = wrist[2];
    this.upper.rotation.z = upper_arm_rad;
    this.fore.rotation.z = forearm_rad - upper_arm_rad;
    this.wheel.rotation.z = wheel_rad - forearm_rad;
  }
  scale(): void {}
}

/** The wheel stands upright: its plane holds the vertical and its heading, its lowest point is the tip. */
function wheel_parts(u: number, palette: Palette): Object3D[] {
  const radius = u * 0.62;
  const disc = new CylinderGeometry(radius, radius, radius * 0.32, 36);
  const rim = new TorusGeometry(radius, radius * 0.1, 10, 40).rotateX(Math.PI / 2);
  return [
    translated(part(disc, palette.tool), 0, 0, radius),
    translated(part(rim, palette.mark), 0, 0, radius),
    lines([-u * 1.4, 0, 0, u * 1.4, 0, 0], palette.mark),
  ];
}

/** The forearm, and at its end the spindle of the wheel with its motor. */
function fore_parts(u: number, long: number, palette: Palette): Object3D[] {
  return [
    link(long, u * 1.5, u * 0.8, u * 2.4, palette.metal),
    at_end(pillar(u * 0.5, u * 0.5, u * 0.4, u * 2.2), long, palette),
    at_end(pillar(u * 0.8, u * 0.8, u * 3.2, u * 1.3), long, palette),
  ];
}

/** The upper arm, and the elbow at its end. */
function upper_parts(u: number, long: number, palette: Palette): Object3D[] {
  return [
    link(long, u * 2, u, u * 3.4, palette.metal),
    at_end(pillar(u * 0.75, u * 0.75, u * 2.1, u * 2.8), long, palette),
  ];
}

const at_end = (geometry: BufferGeometry, long: number, palette: Palette): Mesh =>
  part(geometry.translate(long, 0, 0), palette.metal_dark);

function column_parts(u: number, palette: Palette): Mesh[] {
  return [
    part(pillar(u * 0.7, u * 0.7, -u * 4, u * 12), palette.metal_dark),
    part(pillar(u * 2.2, u * 1.7, -u * 4, u * 3), palette.metal),
  ];
}
