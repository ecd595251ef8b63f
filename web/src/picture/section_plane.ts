/** The cut face of a section: a plane that is drawn where the inner side of a body is seen (stock_material.ts). */
import { BufferAttribute, BufferGeometry, Mesh } from 'three';
import type { StockMaterials } from './stock_material';

export interface Section {
  axis: 0 | 1 | 2;
  /** From the zero of the stock. */
  at: number;
  /** What lies towards +: is left out; else what lies towards −. */
  from_above: boolean;
}

/** Of the section's normal: it points to what is left out. */
export function plane_of({ axis, at, from_above }: Section): {
  normal: [number, number, number];
  at: number;
} {
  const way = from_above ? 1 : -1;
  const normal: [number, number, number] = [0, 0, 0];
  normal[axis] = way;
  return { normal, at: way * at };
}

/** Of a rectangle, one corner behind the other: 0 the low end of a side, 1 the high one. */
const ROUND = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
] as const;

/** Bodies, their inner sides, the plane, then everything else. */
export const ORDER = { behind: -5, surface: -4, inside: -3, plane: -2, lines: -1 };

export class SectionPlane {
  readonly mesh: Mesh;
  private readonly corners = new BufferAttribute(new Float32Array(12), 3);

  constructor(private readonly materials: StockMaterials) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.corners);
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.mesh = new Mesh(geometry, materials.plane_face);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = ORDER.plane;
    this.mesh.visible = false;
  }

  /** Opens the body, and lies over all of its box; null: there is no section. */
  set(section: Section | null, low: readonly number[], high: readonly number[]): void {
    const plane = section && plane_of(section);
    this.materials.set_section(plane?.normal ?? null, plane?.at ?? 0);
    this.mesh.visible = section !== null;
    if (section) this.lay(section, [low, high]);
  }

  private lay({ axis, at }: Section, box: readonly [readonly number[], readonly number[]]): void {
    const [u, v] = [0, 1, 2].filter((i) => i !== axis);
    ROUND.forEach(([along, across], i) => {
      this.corners.setComponent(i, axis, at);
      this.corners.setComponent(i, u, box[along][u]);
      this.corners.setComponent(i, v, box[across][v]);
    });
    this.corners.needsUpdate = true;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.removeFromParent();
  }
}
