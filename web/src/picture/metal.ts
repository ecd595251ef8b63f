/** What machines, tools and clamps are made of: one colour in the light of the studio. */
import { Color, DoubleSide, FrontSide, GLSL3, RawShaderMaterial, Vector3 } from 'three';
import { STUDIO, studio_glsl } from './studio';

const vertex = /* glsl */ `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform mat3 normalMatrix;
in vec3 position;
in vec3 normal;
out vec3 seen;
out vec2 on_screen;
void main() {
  seen = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  on_screen = gl_Position.xy;
}`;

const fragment = /* glsl */ `
precision highp float;
${studio_glsl}
uniform vec3 colour;
uniform float opacity, polish;
in vec3 seen;
in vec2 on_screen;
out vec4 pixel;
void main() {
  vec3 n = normalize(gl_FrontFacing ? seen : -seen);
  pixel = vec4(lit(colour, n, on_screen, 1.0, polish), opacity);
}`;

interface Looks {
  colour: string;
  /** 0: matt. */
  polish?: number;
  opacity?: number;
  /** Of a thin or an open body. */
  both_sides?: boolean;
}

export function metal({ colour, polish = 0.8, opacity = 1, both_sides }: Looks): RawShaderMaterial {
  const { r, g, b } = new Color().setStyle(colour, '');
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: vertex,
    fragmentShader: fragment,
    uniforms: {
      studio: STUDIO,
      colour: { value: new Vector3(r, g, b) },
      polish: { value: polish },
      opacity: { value: opacity },
    },
    side: both_sides ? DoubleSide : FrontSide,
    transparent: opacity < 1,
    depthWrite: opacity === 1,
    // Where it touches the part it lies behind that.
    polygonOffset: true,
    polygonOffsetFactor: 2,
    polygonOffsetUnits: 2,
  });
}
