/**
 * The moving parts of each linkage, drawn by their function and not by their looks. A model is built once for a machine and
 * takes a pose for every picture; the poses come from logic/kinematics.ts.
 */
import { Group } from 'three';
import type { MachineDefinition } from '../logic/protocol';
import { ArmModel } from './arm_model';
import type { Palette } from './furniture';
import { HeadModel } from './head_model';
import { InsertModel } from './insert';
import { OpticsModel } from './optics';
import { type Model, type Pose, part, pillar } from './parts';
import { TurningModel } from './turning_model';

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
