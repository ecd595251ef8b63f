/**
 * The light that part, clamps and tools stand in. It goes with who looks, so that no side of a part is ever black: a key light
 * over the left shoulder, a cooler one from the right, light from above, less from below, and two lamps that shine back from
 * metal. All of it is a picture by the way a place faces, which the shaders look up; so each place costs one look.
 */
import { DataTexture, DataUtils, HalfFloatType, LinearFilter, RGBAFormat } from 'three';

const SIZE = 128;

type Three = readonly [number, number, number];

const KEY: Three = [-0.62, 0.46, 0.635];
const FILL: Three = [0.8, 0.05, 0.6];
const KEY_LIGHT: Three = [0.8, 0.775, 0.74];
const FILL_LIGHT: Three = [0.17, 0.2, 0.25];
const ABOVE: Three = [0.33, 0.355, 0.39];
const BELOW: Three = [0.13, 0.125, 0.12];

const dot = (a: Three, b: Three): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
function step(from: number, to: number, value: number): number {
  const share = Math.min(1, Math.max(0, (value - from) / (to - from)));
  return share * share * (3 - 2 * share);
}
/** 1 between two places, and 0 so far beside them. */
const within = (from: number, to: number, edge: number, value: number): number =>
  step(from - edge, from + edge, value) * (1 - step(to - edge, to + edge, value));

/** What a matt white place sends back that faces so, red, green and blue; 1: as much as comes. */
export function light_at(normal: Three): number[] {
  const up = 0.5 + 0.5 * normal[1];
  const key = Math.max(0, dot(normal, KEY));
  const fill = Math.max(0, dot(normal, FILL));
  return [0, 1, 2].map(
    (i) => BELOW[i] + up * (ABOVE[i] - BELOW[i]) + key * KEY_LIGHT[i] + fill * FILL_LIGHT[i],
  );
}

/** What of both lamps and of the bright room is seen in a polished place that faces so. */
export function gleam_at([x, y, z]: Three): number {
  const [rx, ry] = [2 * z * x, 2 * z * y];
  const lamp = 0.75 * within(-0.95, -0.25, 0.16, rx) * within(0.2, 0.85, 0.16, ry);
  const strip = 0.35 * within(0.6, 0.85, 0.1, rx) * within(-0.35, 0.6, 0.2, ry);
  const rim = 0.3 * (1 - z) ** 3 * (0.5 + 0.5 * y);
  return lamp + strip + rim;
}

/** By x and y of the way that a place faces, -1 to 1: light, and in the fourth number gleam. */
function studio_texture(): DataTexture {
  const values = new Uint16Array(4 * SIZE * SIZE);
  for (let k = 0; k < SIZE * SIZE; k++) {
    const normal = facing(k % SIZE, Math.floor(k / SIZE));
    [...light_at(normal), gleam_at(normal)].forEach(
      (value, i) => (values[4 * k + i] = DataUtils.toHalfFloat(value)),
    );
  }
  const texture = new DataTexture(values, SIZE, SIZE, RGBAFormat, HalfFloatType);
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** Of a texel; beyond the circle what faces sideways. */
function facing(i: number, j: number): Three {
  const [x, y] = [(2 * i + 1) / SIZE - 1, (2 * j + 1) / SIZE - 1];
  const far = Math.max(1, Math.hypot(x, y));
  const [nx, ny] = [x / far, y / far];
  return [nx, ny, Math.sqrt(Math.max(0, 1 - nx * nx - ny * ny))];
}

/** Shared by all materials: the picture never changes. */
export const STUDIO = { value: studio_texture() };

/** `lit`: a colour as it looks, of a place that faces `n` and is so open to the light; all colours as screens have them. */
export const studio_glsl = /* glsl */ `
uniform sampler2D studio;

vec3 linear(vec3 c) {
  return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878);
}
vec3 shown(vec3 c) {
  vec3 s = sqrt(clamp(c, 0.0, 1.0));
  return 0.662002687 * s + 0.684122060 * sqrt(s) - 0.323583601 * sqrt(sqrt(s)) - 0.0225411470 * c;
}
vec3 lit(vec3 colour, vec3 n, vec2 on_screen, float open, float polish) {
  // Who looks stands near: a flat face is not of one tone.
  vec2 at = n.xy + 0.11 * on_screen;
  at /= max(1.0, length(at));
  vec4 light = texture(studio, 0.5 + 0.49 * at);
  vec3 base = linear(colour);
  float gleam = polish * light.a * mix(1.0, open, 0.6);
  return shown(base * light.rgb * open + gleam * mix(vec3(0.5), base, 0.55));
}`;
