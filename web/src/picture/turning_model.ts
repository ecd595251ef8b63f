/** A beam that moves along X over work that turns: the path stands still here, so the carriage turns about the work. */
import { BoxGeometry, Group, type Mesh } from 'three';
import { turning_pose } from '../logic/kinematics';
import type { Kinematics } from '../logic/protocol';
import { lines, type Palette } from './furniture';
import { NozzleModel } from './nozzle';
import { type Model, type Pose, part } from './parts';

export class TurningModel implements Model {
  readonly group = new Group();
  private readonly carriage = new Group();
  private readonly nozzle: NozzleModel;

  constructor(
    private readonly kinematics: Kinematics,
    palette: Palette,
    reach_mm: number,
  ) {
    this.nozzle = new NozzleModel(palette);
    this.carriage.add(...carriage_parts(reach_mm, palette));
    const axis = lines([0, 0, -reach_mm * 0.25, 0, 0, reach_mm * 0.55], palette.z);
    this.group.add(this.carriage, this.nozzle.group, axis);
  }

  set(pose: Pose): void {
    const { work_rad, tip } = turning_pose(this.kinematics, pose.joints);
    this.nozzle.set({ ...pose, tip });
    this.carriage.rotation.z = work_rad;
    this.carriage.position.z = tip[2] + 40 * this.nozzle.group.scale.z;
  }
  scale(mm_per_pixel: number): void {
    this.nozzle.scale(mm_per_pixel);
  }
}

/** The rail along X, and the post that it stands on beside the work. */
function carriage_parts(reach_mm: number, palette: Palette): Mesh[] {
  const u = reach_mm / 55;
  const rail = new BoxGeometry(reach_mm * 1.35, u, u).translate(reach_mm * 0.6, 0, 0);
  const post = new BoxGeometry(u * 1.6, u * 1.6, reach_mm * 0.75);
  post.translate(reach_mm * 1.25, 0, -reach_mm * 0.375);
  return [part(rail, palette.metal), part(post, palette.metal_dark)];
}
