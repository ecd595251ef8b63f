/**
 * When the graphics have really drawn a frame: the browser hands frames over and goes on, and whoever draws without asking fills
 * a queue that the hand on the mouse then waits for.
 */
const LOOK_AGAIN_MS = 3;

/** Calls `drawn` once everything that was handed over so far is drawn. */
export function when_drawn(gl: WebGL2RenderingContext, drawn: () => void): void {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  if (!fence) return void setTimeout(drawn); // the context is lost
  const look = () => {
    if (gl.isContextLost() || gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED) {
      gl.deleteSync(fence);
      drawn();
    } else {
      setTimeout(look, LOOK_AGAIN_MS);
    }
  };
  setTimeout(look);
}
