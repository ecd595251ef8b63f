/**
 * How a segment of the path is drawn: as a ribbon of some pixels, four vertices that fetch their segment from a texture
 * (path_mesh.ts). Colour comes from the tool or from a scale; what is done is wide and full, what is still to come thin and
 * faint; rapids are thin and dashed; what no machine makes, behind the place where the control stops, is dotted and grey.
 */
import { Color, DoubleSide, GLSL3, RawShaderMaterial, Vector2, Vector3 } from 'three';
import {
  type Colouring,
  type Scheme,
  rapid_colour,
  thread_colour,
  scale_stops,
  tool_colour,
} from '../logic/colour_scale';

export const TEXTURE_WIDTH = 2048;
const TOOL_COLOURS = 8;
const COLOURINGS: Colouring[] = ['tool', 'feed', 'speed', 'power'];

const vertex = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2D;
uniform sampler2D path;      // of vertex i: texel 2i is x y z order, texel 2i + 1 is feed, speed, looks
uniform mat4 modelViewMatrix, projectionMatrix;
uniform vec2 viewport;
uniform int colouring;
uniform vec2 range;
uniform vec3 tools[${TOOL_COLOURS}];
uniform vec3 stops[5];
uniform vec3 rapid, thread, ground;
uniform float mirrored;      // 1: the other half of a turned part, faint and without rapids
uniform float done;          // vertices of the path that are behind the tool; negative: all count as done
uniform float stop;          // vertices up to where the control stops; negative: it does not
uniform float chunk_start;
uniform float show_rapids;
uniform float width;
uniform ivec2 part;         // segments x, x + y, x + 2y … of a mesh are drawn
out vec3 colour;
out vec2 dash;               // place along the segment in pixels; 1: dashed, 2: dotted

vec3 on_scale(float share) {
  float place = clamp(share, 0.0, 1.0) * 4.0;
  int below = int(min(3.0, floor(place)));
  return mix(stops[below], stops[below + 1], place - float(below));
}

vec4 texel(int index) {
  return texelFetch(path, ivec2(index % ${TEXTURE_WIDTH}, index / ${TEXTURE_WIDTH}), 0);
}

vec3 cut_colour(vec2 rates, int looks) {
  int tool = (looks >> 3) & 255;
  if (colouring == 0 && (looks & 7) == 3) return thread;
  if (colouring == 0) return tools[max(tool - 1, 0) % ${TOOL_COLOURS}];
  float power = float(looks >> 11);
  float value = colouring == 1 ? rates.x : colouring == 2 ? rates.y : power;
  return on_scale((value - range.x) / max(range.y - range.x, 1e-6));
}

void main() {
  int segment = gl_VertexID >> 2;
  float side_of = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  float end_of = (gl_VertexID & 2) == 0 ? 0.0 : 1.0;
  vec4 from = texel(2 * segment);
  vec4 to = texel(2 * segment + 2);
  vec4 rates = texel(2 * segment + 3);
  int looks = int(rates.z);
  int kind = looks & 7;
  bool is_rapid = kind == 0;
  bool hidden = kind == 2 || (is_rapid && (show_rapids < 0.5 || mirrored > 0.5)) || segment % part.y != part.x;
  vec4 a = projectionMatrix * modelViewMatrix * vec4(from.xyz, 1.0);
  vec4 b = projectionMatrix * modelViewMatrix * vec4(to.xyz, 1.0);
  vec2 pa = a.xy / a.w * viewport * 0.5;
  vec2 pb = b.xy / b.w * viewport * 0.5;
  vec2 way = pb - pa;
  float length_px = length(way);
  vec2 along = length_px > 1e-4 ? way / length_px : vec2(1.0, 0.0);
  bool behind = done < 0.0 || chunk_start + to.w <= done;
  bool beyond = stop >= 0.0 && chunk_start + to.w > stop;
  behind = behind && !beyond;
  float wide = is_rapid ? 1.1 : behind ? width : width * 0.62;
  vec2 side = vec2(-along.y, along.x) * side_of * wide * 0.5;
  // Half a pixel over both ends closes the joints of a polyline.
  vec2 over = along * (end_of * 2.0 - 1.0) * min(0.35 * wide, 0.5);
  vec4 at = end_of < 0.5 ? a : b;
  at.xy += (side + over) * 2.0 / viewport * at.w;
  at.z += is_rapid ? 1e-5 : behind ? -2e-5 : 0.0;
  gl_Position = hidden ? vec4(2.0, 2.0, 2.0, 1.0) : at;
  vec3 full = is_rapid ? rapid : cut_colour(rates.xy, looks);
  float faint = is_rapid ? 0.5 : 0.42;
  colour = behind ? full : mix(beyond ? rapid : full, ground, faint);
  colour = mix(colour, ground, 0.62 * mirrored);
  dash = vec2(end_of * length_px, beyond ? 2.0 : is_rapid ? 1.0 : 0.0);
}`;

const fragment = /* glsl */ `
precision highp float;
in vec3 colour;
in vec2 dash;
out vec4 pixel;
void main() {
  if (dash.y > 1.5 ? mod(dash.x, 5.0) > 2.0 : dash.y > 0.5 && mod(dash.x, 9.0) > 5.0) discard;
  pixel = vec4(colour, 1.0);
}`;

const vector = (rgb: readonly number[]): Vector3 => new Vector3(rgb[0], rgb[1], rgb[2]);

const uniforms_at_first = () => ({
  path: { value: null },
  viewport: { value: new Vector2(1, 1) },
  colouring: { value: 0 },
  range: { value: new Vector2(0, 1) },
  tools: { value: [] as Vector3[] },
  stops: { value: [] as Vector3[] },
  rapid: { value: new Vector3() },
  thread: { value: new Vector3() },
  mirrored: { value: 0 },
  ground: { value: new Vector3() },
  done: { value: -1 },
  stop: { value: -1 },
  chunk_start: { value: 0 },
  show_rapids: { value: 1 },
  width: { value: 1.8 },
  part: { value: new Vector2(0, 1) },
});

export class PathMaterial extends RawShaderMaterial {
  constructor() {
    super({
      glslVersion: GLSL3,
      vertexShader: vertex,
      fragmentShader: fragment,
      side: DoubleSide,
      uniforms: uniforms_at_first(),
    });
    this.set_scheme('dark', '#101418');
  }

  set_scheme(scheme: Scheme, ground: string): void {
    const tools = Array.from({ length: TOOL_COLOURS }, (_, i) =>
      vector(tool_colour(i + 1, scheme)),
    );
    this.uniforms.tools.value = tools;
    this.uniforms.stops.value = scale_stops(scheme).map(vector);
    this.uniforms.rapid.value = vector(rapid_colour(scheme));
    this.uniforms.thread.value = vector(thread_colour(scheme));
    const colour = new Color().setStyle(ground, '');
    this.uniforms.ground.value = new Vector3(colour.r, colour.g, colour.b);
  }

  /** Of every `one_of` segments the one behind `part` others is drawn. */
  set_part(part: number, one_of: number): void {
    this.uniforms.part.value.set(part, one_of);
  }

  set_mirrored(mirrored: boolean): void {
    this.uniforms.mirrored.value = mirrored ? 1 : 0;
  }

  set_colouring(colouring: Colouring, low: number, high: number): void {
    this.uniforms.colouring.value = COLOURINGS.indexOf(colouring);
    this.uniforms.range.value.set(low, high);
  }
}
