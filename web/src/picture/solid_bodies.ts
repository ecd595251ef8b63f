/** Parts of triangles that the server has made, and turned parts. */
import {
  BufferAttribute,
  BufferGeometry,
  Group,
  type Intersection,
  LessEqualDepth,
  type Matrix4,
  Mesh,
  Raycaster,
  ShapeUtils,
  type Texture,
  Vector2,
  Vector3,
} from 'three';
import type { MeshTile, ProfileLoop } from '../logic/stock/stock_frame';
import { NO_DEVIATION, octahedral } from '../logic/stock/stock_frame';
import type { Thread } from '../logic/stock/part_store';
import {
  type OutlinePiece,
  is_in_ring,
  outline_of,
  revolved,
  ring_of,
} from '../logic/stock/turned_solid';
import type { Body, BodyHit, Section, Vec } from './body';
import { body_meshes, line_geometry, surface_geometry, take_some } from './field_body';
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
    return take_some(this.changed, most_ms, (key) => {
      forget(this.drawn.get(key));
      this.drawn.delete(key);
      const tile = this.tiles.get(key);
      if (tile) this.put(key, tile);
    });
  }
  set_colours(colours: SurfaceColours): void {
    this.materials.set_colours(colours);
  }
  set_deviation(most_mm: number): void {
    this.materials.set_deviation(most_mm);
  }
  set_section(section: Section | null): void {
    this.section = section;
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

  private put(key: string, tile: MeshTile): void {
    const [places, normals] = unpacked(tile);
    const geometry = surface_geometry(places, normals, tile.index);
    set_facts(geometry, tile.owner, tile.deviation);
    const group = new Group();
    const [outside, inside] = body_meshes(geometry, new BufferGeometry(), this.materials);
    group.add(outside, inside);
    this.drawn.set(key, group);
    this.group.add(group);
  }
}

/** Of each vertex: who has cut there, and how far off it is. */
function set_facts(geometry: BufferGeometry, owners: Uint16Array, deviations?: Float32Array): void {
  const known = deviations ?? new Float32Array(owners.length).fill(NO_DEVIATION);
  geometry.setAttribute('owner', new BufferAttribute(owners, 1));
  geometry.setAttribute('deviation', new BufferAttribute(known, 1));
}

/** Places and normals as the triangles need them. */
function unpacked({ position, normal, origin, scale, owner }: MeshTile): [Float32Array, Int8Array] {
  const places = Float32Array.from(position, (value, i) => origin[i % 3] + scale * value);
  const normals = new Int8Array(4 * owner.length);
  for (let v = 0; v < owner.length; v++) {
    const [x, y, z] = octahedral(normal[2 * v], normal[2 * v + 1]);
    normals.set([127 * x, 127 * y, 127 * z], 4 * v);
  }
  return [places, normals];
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
    this.materials = new StockMaterials(table, 'vertex');
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
  set_deviation(most_mm: number): void {
    this.materials.set_deviation(most_mm);
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
    const solid = revolved(this.outline, this.open_rad, this.threads());
    const geometry = surface_geometry(solid.positions, solid.normals, solid.indices);
    set_facts(geometry, solid.owners, solid.deviations);
    const edges = line_geometry(solid.lines, geometry.boundingSphere);
    const [outside, , line] = body_meshes(geometry, edges, this.materials);
    this.faces = this.open_rad > 0 ? [this.face(0), this.face(this.open_rad)] : [];
    this.solid.add(outside, line, ...this.faces);
  }

  /** The half section in the plane of an angle. */
  private face(angle: number): Mesh {
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const places = half_section(this.outline).flatMap(({ x: z, y: rho }) => [rho * c, rho * s, z]);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(places), 3));
    const mesh = new Mesh(geometry, this.materials.plane_face);
    mesh.renderOrder = ORDER.plane;
    return mesh;
  }
}

/** Corners of its triangles. */
function half_section(outline: readonly OutlinePiece[][]): Vector2[] {
  const rings = outline.map(ring_of).filter((ring) => ring.length > 2);
  const is_hole = (ring: Ring): boolean => ShapeUtils.isClockWise(vectors(ring));
  const holes = rings.filter(is_hole);
  return rings
    .filter((ring) => !is_hole(ring))
    .flatMap((ring) =>
      filled(
        ring,
        holes.filter(([first]) => is_in_ring(first, ring)),
      ),
    );
}

type Ring = [z: number, rho: number][];
const vectors = (ring: Ring): Vector2[] => ring.map(([z, rho]) => new Vector2(z, rho));

/** As triangles, corner by corner. */
function filled(ring: Ring, holes: Ring[]): Vector2[] {
  const [outer, ...inner] = [ring, ...holes].map(vectors);
  const all = [outer, ...inner].flat();
  return ShapeUtils.triangulateShape(outer, inner)
    .flat()
    .map((i) => all[i]);
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
    .map((meeting) => body_hit(meeting, inverse));
}

function body_hit({ point, face, object }: Intersection, into_body: Matrix4): BodyHit {
  const of_vertex = (name: string, otherwise: number): number =>
    (face && (object as Mesh).geometry.getAttribute(name)?.getX(face.c)) ?? otherwise;
  return {
    at: point.applyMatrix4(into_body).toArray(),
    normal: (face?.normal ?? new Vector3(0, 0, 1)).toArray(),
    owner: of_vertex('owner', 0),
    deviation: of_vertex('deviation', NO_DEVIATION),
  };
}

function forget(root: Group | undefined): void {
  root?.traverse((object) => (object as Mesh).geometry?.dispose());
  root?.removeFromParent();
}
