/** What draws the picture on its canvas. */
import { WebGLRenderer } from 'three';

export function renderer_of(canvas: HTMLCanvasElement, antialias: boolean): WebGLRenderer {
  const renderer = new WebGLRenderer({
    canvas,
    antialias,
    alpha: true,
    stencil: true, // cut faces of the part
    preserveDrawingBuffer: true, // a picture at rest is drawn in slices
    powerPreference: 'high-performance',
  });
  renderer.debug.checkShaderErrors = false; // to ask for them takes as long as they take to be made
  renderer.setClearColor(0, 0);
  renderer.autoClear = false;
  return renderer;
}
