/**
 * How the part is lit: from over the left shoulder of who looks at it, pockets in shade, each place in the colour of the motion
 * that cut it. stock_material.ts says what is drawn with which of these.
 */

import { studio_glsl } from './studio';
import { NO_DEVIATION } from '../logic/stock/stock_frame';

/** Motions of the table of colours: its texture is a square. */
export const TABLE_SIDE = 256;

export const surface_vertex = /* glsl */ `
precision highp float;
precision highp int;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
in vec4 normal;
#ifdef OWNER_OF_VERTEX
in float owner, deviation;
flat out int v_owner;
out float v_deviation;
#endif
out vec3 place;
out vec2 on_screen;
out vec3 upright;
out vec3 seen;
void main() {
  vec4 at = modelViewMatrix * vec4(position, 1.0);
  place = position;
  upright = normal.xyz;
  seen = mat3(modelViewMatrix) * normal.xyz;
#ifdef OWNER_OF_VERTEX
  v_owner = int(owner + 0.5);
  v_deviation = deviation;
#endif
  gl_Position = projectionMatrix * at;
  on_screen = gl_Position.xy;
}`;

export const surface_fragment = /* glsl */ `
precision highp float;
precision highp int;
precision highp usampler2D;
uniform sampler2D table;     // of a motion: its colour; how far it hides that of the stock
uniform float most;          // of a deviation: where the scale ends, mm; 0: colours are those of motions
uniform vec3 scale[5];
uniform vec3 stock;
uniform vec4 plane;          // what lies beyond it is left out
uniform vec3 face;
#ifdef OWNER_OF_CELL
uniform usampler2D owners;
uniform sampler2D ambient;   // mean heights around a place
uniform sampler2D deviations;
uniform vec3 corner, far;
uniform vec2 cell;
#endif
#ifdef OWNER_OF_VERTEX
flat in int v_owner;
in float v_deviation;
#endif
in vec3 place;
in vec2 on_screen;
in vec3 upright;
in vec3 seen;
out vec4 pixel;

${studio_glsl}

vec4 entry(int motion) {
  return texelFetch(table, ivec2(motion % ${TABLE_SIDE}, motion / ${TABLE_SIDE}), 0);
}

vec4 on_scale(float deviation) {
  if (deviation < ${NO_DEVIATION / 2}.0) return vec4(0.0);
  float at = clamp(0.5 + 0.5 * deviation / most, 0.0, 1.0) * 4.0;
  int below = int(min(3.0, floor(at)));
  return vec4(mix(scale[below], scale[below + 1], at - float(below)), 0.92);
}

vec4 look_of(int motion, float deviation) {
  if (most > 0.0) return on_scale(deviation);
  return motion == 0 ? vec4(0.0) : entry(motion);
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
  vec2 at = (place.xy + upright.xy * 0.85 * cell - corner.xy) / cell;
  ivec2 column = clamp(ivec2(floor(at)), ivec2(0), last);
  float deviation = most > 0.0 ? texelFetch(deviations, column, 0).r : 0.0;
  return look_of(int(texelFetch(owners, column, 0).r), deviation);
#else
  return look_of(v_owner, v_deviation);
#endif
}

/** How much of the light comes to the place: 1 all of it, above 1 to what stands out. */
float open() {
#ifdef OWNER_OF_CELL
  if (is_outside()) return 1.0;
  vec2 at = (place.xy - corner.xy) / (far.xy - corner.xy);
  vec2 below = (texture(ambient, at).rg * (far.z - corner.z) + corner.z - place.z) / length(far.xy - corner.xy);
  vec2 deep = clamp(below / vec2(0.06, 0.018), -1.0, 1.0);
  vec2 shade = max(deep, 0.0);
  vec2 high = max(-deep, 0.0);
  return 1.0 - 0.34 * shade.x - 0.3 * shade.y + 0.03 * high.x + 0.05 * high.y;
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
  vec4 motion = cut();
  pixel = vec4(lit(mix(stock, motion.rgb, motion.a), normalize(seen), on_screen, open(), 0.55), 1.0);
#endif
}`;

export const plane_vertex = /* glsl */ `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;
export const plane_fragment = /* glsl */ `
precision highp float;
uniform vec3 face, hatch;
uniform float pixels;
out vec4 pixel;
void main() {
  float line = abs(mod((gl_FragCoord.x + gl_FragCoord.y) / pixels, 12.0) - 6.0);
  pixel = vec4(mix(hatch, face, smoothstep(0.5, 1.3, line)), 1.0);
}`;

export const line_vertex = /* glsl */ `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
out vec3 place;
void main() {
  place = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;
export const line_fragment = /* glsl */ `
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
