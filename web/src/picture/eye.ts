/** From where the picture is seen: a camera without perspective, which a hand turns, moves and zooms. */
import { Matrix4, OrthographicCamera, Quaternion, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { Box } from '../logic/box';
import { ON_THE_TABLE, type Standing, type ViewName } from './views';

const FAR_MM = 1000;
const MARGIN = 1.14;
/** Above and below, in CSS pixels: keys of the picture and of the part stand there. */
const BAR_PX = 50;
/** A low picture keeps so much of its height. */
const LEAST_HEIGHT = 0.7;

export class Eye {
  readonly camera = new OrthographicCamera(-1, 1, 1, -1, -1e5, 1e5);
  private controls: OrbitControls;
  private standing = ON_THE_TABLE;
  private half_height_mm = 100;
  private width = 1;
  private height = 1;

  /** `changed`: what is seen is another view; `by_hand`: somebody has begun to turn it. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly changed: () => void,
    private readonly by_hand: () => void,
  ) {
    this.controls = this.new_controls();
  }

  /** OrbitControls turns about what was up when it was made. */
  private new_controls(): OrbitControls {
    this.camera.up.set(...this.standing.up);
    const controls = new OrbitControls(this.camera, this.canvas);
    controls.enableDamping = false;
    controls.zoomToCursor = true;
    controls.addEventListener('change', this.changed);
    controls.addEventListener('start', this.by_hand);
    return controls;
  }

  /** As a machine stands, from its first view; as it was where it stands so already. */
  stand(standing: Standing): void {
    if (standing === this.standing) return;
    this.standing = standing;
    const target = this.controls.target.clone();
    this.controls.dispose();
    this.controls = this.new_controls();
    this.controls.target.copy(target);
    this.look(standing.first);
  }

  dispose(): void {
    this.controls.dispose();
  }

  /** The window that it looks through, in CSS pixels. */
  resize(width: number, height: number): void {
    this.width = width;
    this.height = height;
    this.frame();
  }

  look(view: ViewName): void {
    const { from, up } = this.standing.views[view];
    const way = new Vector3(...from).normalize().multiplyScalar(FAR_MM);
    this.camera.up.set(...up);
    this.camera.position.copy(this.controls.target).add(way);
    this.camera.lookAt(this.controls.target);
    this.camera.up.set(...this.standing.up);
    // From above what is up in the picture is not what is up.
    if (view === 'top') this.camera.position.sub(new Vector3(...up).multiplyScalar(0.01));
    this.controls.update();
  }

  turn(azimuth_rad: number, polar_rad: number): void {
    const way = this.camera.position.clone().sub(this.controls.target);
    const side = new Vector3().crossVectors(this.camera.up, way).normalize();
    way.applyQuaternion(new Quaternion().setFromAxisAngle(side, polar_rad));
    way.applyQuaternion(new Quaternion().setFromAxisAngle(this.camera.up, azimuth_rad));
    this.camera.position.copy(this.controls.target).add(way);
    this.controls.update();
  }

  zoom(factor: number): void {
    this.camera.zoom *= factor;
    this.camera.updateProjectionMatrix();
  }

  /** All of the box, in the middle and as large as it may be. */
  fit(box: Box): void {
    const centre = new Vector3(...box.min).add(new Vector3(...box.max)).multiplyScalar(0.5);
    const way = this.camera.position.clone().sub(this.controls.target);
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).add(way);
    this.camera.zoom = 1;
    this.camera.updateMatrixWorld();
    this.half_height_mm = this.half_height_for(box);
    this.frame();
    this.controls.update();
  }

  pixel_mm(): number {
    return (2 * this.half_height_mm) / this.camera.zoom / this.height;
  }

  /** From places of the machine to those of the window, -1 to 1. */
  matrix(): number[] {
    const { projectionMatrix, matrixWorldInverse } = this.camera;
    return new Matrix4().multiplyMatrices(projectionMatrix, matrixWorldInverse).elements;
  }

  /** What is seen at a place of the window, in its pixels: a point before everything, and the way from there. */
  sight(x: number, y: number): { from: [number, number, number]; way: [number, number, number] } {
    const place = new Vector3((2 * x) / this.width - 1, 1 - (2 * y) / this.height, -1);
    const from = place.unproject(this.camera);
    const way = new Vector3();
    this.camera.getWorldDirection(way);
    return { from: [from.x, from.y, from.z], way: [way.x, way.y, way.z] };
  }

  private frame(): void {
    const aspect = this.width / this.height;
    const half = this.half_height_mm;
    Object.assign(this.camera, {
      left: -half * aspect,
      right: half * aspect,
      top: half,
      bottom: -half,
    });
    this.camera.updateProjectionMatrix();
  }

  /** The smallest half height at which all corners of the box are seen, with a margin. */
  private half_height_for(box: Box): number {
    const inverse = this.camera.matrixWorldInverse.copy(this.camera.matrixWorld).invert();
    const aspect = this.width / this.height;
    const free = Math.max(LEAST_HEIGHT, 1 - (2 * BAR_PX) / this.height);
    let half = 1;
    for (let corner = 0; corner < 8; corner++) {
      const point = new Vector3(
        ...[0, 1, 2].map((i) => ((corner >> i) & 1 ? box.max : box.min)[i]),
      );
      point.applyMatrix4(inverse);
      const upright = Math.abs(point.y) / Math.min(free, 1 / MARGIN);
      half = Math.max(half, upright, (MARGIN * Math.abs(point.x)) / aspect);
    }
    return half;
  }
}
