/**
 * A run of segments as one mesh: an index buffer that all meshes share, and a texture with two texels a vertex. A quad needs
 * four vertices; fetched from a texture they cost eight floats a segment and no attribute is repeated. (Instancing a quad
 * would need less, but its tiny instances starve GPUs, and software renderers draw them one by one.)
 */
import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  FloatType,
  Mesh,
  RGBAFormat,
  Sphere,
  Vector3,
} from 'three';
import type { Box } from '../logic/box';
import type { Chunk } from '../logic/chunk';
import { BLOCK } from '../logic/path_store';
import { type PathMaterial, TEXTURE_WIDTH } from './path_material';

const FLOATS = 8;
const QUADS = new BufferAttribute(quad_indices(BLOCK), 1);

function quad_indices(count: number): Uint16Array | Uint32Array {
  const indices = new Uint32Array(6 * count);
  for (let i = 0; i < count; i++)
    indices.set(
      [0, 1, 2, 2, 1, 3].map((corner) => 4 * i + corner),
      6 * i,
    );
  return indices;
}

/** `vertices` of the chunk in their order; `start`: vertices of the path before the chunk. */
export function path_mesh(
  chunk: Chunk,
  vertices: Uint32Array,
  box: Box,
  start: number,
  material: PathMaterial,
): Mesh {
  const texture = texture_of(chunk, vertices);
  const mesh = new Mesh(quads(vertices.length - 1, box), material);
  mesh.matrixAutoUpdate = false;
  mesh.userData = { texture };
  mesh.onBeforeRender = () => {
    material.uniforms.path.value = texture;
    material.uniforms.chunk_start.value = start;
    material.uniformsNeedUpdate = true;
  };
  return mesh;
}

function quads(count: number, box: Box): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setIndex(QUADS);
  geometry.setDrawRange(0, 6 * count);
  geometry.boundingSphere = sphere_of(box);
  return geometry;
}

export function dispose_path_mesh(mesh: Mesh): void {
  (mesh.userData.texture as DataTexture).dispose();
  mesh.geometry.dispose();
}

function texture_of(chunk: Chunk, vertices: Uint32Array): DataTexture {
  const rows = Math.ceil((2 * vertices.length) / TEXTURE_WIDTH);
  const values = new Float32Array(4 * TEXTURE_WIDTH * rows);
  vertices.forEach((vertex, i) => put_vertex(values, FLOATS * i, chunk, vertex));
  const texture = new DataTexture(values, TEXTURE_WIDTH, rows, RGBAFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}

function put_vertex(values: Float32Array, at: number, chunk: Chunk, v: number): void {
  values[at] = chunk.xyz[3 * v];
  values[at + 1] = chunk.xyz[3 * v + 1];
  values[at + 2] = chunk.xyz[3 * v + 2];
  values[at + 3] = v;
  values[at + 4] = chunk.feed_mm_min[v];
  values[at + 5] = chunk.speed_mm_min[v];
  values[at + 6] = chunk.kind[v] | (chunk.tool[v] << 3) | (chunk.power_percent[v] << 11);
}

function sphere_of(box: Box): Sphere {
  const low = new Vector3(...box.min);
  const high = new Vector3(...box.max);
  const centre = low.clone().add(high).multiplyScalar(0.5);
  return new Sphere(centre, centre.distanceTo(high) + 1e-3);
}
