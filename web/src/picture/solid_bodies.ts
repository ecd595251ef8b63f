/** Parts of triangles that the server has made, and turned parts. */
import {
  BufferAttribute,
  BufferGeometry,
  Group,
  LessEqualDepth,
  Mesh,
  Raycaster,
  ShapeUtils,
  type Texture,
  Vector2,
  Vector3,
} from 'three';
import type { MeshTile, ProfileLoop } from '../logic/stock/stock_frame';
import { octahedral } from '../logic/stock/stock_frame';
import type { Thread } from '../logic/stock/part_store';
import { type OutlinePiece, outline_of, revolved, ring_of } from '../logic/stock/turned_solid';
import type { Body, BodyHit, Section, Vec } from './body';
import { body_meshes, surface_geometry } from './field_body';
import { ORDER, plane_of, SectionPlane } from './section_plane';
import { StockMaterials, type SurfaceColours } from './stock_material';

/** Tiles of triangles, as they come. */
export class MeshBody implements Body {
  readonly group = new Group();
  private readonly materials: StockMaterials;
  private readonly plane: SectionPlane;
  private readonly drawn = new Map<string, Group>();
  private section: Section | null = null;

  constructor(
    private readonly tiles: Map<string, MeshTile>,
    private readonly changed: Set<string>,
    table: Texture,
    private readonly box: { low: number[]; high: number[] },
  ) {
    this.materials = new StockMaterials(table, 'vertex');
    this.plane = new SectionPlane(this.materials);
    this.group.add(this.plane.mesh);
    for (const key of tiles.keys()) changed.add(key);
  }

  update(most_ms: number): boolean {
    const began = performance.now();
    for (const key of this.changed) {
      this.changed.delete(key);
      forget(this.drawn.get(key));
      this.drawn.delete(key);
      const tile = this.tiles.get(key);
      if (tile) this.put(key, tile);
      if (performance.now() - began > most_ms) break;
    }
    return this.changed.size === 0;
  }
  set_colours(colours: SurfaceColours): void {
    this.materials.set_colours(colours);
  }
  set_section(section: Section | null): void {
    this.section = section;
    const plane = section && plane_of(section);
    this.materials.set_section(plane?.normal ?? null, plane?.at ?? 0);
    this.plane.set(section, this.box.low, this.box.high);
  }

  hit(from: Vec, way: Vec): BodyHit | null {
    const hits = hits_of(this.group, from, way);
    const plane = this.section && plane_of(this.section);
    const found = hits.find(
      ({ at }) =>
        !plane || at.reduce((sum, v, i) => sum + v * plane.normal[i], 0) <= plane.at + 1e-6,
    );
    return found ?? null;
  }

  dispose(): void {
    for (const group of this.drawn.values()) forget(group);
    this.plane.dispose();
    this.materials.dispose();
    this.group.removeFromParent();
  }

  private put(key: string, { position, normal, origin, scale, owner, index }: MeshTile): void {
    const count = owner.length;
    const places = new Float32Array(3 * count);
    const normals = new Int8Array(4 * count);
    for (let v = 0; v < count; v++) {
      const [x, y, z] = octahedral(normal[2 * v], normal[2 * v + 1]);
      normals.set([127 * x, 127 * y, 127 * z], 4 * v);
      for (let i = 0; i < 3; i++) places[3 * v + i] = origin[i] + scale * position[3 * v + i];
    }
    const geometry = surface_geometry(places, normals, index);
    geometry.setAttribute('owner', new BufferAttribute(owner, 1));
    const group = new Group();
    const [outside, inside] = body_meshes(geometry, new BufferGeometry(), this.materials);
    group.add(outside, inside);
    this.drawn.set(key, group);
    this.group.add(group);
  }
}

/** A half section turned about its axis, with a sector cut out. */
export class TurnedBody implements Body {
  readonly group = new Group();
  private readonly materials: StockMaterials;
  private readonly solid = new Group();
  private faces: Mesh[] = [];
  private open_rad = Math.PI / 2;
  private built: ProfileLoop[] | null = null;
  private outline: OutlinePiece[][] = [];

