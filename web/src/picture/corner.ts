/** What every picture has in a corner: the axes as they lie. */
import { type Camera, type Group, OrthographicCamera, Scene, type WebGLRenderer } from 'three';
import { axes_corner, dispose, type Palette } from './furniture';

const CORNER_PX = 92;
/** Above the tools of the part, which lie along the lower border. */
const BOTTOM_PX = 38;

export class AxesCorner {
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera(-1.7, 1.7, 1.7, -1.7, -10, 10);
  private axes: Group | null = null;

  set_palette(palette: Palette): void {
    dispose(this.axes);
    this.axes = axes_corner(palette);
    this.scene.add(this.axes);
  }

  draw(renderer: WebGLRenderer, eye: Camera, width: number, height: number): void {
    this.camera.quaternion.copy(eye.quaternion);
    this.camera.position.set(0, 0, 0);
    renderer.setViewport(4, BOTTOM_PX, CORNER_PX, CORNER_PX);
    renderer.setScissor(4, BOTTOM_PX, CORNER_PX, CORNER_PX);
    renderer.setScissorTest(true);
    renderer.clearDepth();
    renderer.render(this.scene, this.camera);
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, width, height);
  }
}
