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

/** Bodies, their inner sides, the plane, then everything else. */
export const ORDER = { surface: -4, inside: -3, plane: -2, lines: -1 };

export class SectionPlane {
  readonly mesh: Mesh;
  private readonly corners = new BufferAttribute(new Float32Array(12), 3);

  constructor(materials: StockMaterials) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.corners);
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.mesh = new Mesh(geometry, materials.plane_face);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = ORDER.plane;
    this.mesh.visible = false;
  }

  /** Over all of a box; null: there is no section. */
  set(section: Section | null, low: number[], high: number[]): void {
    this.mesh.visible = section !== null;
    if (!section) return;
    const { axis, at } = section;
    const [u, v] = [0, 1, 2].filter((i) => i !== axis);
    [
      [low[u], low[v]],
      [high[u], low[v]],
      [high[u], high[v]],
      [low[u], high[v]],
    ].forEach((place, i) => {
      const corner = [0, 0, 0];
      corner[axis] = at;
      [corner[u], corner[v]] = place;
      this.corners.setXYZ(i, corner[0], corner[1], corner[2]);
    });
    this.corners.needsUpdate = true;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.removeFromParent();
  }
}
