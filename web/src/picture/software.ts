/**
 * Whether the processor draws in place of a graphics card. Then every sample of a pixel costs as much again for each triangle,
 * so edges are smoothed only in a picture at rest: it is drawn in more pixels.
 */
const NAMES = /swiftshader|llvmpipe|softpipe|software|basic render/i;

export const is_software = (renderer: string): boolean => NAMES.test(renderer);

export function draws_by_software(): boolean {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return false;
  const told = gl.getExtension('WEBGL_debug_renderer_info');
  const name = gl.getParameter(told ? told.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return is_software(String(name));
}

/** Of a picture at rest, pixels along a side of each. */
export const SMOOTH_BY = 2;
/** With more segments of the path smooth edges would come too late. */
export const MOST_SMOOTH_SEGMENTS = 100_000;
