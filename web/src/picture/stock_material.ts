/**
 * How the part is drawn. Its surface is lit from over the left shoulder of who looks at it; pockets lie in shade; the colour of a
 * place is that of the motion that cut it, from a table that is filled anew when the scheme of colours changes. Where a section
 * is laid through it what is in front of the plane is left out. Where then the inner side of the closed body is the nearest that
 * is seen, the line of sight has come into the material through the plane: those pixels are marked, and the plane is drawn on
 * them as the cut face.
 */
import {
  AlwaysDepth,
  AlwaysStencilFunc,
  BackSide,
  Color,
  DataTexture,
  DoubleSide,
  EqualStencilFunc,
  FrontSide,
  GLSL3,
  NearestFilter,
  LinearFilter,
  RawShaderMaterial,
  RedFormat,
  RedIntegerFormat,
  ReplaceStencilOp,
  type Texture,
  UnsignedByteType,
  UnsignedShortType,
  Vector2,
  Vector3,
  Vector4,
} from 'three';
import { AMBIENT_SIZE } from '../logic/stock/ambient';

/** Motions of the table: its texture is a square. */
export const TABLE_SIDE = 256;

const vertex = /* glsl */ `
precision highp float;
precision highp int;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
in vec4 normal;
#ifdef OWNER_OF_VERTEX
in float owner;
flat out int v_owner;
#endif
out vec3 place;
out vec3 place_seen;
out vec3 upright;
out vec3 seen;
void main() {
  vec4 at = modelViewMatrix * vec4(position, 1.0);
  place = position;
  place_seen = at.xyz;
  upright = normal.xyz;
  seen = mat3(modelViewMatrix) * normal.xyz;
#ifdef OWNER_OF_VERTEX
  v_owner = int(owner + 0.5);
#endif
  gl_Position = projectionMatrix * at;
}`;

const fragment = /* glsl */ `
precision highp float;
precision highp int;
precision highp usampler2D;
uniform sampler2D table;     // of a motion: its colour; how far it hides that of the stock
uniform vec3 stock;
uniform vec4 plane;          // what lies beyond it is left out
uniform vec3 face;
#ifdef OWNER_OF_CELL
uniform usampler2D owners;
uniform sampler2D ambient;   // mean heights around a place
uniform vec3 corner, far;
uniform vec2 cell;
#endif
#ifdef OWNER_OF_VERTEX
flat in int v_owner;
#endif
in vec3 place;
in vec3 place_seen;
in vec3 upright;
in vec3 seen;
out vec4 pixel;

const vec3 KEY = vec3(-0.42, 0.56, 0.71);
const vec3 FILL = vec3(0.80, 0.05, 0.60);
const vec3 HALF = vec3(-0.227, 0.303, 0.925);

vec4 entry(int motion) {
  return texelFetch(table, ivec2(motion % ${TABLE_SIDE}, motion / ${TABLE_SIDE}), 0);
}

#ifdef OWNER_OF_CELL
/** On the bottom or on a side of the part. */
bool is_outside() {
  vec2 gap = min(place.xy - corner.xy, far.xy - place.xy) / cell;
  return upright.z < -0.5 || (abs(upright.z) < 0.5 && min(gap.x, gap.y) < 0.02);
}
#endif

vec4 cut() {
#ifdef OWNER_OF_CELL
  if (is_outside()) return vec4(0.0);
  // A wall belongs to what was cut at its foot.
  ivec2 last = textureSize(owners, 0) - 1;
  vec2 at = (place.xy + upright.xy * 0.6 * cell - corner.xy) / cell;
  uint motion = texelFetch(owners, clamp(ivec2(floor(at)), ivec2(0), last), 0).r;
  return motion == 0u ? vec4(0.0) : entry(int(motion));
#elif defined(OWNER_OF_VERTEX)
  return v_owner == 0 ? vec4(0.0) : entry(v_owner);
#else
  return vec4(0.0);
#endif
}

float shade() {
#ifdef OWNER_OF_CELL
  if (is_outside()) return 1.0;
  vec2 at = (place.xy - corner.xy) / (far.xy - corner.xy);
  float mean = texture(ambient, at).r * (far.z - corner.z) + corner.z;
  float below = (mean - place.z) / (0.06 * length(far.xy - corner.xy));
  return 1.0 - 0.42 * clamp(below, 0.0, 1.0) + 0.05 * clamp(-below, 0.0, 1.0);
#else
  return 1.0;
#endif
}

void main() {
#ifdef SECTION
  if (dot(plane.xyz, place) > plane.w) discard;
#endif
#ifdef CUT_FACE
  pixel = vec4(face, 1.0);      // the plane is drawn over it
#else
  vec3 n = normalize(seen);
  vec4 motion = cut();
  vec3 colour = mix(stock, motion.rgb, motion.a);
  float key = max(dot(n, KEY), 0.0);
  float fill = max(dot(n, FILL), 0.0);
  float light = 0.38 + 0.08 * n.y + 0.56 * key + 0.20 * fill;
  float gleam = max(dot(n, HALF), 0.0);
  gleam *= gleam;
  gleam *= gleam;
  gleam *= gleam;
  gleam *= gleam;
  gleam *= gleam;
  float aslant = 1.0 - clamp(n.z, 0.0, 1.0);
  float rim = 1.0 - 0.22 * aslant * aslant * aslant;
  pixel = vec4((colour * light * rim + 0.22 * gleam) * shade(), 1.0);
#endif
}`;

