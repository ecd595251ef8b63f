/** A height field as a body: a mesh a tile, made anew where columns have changed. */
import {
  BufferAttribute,
  BufferGeometry,
  type DataTexture,
  Group,
  LineSegments,
  Mesh,
  Sphere,
  type Texture,
  Vector3,
} from 'three';
import { mean_heights } from '../logic/stock/ambient';
import type { HeightField } from '../logic/stock/height_field';
import { HeightMesher, type TileMesh } from '../logic/stock/height_mesh';
import { MeshArrays } from '../logic/stock/mesh_arrays';
import { ORDER } from './section_plane';
import {
  ambient_texture,
  deviation_texture,
  owner_texture,
  StockMaterials,
} from './stock_material';

/** Tiles that were made anew come all at once, so that neighbours fit each other; or after so long. */
const MOST_APART_MS = 250;

/** The shade of pockets may be so old. */
const SHADED_MS = 150;

/** Each mesh costs a call: tiles of so few corners are drawn together. */
const FEW_CORNERS = 300;

interface Drawn {
  group: Group;
  geometry: BufferGeometry;
  lines: BufferGeometry;
}
/** Of few triangles: its arrays, which become part of one mesh. */
type Tile = Drawn | TileMesh;
const is_drawn = (tile: Tile | undefined): tile is Drawn => tile !== undefined && 'group' in tile;

export class FieldBody {
  readonly group = new Group();
  readonly materials: StockMaterials;
  private readonly mesher = new HeightMesher();
  private readonly tiles = new Map<number, Tile>();
  private readonly made_anew = new Map<number, Tile>();
  private since = 0;
  /** All tiles of few triangles. */
  private together: Drawn | null = null;
  /** All tiles have been there. */
  is_whole = false;
  private readonly owners: DataTexture | null = null;
  private readonly ambient: DataTexture | null = null;
  private deviations: DataTexture | null = null;

  /** `looks_of`: another one of the same part, whose colours and shade it has. */
  constructor(
    readonly field: HeightField,
    table: Texture,
    private readonly looks_of?: FieldBody,
  ) {
    this.materials = looks_of?.materials ?? new StockMaterials(table, 'cell');
    if (looks_of) return;
    const { nx, ny } = field.grid;
    this.owners = owner_texture(field.owners as Uint16Array<ArrayBuffer>, nx, ny);
    this.ambient = ambient_texture();
    this.materials.set_field(field.grid, this.owners, this.ambient);
  }

  /** Brings the tiles up to date, but no longer than that. True: all are. */
  update(most_ms: number): boolean {
    const { changed, tiles_x } = this.field;
    this.looks_of?.update_looks();
    this.update_looks();
    const is_done = take_some(changed, most_ms, (key) =>
      this.make(key, this.mesher.mesh(this.field, key % tiles_x, Math.floor(key / tiles_x))),
    );
    if (is_done || performance.now() - this.since > MOST_APART_MS) this.put_all();
    this.is_whole ||= is_done;
    return is_done;
  }

  private shaded = -1;
  private shaded_at = -Infinity;
  private update_looks(): void {
    const { field } = this;
    if (this.owners && field.repainted.size) {
      field.repainted.clear();
      this.owners.needsUpdate = true;
      this.update_deviations();
    }
    const now = performance.now();
    if (this.ambient && this.shaded !== field.version && now - this.shaded_at > SHADED_MS) {
      this.shaded = field.version;
      this.shaded_at = now;
      this.ambient.image.data = mean_heights(field);
      this.ambient.needsUpdate = true;
    }
  }

  private update_deviations(): void {
    const { deviation, grid } = this.field;
    if (!deviation) return;
    this.deviations ??= deviation_texture(deviation, grid.nx, grid.ny);
    this.deviations.needsUpdate = true;
    this.materials.set_deviations(this.deviations);
  }

  get triangles(): number {
    let count = 0;
    for (const tile of this.tiles.values())
      count += (is_drawn(tile) ? tile.geometry.index!.count : tile.indices.length) / 3;
    return count;
  }

