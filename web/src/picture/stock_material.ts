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
  FloatType,
  FrontSide,
  GLSL3,
  type IUniform,
  NearestFilter,
  LinearFilter,
  RawShaderMaterial,
  RedFormat,
  RedIntegerFormat,
  RGFormat,
  ReplaceStencilOp,
  type Texture,
  UnsignedByteType,
  UnsignedShortType,
  Vector2,
  Vector3,
  Vector4,
} from 'three';
import { deviation_stops } from '../logic/colour_scale';
import { AMBIENT_SIZE } from '../logic/stock/ambient';
import { far_corner, type Grid } from '../logic/stock/height_field';
import { NO_DEVIATION } from '../logic/stock/stock_frame';
import { PIXELS } from './pixels';
import {
  line_fragment,
  line_vertex,
  plane_fragment,
  plane_vertex,
  surface_fragment,
  surface_vertex,
  TABLE_SIDE,
} from './stock_shaders';
import { STUDIO } from './studio';

export type OwnerOf = 'cell' | 'vertex';
export interface SurfaceColours {
  stock: string;
  face: string;
  hatch: string;
  edge: string;
}

type Uniforms = Record<string, IUniform>;
type Defines = Record<string, number>;

/** What the shaders are told of whose colour a place has. */
const DEFINES: Record<OwnerOf, Defines> = {
  cell: { OWNER_OF_CELL: 1 },
  vertex: { OWNER_OF_VERTEX: 1 },
};

/** Pushed back a little, so that edges lie before it; marks in the stencil whether its inner side is seen. */
const body_material = (uniforms: Uniforms, defines: Defines, is_inside: boolean) =>
  new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: surface_vertex,
    fragmentShader: surface_fragment,
    uniforms,
    defines,
    side: is_inside ? BackSide : FrontSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    stencilWrite: true,
    stencilFunc: AlwaysStencilFunc,
    stencilRef: is_inside ? 1 : 0,
    stencilZPass: ReplaceStencilOp,
  });

const surface_material = (uniforms: Uniforms, defines: Defines): RawShaderMaterial =>
  body_material(uniforms, { ...defines }, false);

function inside_material(uniforms: Uniforms, defines: Defines): RawShaderMaterial {
  const material = body_material(uniforms, { ...defines, SECTION: 1, CUT_FACE: 1 }, true);
  material.visible = false;
  return material;
}

/** Where the stencil says so, whatever lies before it. */
const plane_material = (uniforms: Uniforms): RawShaderMaterial =>
  new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: plane_vertex,
    fragmentShader: plane_fragment,
    uniforms,
    side: DoubleSide,
    depthFunc: AlwaysDepth,
    stencilWrite: true,
    stencilFunc: EqualStencilFunc,
    stencilRef: 1,
  });

const line_material = (uniforms: Uniforms): RawShaderMaterial =>
  new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: line_vertex,
    fragmentShader: line_fragment,
    uniforms,
    transparent: true,
    depthWrite: false,
  });

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
    pixels: PIXELS,
    stock: { value: new Vector3(0.7, 0.7, 0.7) },
    face: { value: new Vector3() },
    hatch: { value: new Vector3() },
  };
  private readonly edge = { value: new Vector3() };
  private readonly most = { value: 0 };
  private readonly field = {
    owners: { value: null as Texture | null },
    ambient: { value: null as Texture | null },
    deviations: { value: null as Texture | null },
    corner: { value: new Vector3() },
    far: { value: new Vector3(1, 1, 1) },
    cell: { value: new Vector2(1, 1) },
  };

  constructor(
    table: Texture,
    readonly owner_of: OwnerOf,
  ) {
    const scale = { value: deviation_stops().map((rgb) => new Vector3(...rgb)) };
    const of_places = { table: { value: table }, most: this.most, scale };
    const of_body = { plane: this.plane, ...this.looks, ...this.field };
    const uniforms = { studio: STUDIO, ...of_places, ...of_body };
    this.surface = surface_material(uniforms, DEFINES[owner_of]);
    this.cut_face = inside_material(uniforms, DEFINES[owner_of]);
    this.plane_face = plane_material(this.looks);
    this.lines = line_material({ plane: this.plane, colour: this.edge });
  }

  set_colours(colours: SurfaceColours): void {
    this.looks.stock.value.copy(rgb(colours.stock));
    this.looks.face.value.copy(rgb(colours.face));
    this.looks.hatch.value.copy(rgb(colours.hatch));
    this.edge.value.copy(rgb(colours.edge));
  }

  /** Colours of places by their deviation, on a scale to so many millimetres; 0: by the motions that cut them. */
  set_deviation(most_mm: number): void {
    this.most.value = most_mm;
  }
  set_deviations(deviations: Texture): void {
    this.field.deviations.value = deviations;
  }

  /** Of a height field: whose colour its cells have, and how much shade. */
  set_field(grid: Grid, owners: Texture, ambient: Texture): void {
    this.field.owners.value = owners;
    this.field.ambient.value = ambient;
    this.field.deviations.value = no_deviations();
    this.field.corner.value.set(...grid.corner);
    this.field.far.value.set(...far_corner(grid));
    this.field.cell.value.set(...grid.cell);
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
  const bytes = new Uint8Array(4 * TABLE_SIDE * TABLE_SIDE);
  return ready(new DataTexture(bytes, TABLE_SIDE, TABLE_SIDE), NearestFilter, 4);
}

export function owner_texture(
  owners: Uint16Array<ArrayBuffer>,
  nx: number,
  ny: number,
): DataTexture {
  const texture = new DataTexture(owners, nx, ny, RedIntegerFormat, UnsignedShortType);
  texture.internalFormat = 'R16UI';
  return ready(texture, NearestFilter, 2);
}

export function ambient_texture(): DataTexture {
  const n = AMBIENT_SIZE;
  const light = new Uint8Array(2 * n * n).fill(255);
  return ready(new DataTexture(light, n, n, RGFormat, UnsignedByteType), LinearFilter, 2);
}

/** Of each column, as deviations_of() has it. */
export const deviation_texture = (
  values: Float32Array<ArrayBuffer>,
  nx: number,
  ny: number,
): DataTexture => ready(new DataTexture(values, nx, ny, RedFormat, FloatType), NearestFilter, 4);

const no_deviations = (): DataTexture => deviation_texture(new Float32Array([NO_DEVIATION]), 1, 1);

function ready(
  texture: DataTexture,
  filter: typeof NearestFilter | typeof LinearFilter,
  bytes_a_texel: 1 | 2 | 4,
): DataTexture {
  texture.magFilter = texture.minFilter = filter;
  texture.unpackAlignment = bytes_a_texel;
  texture.needsUpdate = true;
  return texture;
}