const plane_vertex = /* glsl */ `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;
const plane_fragment = /* glsl */ `
precision highp float;
uniform vec3 face, hatch;
out vec4 pixel;
void main() {
  float line = abs(mod(gl_FragCoord.x + gl_FragCoord.y, 12.0) - 6.0);
  pixel = vec4(mix(hatch, face, smoothstep(0.5, 1.3, line)), 1.0);
}`;

const line_vertex = /* glsl */ `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
out vec3 place;
void main() {
  place = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;
const line_fragment = /* glsl */ `
precision highp float;
uniform vec4 plane;
uniform vec3 colour;
in vec3 place;
out vec4 pixel;
void main() {
#ifdef SECTION
  if (dot(plane.xyz, place) > plane.w) discard;
#endif
  pixel = vec4(colour, 0.62);
}`;

export type OwnerOf = 'cell' | 'vertex' | 'nobody';
export interface SurfaceColours {
  stock: string;
  face: string;
  hatch: string;
  edge: string;
}

const rgb = (colour: string): Vector3 => {
  const c = new Color().setStyle(colour, '');
  return new Vector3(c.r, c.g, c.b);
};

/** Materials of one body, and what they share. */
export class StockMaterials {
  readonly surface: RawShaderMaterial;
  readonly cut_face: RawShaderMaterial;
  /** Of a plane where the section lies. */
  readonly plane_face: RawShaderMaterial;
  readonly lines: RawShaderMaterial;
  private readonly plane = { value: new Vector4(0, 0, 1, 0) };
  private readonly looks = {
    stock: { value: new Vector3(0.7, 0.7, 0.7) },
    face: { value: new Vector3() },
    hatch: { value: new Vector3() },
  };
  private readonly edge = { value: new Vector3() };
  readonly field = {
    owners: { value: null as Texture | null },
    ambient: { value: null as Texture | null },
    corner: { value: new Vector3() },
    far: { value: new Vector3(1, 1, 1) },
    cell: { value: new Vector2(1, 1) },
  };

  constructor(
    table: Texture,
    readonly owner_of: OwnerOf,
  ) {
    const uniforms = { table: { value: table }, plane: this.plane, ...this.looks, ...this.field };
    const make = (defines: Record<string, number>, side: typeof FrontSide | typeof BackSide) =>
      new RawShaderMaterial({
        glslVersion: GLSL3,
        vertexShader: vertex,
        fragmentShader: fragment,
        uniforms,
        defines,
        side,
        polygonOffset: true,
        polygonOffsetFactor: 1,
        polygonOffsetUnits: 1,
        stencilWrite: true,
        stencilFunc: AlwaysStencilFunc,
        stencilRef: side === BackSide ? 1 : 0,
        stencilZPass: ReplaceStencilOp,
      });
    const owner: Record<string, number> =
      owner_of === 'cell'
        ? { OWNER_OF_CELL: 1 }
        : owner_of === 'vertex'
          ? { OWNER_OF_VERTEX: 1 }
          : {};
    this.surface = make({ ...owner }, FrontSide);
    this.cut_face = make({ ...owner, SECTION: 1, CUT_FACE: 1 }, BackSide);
    this.cut_face.visible = false;
    this.plane_face = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: plane_vertex,
      fragmentShader: plane_fragment,
      uniforms: this.looks,
      side: DoubleSide,
      depthFunc: AlwaysDepth,
      stencilWrite: true,
      stencilFunc: EqualStencilFunc,
      stencilRef: 1,
    });
    this.lines = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: line_vertex,
      fragmentShader: line_fragment,
      uniforms: { plane: this.plane, colour: this.edge },
      transparent: true,
      depthWrite: false,
    });
  }

  set_colours(colours: SurfaceColours): void {
    this.looks.stock.value.copy(rgb(colours.stock));
    this.looks.face.value.copy(rgb(colours.face));
    this.looks.hatch.value.copy(rgb(colours.hatch));
    this.edge.value.copy(rgb(colours.edge));
  }

  /** What lies beyond `at` along the normal is left out; null: nothing is. */
  set_section(normal: [number, number, number] | null, at: number): void {
    if (normal) this.plane.value.set(...normal, at);
    this.cut_face.visible = normal !== null;
    for (const material of [this.surface, this.lines]) {
      if ('SECTION' in material.defines === (normal !== null)) continue;
      if (normal) material.defines.SECTION = 1;
      else delete material.defines.SECTION;
      material.needsUpdate = true;
    }
  }

  dispose(): void {
    for (const material of [this.surface, this.cut_face, this.plane_face, this.lines])
      material.dispose();
  }
}

/** The colours of motions, 256 a row: three of the colour, one of how far it hides that of the stock. */
export function colour_table(): DataTexture {
  const texture = new DataTexture(
    new Uint8Array(4 * TABLE_SIDE * TABLE_SIDE),
    TABLE_SIDE,
    TABLE_SIDE,
  );
  texture.magFilter = texture.minFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

export function owner_texture(
  owners: Uint16Array<ArrayBuffer>,
  nx: number,
  ny: number,
): DataTexture {
  const texture = new DataTexture(owners, nx, ny, RedIntegerFormat, UnsignedShortType);
  texture.internalFormat = 'R16UI';
  texture.magFilter = texture.minFilter = NearestFilter;
  texture.unpackAlignment = 2;
  texture.needsUpdate = true;
  return texture;
}

export function ambient_texture(): DataTexture {
  const n = AMBIENT_SIZE;
  const texture = new DataTexture(
    new Uint8Array(n * n).fill(255),
    n,
    n,
    RedFormat,
    UnsignedByteType,
  );
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}
