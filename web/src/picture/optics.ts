/**
 * A laser with flying optics: mirror 1 is fixed behind the left of the table, mirror 2 travels in Y, mirror 3 with the lens in X
 * too. The way of the light is drawn from the source to the focus.
 */
import { BoxGeometry, Group, Mesh, MeshBasicMaterial } from 'three';
import type { Point } from '../logic/kinematics';
import type { MachineDefinition } from '../logic/protocol';
import type { Palette } from './furniture';
import { NozzleModel } from './nozzle';
import { type Model, type Pose, part } from './parts';

/** Parts beside the travel, as a share of its length. */
const MARGIN = 0.06;
const DEFAULT_TRAVEL_MM = 100;
/** Mirror 3 stands on the nozzle, in the nozzle's own measure. */
const LIGHT_ABOVE_TIP = 42;
const WIDTH = 0.9;

export class OpticsModel implements Model {
  readonly group = new Group();
  private readonly nozzle: NozzleModel;
  private readonly light: MeshBasicMaterial;
  private readonly legs: Mesh[];
  private readonly mirrors: readonly Mesh[];
  private readonly gantry: Mesh;
  private readonly source: Mesh;
  private readonly low: number[];
  private readonly high: number[];
  private tip: Point = [0, 0, 0];

  constructor(definition: MachineDefinition, palette: Palette) {
    const axes = ['X', 'Y'].map((name) => definition.axes.find((axis) => axis.name === name));
    this.low = axes.map((axis) => axis?.min ?? 0);
    this.high = axes.map((axis, i) => axis?.max ?? this.low[i] + DEFAULT_TRAVEL_MM);
    this.nozzle = new NozzleModel(palette);
    this.light = new MeshBasicMaterial({ color: palette.beam, ...SEEN_THROUGH });
    this.legs = [0, 1, 2].map(() => new Mesh(unit_box(), this.light));
    this.mirrors = mirrors(palette);
    this.gantry = part(unit_box(), palette.metal_dark, 0.5);
    this.source = part(unit_box(), palette.metal_dark);
    const all = [...this.legs, ...this.mirrors, this.gantry, this.source];
    this.group.add(this.nozzle.group, ...all);
  }

  set(pose: Pose): void {
    this.tip = pose.tip;
    this.nozzle.set(pose);
    this.light.opacity = pose.beam ? 0.35 + 0.6 * pose.power : 0.12;
    this.place();
  }

  scale(mm_per_pixel: number): void {
    this.nozzle.scale(mm_per_pixel);
    this.place();
  }

  private place(): void {
    const unit = this.nozzle.group.scale.z;
    const z = this.tip[2] + LIGHT_ABOVE_TIP * unit;
    const corners = this.way_of_light(z);
    this.legs.forEach((leg, i) => stretch(leg, corners[i], corners[i + 1], WIDTH * unit));
    this.mirrors.forEach((mirror, i) => {
      mirror.position.set(...corners[i + 1]);
      mirror.scale.setScalar(unit);
    });
    const [, left, carriage] = corners;
    const right = this.high[0];
    stretch(this.source, corners[0], [right, left[1], z], 9 * unit);
    const below = z - 6 * unit;
    stretch(this.gantry, [left[0], carriage[1], below], [right, carriage[1], below], 3 * unit);
  }

  /** From the source over the mirrors to above the tip. */
  private way_of_light(z: number): [source: Point, left: Point, carriage: Point, tip: Point] {
    const [x0, y0] = this.low;
    const [x1, y1] = this.high;
    const left = x0 - MARGIN * (x1 - x0);
    const back = y1 + MARGIN * (y1 - y0);
    const [x, y] = this.tip;
    return [
      [x0 + 0.25 * (x1 - x0), back, z],
      [left, back, z],
      [left, y, z],
      [x, y, z],
    ];
  }
}

const SEEN_THROUGH = { transparent: true, depthWrite: false };
const unit_box = (): BoxGeometry => new BoxGeometry(1, 1, 1);

/** Each turns the light by a right angle. */
function mirrors(palette: Palette): Mesh[] {
  const all = [0, 1, 2].map(() => part(new BoxGeometry(10, 1, 10), palette.metal));
  all[0].rotation.z = all[1].rotation.z = Math.PI / 4;
  all[2].rotation.set(Math.PI / 2, Math.PI / 4, 0);
  return all;
}

/** Lays a unit box along X or Y from a to b. */
function stretch(box: Mesh, a: Point, b: Point, thick: number): void {
  box.position.set((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2);
  const along = (i: number) => Math.max(thick, Math.abs(b[i] - a[i]));
  box.scale.set(along(0), along(1), thick);
}
