/**
 * The tool of a lathe: an insert in the plane of Z and X that touches the path with its imaginary tip, its holder behind it,
 * and the circle of the nose, which is what really cuts. As large as it is, and larger where it could not be seen.
 */
import { Group, type LineSegments } from 'three';
import { type Flat, type InsertShape, type Nose, insert_shape } from '../logic/turning_offsets';
import { type Palette, dispose, lines } from './furniture';
import { type Model, type Pose, part, plate } from './parts';

const EDGE_MM = 12;
const THICK_MM = 3;
const LEAST_PX = 26;
const HOLDER = { half_width: 0.34, length: 2.2 };
const CIRCLE_CHORDS = 48;

export class InsertModel implements Model {
  readonly group = new Group();
  private nose: Nose = { tip: -1, radius_mm: 0 };

  constructor(private readonly palette: Palette) {
    this.build({ tip: 3, radius_mm: 0 });
  }

  set(pose: Pose): void {
    this.group.position.set(...pose.tip);
    if (pose.nose) this.build(pose.nose);
  }

  scale(mm_per_pixel: number): void {
    this.group.scale.setScalar(Math.max(1, (LEAST_PX * mm_per_pixel) / EDGE_MM));
  }

  private build(nose: Nose): void {
    if (nose.tip === this.nose.tip && nose.radius_mm === this.nose.radius_mm) return;
    this.nose = nose;
    for (const child of [...this.group.children]) dispose(child as Group);
    const shape = insert_shape(nose, EDGE_MM);
    const insert = part(plate(shape.outline, THICK_MM), this.palette.tool);
    const holder = part(plate(holder_of(shape), THICK_MM), this.palette.metal_dark, 0.7);
    holder.position.y = -THICK_MM;
    this.group.add(holder, insert, tip_cross(this.palette), nose_circle(shape, this.palette));
  }
}

function holder_of({ centre, inwards: [z, x] }: InsertShape): Flat[] {
  const at = (along: number, across: number): Flat => [
    centre[0] + EDGE_MM * (along * z - across * x),
    centre[1] + EDGE_MM * (along * x + across * z),
  ];
  const { half_width, length } = HOLDER;
  return [
    at(0.6, -half_width),
    at(length, -half_width),
    at(length, half_width),
    at(0.6, half_width),
  ];
}

const IN_FRONT_MM = 0.2;
const CROSS_MM = 1.1;

/** The imaginary tip: what positions are about. */
function tip_cross(palette: Palette): LineSegments {
  const [y, arm] = [IN_FRONT_MM, CROSS_MM];
  return lines([-arm, y, 0, arm, y, 0, 0, y, -arm, 0, y, arm], palette.mark);
}

function nose_circle({ centre: [z, x], radius_mm }: InsertShape, palette: Palette): LineSegments {
  const points: number[] = [];
  for (let i = 0; i < CIRCLE_CHORDS; i++) {
    for (const end of [i, i + 1]) {
      const angle = (2 * Math.PI * end) / CIRCLE_CHORDS;
      points.push(x + radius_mm * Math.sin(angle), IN_FRONT_MM, z + radius_mm * Math.cos(angle));
    }
  }
  return lines(points, palette.mark);
}
