/** The shadow that the stock lays on what is below it: it shows where the part stands. */
import { Color, GLSL3, Mesh, PlaneGeometry, RawShaderMaterial, Vector2, Vector3 } from 'three';

/** Of the longer side of the stock: so far beside it the shadow ends. */
const REACH = 0.16;
/** Of the height of the stock: so far it falls away from the light. */
const FALLS = 0.35;

const vertex = /* glsl */ `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
out vec2 place;
void main() {
  place = position.xy;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const fragment = /* glsl */ `
precision highp float;
uniform vec2 half_size, shift;
uniform float reach, strength;
uniform vec3 colour;
in vec2 place;
out vec4 pixel;
void main() {
  vec2 beside = max(abs(place - shift) - half_size, 0.0);
  float far = clamp(1.0 - length(beside) / reach, 0.0, 1.0);
  pixel = vec4(colour, strength * far * far * far);
}`;

export function ground_shadow(
  low: number[],
  high: number[],
  colour: string,
  strength: number,
): Mesh {
  const [x, y, z] = high.map((value, i) => value - low[i]);
  const reach = REACH * Math.max(x, y) + 0.5 * z;
  const shift = new Vector2(FALLS * z, -FALLS * z);
  const { r, g, b } = new Color().setStyle(colour, '');
  const uniforms = {
    half_size: { value: new Vector2(x / 2, y / 2) },
    ...{ shift: { value: shift }, reach: { value: reach }, strength: { value: strength } },
    colour: { value: new Vector3(r, g, b) },
  };
  const size = 2 * reach + FALLS * 2 * z;
  const looks = { glslVersion: GLSL3, vertexShader: vertex, fragmentShader: fragment, uniforms };
  const mesh = new Mesh(
    new PlaneGeometry(x + size, y + size),
    new RawShaderMaterial({ ...looks, transparent: true, depthWrite: false }),
  );
  mesh.position.set((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2] + 0.002 * z);
  mesh.renderOrder = -10;
  return mesh;
}