  dispose(): void {
    for (const tile of [...this.tiles.values(), ...this.made_anew.values()]) forget(tile);
    forget(this.together ?? undefined);
    this.made_anew.clear();
    this.tiles.clear();
    this.owners?.dispose();
    this.ambient?.dispose();
    this.deviations?.dispose();
    if (!this.looks_of) this.materials.dispose();
    this.group.removeFromParent();
  }

  private make(key: number, mesh: TileMesh): void {
    if (!this.made_anew.size) this.since = performance.now();
    forget(this.made_anew.get(key));
    const is_small = mesh.indices.length < FEW_CORNERS;
    this.made_anew.set(key, is_small ? mesh : this.made(mesh));
  }
  private put_all(): void {
    let together = false;
    for (const [key, tile] of this.made_anew) {
      const before = this.tiles.get(key);
      together ||= !is_drawn(tile) || (before !== undefined && !is_drawn(before));
      forget(before);
      this.tiles.set(key, tile);
      if (is_drawn(tile)) this.group.add(tile.group);
    }
    this.made_anew.clear();
    if (together) this.put_together();
  }
  private put_together(): void {
    forget(this.together ?? undefined);
    const small = [...this.tiles.values()].filter((tile): tile is TileMesh => !is_drawn(tile));
    this.together = small.length ? this.made(joined(small)) : null;
    if (this.together) this.group.add(this.together.group);
  }

  private made(mesh: TileMesh): Drawn {
    const geometry = surface_geometry(mesh.positions, mesh.normals, mesh.indices);
    const lines = line_geometry(mesh.lines, geometry.boundingSphere);
    const group = new Group();
    group.add(...body_meshes(geometry, lines, this.materials));
    return { group, geometry, lines };
  }
}

/** Takes from a set what it can in that time. True: all of it. */
export function take_some<T>(keys: Set<T>, most_ms: number, take: (key: T) => void): boolean {
  const began = performance.now();
  for (const key of keys) {
    keys.delete(key);
    take(key);
    if (performance.now() - began > most_ms) break;
  }
  return keys.size === 0;
}

/** A body as it is drawn: outer side, inner side where a section opens it, edges. */
export function body_meshes(
  geometry: BufferGeometry,
  lines: BufferGeometry,
  materials: StockMaterials,
): [Mesh, Mesh, LineSegments] {
  const outside = new Mesh(geometry, materials.surface);
  const inside = new Mesh(geometry, materials.cut_face);
  const edges = new LineSegments(lines, materials.lines);
  outside.renderOrder = ORDER.surface;
  inside.renderOrder = ORDER.inside;
  edges.renderOrder = ORDER.lines;
  // What has nothing costs a call all the same.
  edges.visible = (lines.attributes.position?.count ?? 0) > 0;
  return [outside, inside, edges];
}

export function surface_geometry(
  positions: Float32Array,
  normals: Int8Array,
  indices: Uint32Array | Uint16Array,
): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(normals, 4, true));
  geometry.setIndex(new BufferAttribute(indices, 1));
  geometry.boundingSphere = ball_around(positions);
  return geometry;
}

/** Within the ball of the body whose edges they are. */
export function line_geometry(points: Float32Array, ball: Sphere | null): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(points, 3));
  geometry.boundingSphere = ball;
  return geometry;
}

function ball_around(positions: Float32Array): Sphere {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    const value = positions[i];
    if (value < low[i % 3]) low[i % 3] = value;
    if (value > high[i % 3]) high[i % 3] = value;
  }
  if (!positions.length) return new Sphere(new Vector3(), 0);
  const middle = new Vector3(...low).add(new Vector3(...high)).multiplyScalar(0.5);
  return new Sphere(middle, middle.distanceTo(new Vector3(...high)));
}

/** Several as one. */
function joined(tiles: readonly TileMesh[]): TileMesh {
  const out = new MeshArrays();
  for (const tile of tiles) out.add(tile);
  return out.made();
}

function forget(tile: Tile | undefined): void {
  if (!is_drawn(tile)) return;
  tile.geometry.dispose();
  tile.lines.dispose();
  tile.group.removeFromParent();
}
