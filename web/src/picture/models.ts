/**
 * The moving parts of each linkage, drawn by their function and not by their looks. A model is built once for a machine and
 * takes a pose for every picture; the poses come from logic/kinematics.ts.
 */
import {
  BoxGeometry,
  ConeGeometry,
  CylinderGeometry,
  Group,
  type Mesh,
  TorusGeometry,
} from 'three';
import { arm_pose, head_pose, turning_pose } from '../logic/kinematics';
import type { Kinematics, MachineDefinition } from '../logic/protocol';
import { type Palette, lines } from './furniture';
import { InsertModel } from './insert';
import { NozzleModel } from './nozzle';
import { OpticsModel } from './optics';
import { Beam, type Model, type Pose, link, part, pillar, translated } from './parts';

export type { Model, Pose } from './parts';

export function model_of(definition: MachineDefinition, palette: Palette, reach_mm: number): Model {
  const { kinematics } = definition;
  if (kinematics.kind === 'arm') return new ArmModel(kinematics, palette);
  if (kinematics.kind === 'head-ac') return new HeadModel(kinematics, palette);
  if (kinematics.kind === 'x-theta-z') return new TurningModel(kinematics, palette, reach_mm);
  if (definition.lathe) return new InsertModel(palette);
  return definition.laser ? new OpticsModel(definition, palette) : new SpindleModel(palette);
}

/** A holder and a cutter over the tip: a mill. It keeps a readable size. */
class SpindleModel implements Model {
  readonly group = new Group();
  constructor(palette: Palette) {
    this.group.add(
      part(pillar(1.6, 1.6, 0, 14), palette.tool),
      part(pillar(3.1, 3.1, 14, 5), palette.metal_dark),
      part(pillar(3.1, 6, 19, 6), palette.metal_dark),
      part(pillar(6, 6, 25, 12), palette.metal),
      part(pillar(8.4, 8.4, 37, 5), palette.metal_dark, 0.92),
    );
  }
  set(pose: Pose): void {
    this.group.position.set(...pose.tip);
  }
  scale(mm_per_pixel: number): void {
    this.group.scale.setScalar(Math.min(4, Math.max(0.25, 2.1 * mm_per_pixel)));
  }
}

/** The five-axis head: carriage, C with its arm r_c, A with the nozzle r_a above the focus. */
class HeadModel implements Model {
  readonly group = new Group();
  private readonly turning = new Group();
  private readonly tilting = new Group();
  private readonly beam: Beam;

  constructor(
    private readonly kinematics: Kinematics,
    palette: Palette,
  ) {
    const r_a = Number(kinematics.r_a);
    const r_c = Number(kinematics.r_c);
    const u = r_a / 10;
    this.beam = new Beam(palette, r_a * 0.42, u * 0.22);
    this.tilting.add(
      translated(this.beam.mesh, 0, 0, -r_a),
      part(
        new ConeGeometry(u * 1.5, r_a * 0.22, 28, 1, true)
          .rotateX(-Math.PI / 2)
          .translate(0, 0, -r_a * 0.47),
        palette.metal,
      ),
      part(pillar(u * 1.5, u * 1.5, -r_a * 0.36, r_a * 0.3), palette.metal_dark),
      part(pillar(u * 2, u * 2, -r_a * 0.06, r_a * 0.16), palette.metal),
      part(
        new CylinderGeometry(u * 1.25, u * 1.25, u * 6, 28).rotateZ(Math.PI / 2),
        palette.metal_dark,
      ),
    );
    this.turning.add(
      part(
        new BoxGeometry(r_c + u * 2.4, u * 1.6, u * 2).translate(r_c / 2, 0, u * 3.8),
        palette.metal,
      ),
      part(
        new BoxGeometry(u * 1.2, u * 2.6, u * 5.2).translate(r_c + u * 3.3, 0, u * 1.3),
        palette.metal,
      ),
      part(
        new BoxGeometry(u * 6.6, u * 2.2, u * 1.6).translate(r_c + u * 0.6, 0, u * 3.9),
        palette.metal,
      ),
      part(pillar(u * 2.3, u * 2.3, u * 2.4, u * 2.8), palette.metal_dark),
      translated(this.tilting, r_c, 0, 0),
    );
    this.group.add(
      this.turning,
      part(pillar(u * 2.9, u * 2.9, u * 5.2, u * 3.2), palette.metal),
      part(new BoxGeometry(u * 8.5, u * 8.5, u * 1.6).translate(0, 0, u * 9.2), palette.metal_dark),
    );
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

/** The two-link arm: column, upper arm, forearm, and the wheel that grinds, its heading marked. */
class ArmModel implements Model {
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
    this.build_wheel(palette, u);
    this.fore.add(
      link(fore_mm, u * 1.5, u * 0.8, u * 2.4, palette.metal),
      part(pillar(u * 0.5, u * 0.5, u * 0.4, u * 2.2).translate(fore_mm, 0, 0), palette.metal_dark),
      part(pillar(u * 0.8, u * 0.8, u * 3.2, u * 1.3).translate(fore_mm, 0, 0), palette.metal_dark),
      translated(this.wheel, fore_mm, 0, 0),
    );
    this.upper.add(
      link(upper_mm, u * 2, u, u * 3.4, palette.metal),
      part(
        pillar(u * 0.75, u * 0.75, u * 2.1, u * 2.8).translate(upper_mm, 0, 0),
        palette.metal_dark,
      ),
      translated(this.fore, upper_mm, 0, 0),
    );
    this.lift.add(this.upper, part(pillar(u * 1.25, u * 1.25, u * 2.2, u * 3), palette.metal_dark));
    this.group.add(
      this.lift,
      part(pillar(u * 0.7, u * 0.7, -u * 4, u * 12), palette.metal_dark),
      part(pillar(u * 2.2, u * 1.7, -u * 4, u * 3), palette.metal),
    );
  }

  /** The wheel stands upright: its plane holds the vertical and its heading, its lowest point is the tip. */
  private build_wheel(palette: Palette, u: number): void {
    const radius = u * 0.62;
    const disc = new CylinderGeometry(radius, radius, radius * 0.32, 36).translate(0, 0, 0);
    const rim = new TorusGeometry(radius, radius * 0.1, 10, 40).rotateX(Math.PI / 2);
    this.wheel.add(
      translated(part(disc, palette.tool), 0, 0, radius),
      translated(part(rim, palette.mark), 0, 0, radius),
      lines([-u * 1.4, 0, 0, u * 1.4, 0, 0], palette.mark),
    );
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

/** A beam that moves along X over work that turns: the path stands still here, so the carriage turns about the work. */
class TurningModel implements Model {
  readonly group = new Group();
  private readonly carriage = new Group();
  private readonly nozzle: NozzleModel;
  private readonly rail: Mesh;

  constructor(
    private readonly kinematics: Kinematics,
    palette: Palette,
    reach_mm: number,
  ) {
    this.nozzle = new NozzleModel(palette);
    const u = reach_mm / 55;
    this.rail = part(
      new BoxGeometry(reach_mm * 1.35, u, u).translate(reach_mm * 0.6, 0, 0),
      palette.metal,
    );
    const post = part(
      new BoxGeometry(u * 1.6, u * 1.6, reach_mm * 0.75).translate(
        reach_mm * 1.25,
        0,
        -reach_mm * 0.375,
      ),
      palette.metal_dark,
    );
    this.carriage.add(this.rail, post);
    this.group.add(
      this.carriage,
      this.nozzle.group,
      lines([0, 0, -reach_mm * 0.25, 0, 0, reach_mm * 0.55], palette.z),
    );
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
