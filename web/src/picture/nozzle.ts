import { ConeGeometry, Group } from 'three';
import type { Palette } from './furniture';
import { Beam, type Model, type Pose, part, pillar } from './parts';

/** A nozzle over the tip with its beam: a laser. */
export class NozzleModel implements Model {
  readonly group = new Group();
  private readonly beam: Beam;
  constructor(palette: Palette) {
    this.beam = new Beam(palette, 10, 0.9);
    this.group.add(
      this.beam.mesh,
      part(
        new ConeGeometry(5, 12, 28, 1, true).rotateX(-Math.PI / 2).translate(0, 0, 13),
        palette.metal,
      ),
      part(pillar(5, 5, 19, 16), palette.metal_dark),
      part(pillar(6.4, 6.4, 35, 4), palette.metal),
    );
  }
  set(pose: Pose): void {
    this.group.position.set(...pose.tip);
    this.beam.set(pose.beam, pose.power);
  }
  scale(mm_per_pixel: number): void {
    this.group.scale.setScalar(Math.min(4, Math.max(0.1, 2.1 * mm_per_pixel)));
  }
}