  constructor(
    private readonly shape: { loops: ProfileLoop[] },
    table: Texture,
    private readonly threads: () => readonly Thread[],
  ) {
    this.materials = new StockMaterials(table, 'nobody');
    this.materials.plane_face.stencilWrite = false;
    this.materials.plane_face.depthFunc = LessEqualDepth;
    this.group.add(this.solid);
  }

  update(): boolean {
    if (this.built === this.shape.loops) return true;
    this.built = this.shape.loops;
    this.outline = outline_of(this.built);
    this.build();
    return true;
  }
  set_colours(colours: SurfaceColours): void {
    this.materials.set_colours(colours);
  }
  /** The sector is as large as the section lies far: 0 to 180 degrees. */
  set_section(section: Section | null): void {
    const open_rad = section ? (Math.min(180, Math.max(0, section.at)) * Math.PI) / 180 : 0;
    if (open_rad === this.open_rad) return;
    this.open_rad = open_rad;
    this.build();
  }

  hit(from: Vec, way: Vec): BodyHit | null {
    return hits_of(this.group, from, way)[0] ?? null;
  }

  dispose(): void {
    forget(this.solid);
    for (const face of this.faces) face.geometry.dispose();
    this.materials.dispose();
    this.group.removeFromParent();
  }

  private build(): void {
    forget(this.solid);
    for (const face of this.faces) face.geometry.dispose();
    this.solid.clear();
    this.group.add(this.solid);
    const { positions, normals, indices, lines } = revolved(
      this.outline,
      this.open_rad,
      this.threads(),
    );
    const edges = new BufferGeometry();
    edges.setAttribute('position', new BufferAttribute(lines, 3));
    const geometry = surface_geometry(positions, normals, indices);
    edges.boundingSphere = geometry.boundingSphere;
    const [outside, , line] = body_meshes(geometry, edges, this.materials);
    this.faces = this.open_rad > 0 ? [this.face(0), this.face(this.open_rad)] : [];
    this.solid.add(outside, line, ...this.faces);
  }

  /** The half section in the plane of an angle. */
  private face(angle: number): Mesh {
    const rings = this.outline.map(ring_of).filter((ring) => ring.length > 2);
    const points = rings.map((ring) => ring.map(([z, rho]) => new Vector2(z, rho)));
    const outer = points.filter((ring) => !ShapeUtils.isClockWise(ring));
    const holes = points.filter((ring) => ShapeUtils.isClockWise(ring));
    const places: number[] = [];
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    for (const ring of outer) {
      const inside = holes.filter((hole) => is_in(hole[0], ring));
      const all = [ring, ...inside].flat();
      for (const triangle of ShapeUtils.triangulateShape(ring, inside))
        for (const i of triangle) places.push(all[i].y * c, all[i].y * s, all[i].x);
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(places), 3));
    const mesh = new Mesh(geometry, this.materials.plane_face);
    mesh.renderOrder = ORDER.plane;
    return mesh;
  }
}

function is_in(point: Vector2, ring: Vector2[]): boolean {
  let inside = false;
  ring.forEach((a, i) => {
    const b = ring[(i + 1) % ring.length];
    if (
      a.y > point.y !== b.y > point.y &&
      point.x < a.x + ((point.y - a.y) / (b.y - a.y)) * (b.x - a.x)
    )
      inside = !inside;
  });
  return inside;
}

/** All meetings with surfaces, the nearest first, in the frame of the body. */
function hits_of(group: Group, from: Vec, way: Vec): BodyHit[] {
  const matrix = group.matrixWorld;
  const ray = new Raycaster(
    new Vector3(...from).applyMatrix4(matrix),
    new Vector3(...way).transformDirection(matrix),
  );
  const inverse = matrix.clone().invert();
  return ray
    .intersectObject(group, true)
    .filter(({ object }) => object instanceof Mesh && object.renderOrder !== ORDER.inside)
    .map(({ point, face, object }) => {
      const owners = (object as Mesh).geometry.getAttribute('owner');
      const at = point.applyMatrix4(inverse);
      const n = face?.normal ?? new Vector3(0, 0, 1);
      return {
        at: [at.x, at.y, at.z] as Vec,
        normal: [n.x, n.y, n.z] as Vec,
        owner: owners && face ? owners.getX(face.c) : 0,
      };
    });
}

function forget(root: Group | undefined): void {
  root?.traverse((object) => (object as Mesh).geometry?.dispose());
  root?.removeFromParent();
}
