/**
 * The 3-D picture of a machine: a scene without perspective, drawn only when something in it has changed. It knows nothing of
 * the page around it: it is told what to show, and tells where the pointer is on the path.
 */
import {
  AmbientLight,
  DirectionalLight,
  Group,
  Matrix4,
  OrthographicCamera,
  Quaternion,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { type Box, diagonal, empty_box, grow, is_empty, join } from '../logic/box';
import { Kind } from '../logic/chunk';
import type { Colouring, Scheme } from '../logic/colour_scale';
import { Detail, FINE, type Level, REST_AFTER_MS, slices_at_rest } from '../logic/detail';
import { fit_box, is_path } from '../logic/fit_box';
import { head_pose, joints_of, type Point } from '../logic/kinematics';
import type { PathPlace, PathStore, Range } from '../logic/path_store';
import { type Hit, pick } from '../logic/pick';
import type { MachineDefinition } from '../logic/protocol';
import { ViewKeeper } from '../logic/view_keeper';
import {
  type Palette,
  axes_corner,
  box_edges,
  dispose,
  ground_grid,
  size_labels,
  stock_box,
} from './furniture';
import { when_drawn } from './frame_fence';
import { Highlight } from './highlight';
import { type Model, type Pose, model_of } from './models';
import { PathLayer } from './path_layer';
import { PathMaterial } from './path_material';
import { PoseGlide } from './pose_glide';
import { VIEWS, type ViewName } from './views';

const CORNER_PX = 92;
const PICK_REACH_PX = 7;
const SAMPLES = 64;
/** Of the diagonal of what is seen, unless all of it is asked for. */
const LEAST_CUTS = 0.4;

export interface Shown {
  rapids: boolean;
  travel: boolean;
  stock: boolean;
}

export class Picture {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly path_scene = new Scene();
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, -1e5, 1e5);
  private readonly controls: OrbitControls;
  private readonly corner_scene = new Scene();
  private readonly corner_camera = new OrthographicCamera(-1.7, 1.7, 1.7, -1.7, -10, 10);
  private readonly material = new PathMaterial();
  private readonly path = new PathLayer(this.material);
  private readonly highlight = new Highlight();
  private readonly glide = new PoseGlide();
  private model: Model | null = null;
  private furniture: Group | null = null;
  private corner: Group | null = null;
  private definition: MachineDefinition | null = null;
  private palette: Palette | null = null;
  private store: PathStore | null = null;
  private travel: Box = empty_box();
  private shown: Shown = { rapids: true, travel: true, stock: true };
  private width = 1;
  private height = 1;
  private half_height_mm = 100;
  private wanted = false;
  private in_work = false;
  private rest_timer = 0;
  private readonly detail = new Detail();
  private closed = false;
  private readonly view = new ViewKeeper();
  private tip: Point | null = null;

  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly calm: () => boolean,
  ) {
    this.renderer = new WebGLRenderer({
      canvas,
      antialias: true,
      alpha: true,
      preserveDrawingBuffer: true, // a picture at rest is drawn in slices
      powerPreference: 'high-performance',
    });
    this.renderer.setClearColor(0, 0);
    this.renderer.autoClear = false;
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => this.request());
    this.controls.addEventListener('start', () => this.view.hand());
    this.add_lights();
    this.path_scene.add(this.path.group);
    this.scene.add(this.highlight.group);
    this.look('iso');
  }

  dispose(): void {
    this.closed = true;
    clearTimeout(this.rest_timer);
    this.path.clear();
    this.controls.dispose();
    this.renderer.dispose();
  }

  set_palette(palette: Palette, scheme: Scheme): void {
    this.palette = palette;
    this.material.set_scheme(scheme, palette.ground);
    this.highlight.set_colour(palette.mark);
    if (this.corner) dispose(this.corner);
    this.corner = axes_corner(palette);
    this.corner_scene.add(this.corner);
    if (this.definition) this.build_model();
    this.build_furniture();
  }

  set_machine(definition: MachineDefinition): void {
    this.definition = definition;
    this.travel = travel_of(definition);
    this.view.forget();
    this.tip = null;
    this.glide.forget();
    this.build_model();
    this.build_furniture();
    this.fit();
  }

  /** Takes over what has arrived of the path; until a hand turns the picture, all of it is kept in sight. */
  set_path(store: PathStore, program: string, done: boolean): void {
    this.store = store;
    this.path.take(store);
    this.build_furniture();
    if (done || !this.path_is_empty()) {
      if (this.view.arrives(store.run, program)) this.build_model();
      if (this.view.goes_with_path) this.fit();
    }
    this.request();
  }

  set_shown(shown: Shown): void {
    this.shown = shown;
    this.material.uniforms.show_rapids.value = shown.rapids ? 1 : 0;
    this.build_furniture();
  }

  set_colouring(colouring: Colouring, low: number, high: number): void {
    this.material.set_colouring(colouring, low, high);
    this.request();
  }

  /** How far the run is; null: nothing has run, all of the path stands out. */
  set_progress(place: PathPlace | null): void {
    this.material.uniforms.done.value =
      place && this.store ? vertices_before(this.store, place) : -1;
    this.request();
  }

  /** The last motion before the control stops; null: it does not. What comes behind it no machine makes. */
  set_stop(motion: number | null): void {
    const place = motion === null ? null : (this.store?.end_of_motion(motion) ?? null);
    this.material.uniforms.stop.value =
      place && this.store ? vertices_before(this.store, place) : -1;
    this.request();
  }

  set_pose(pose: Pose, at_once: boolean): void {
    this.tip = pose.tip;
    this.glide.aim(pose, at_once || this.calm(), performance.now());
    this.request();
  }

  set_highlight(ranges: Range[]): void {
    this.highlight.set(this.store, ranges);
    this.request();
  }

  resize(width: number, height: number): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(this.width, this.height, false);
    this.material.uniforms.viewport.value.set(this.width, this.height);
    this.frame_camera();
    this.draw(performance.now(), this.level());
    this.request(); // with rest behind it
  }

  look(view: ViewName): void {
    const { from, up } = VIEWS[view];
    const way = new Vector3(...from).normalize().multiplyScalar(1000);
    this.camera.up.set(...up);
    this.camera.position.copy(this.controls.target).add(way);
    this.camera.lookAt(this.controls.target);
    // OrbitControls turns about what was up when it was made: always Z, but for the view from above.
    this.camera.up.set(0, 0, 1);
    if (view === 'top') this.camera.position.y -= 0.01;
    this.controls.update();
    this.request();
  }

  /** The path, or the travel when there is none, in the middle and as large as it may be, with what is not far off. */
  fit(): void {
    this.fit_to(this.subject(LEAST_CUTS));
  }

  /** With the last rapid and the tool. */
  fit_all(): void {
    this.fit_to(this.subject(0));
  }

  turn(azimuth_rad: number, polar_rad: number): void {
    this.view.hand();
    const way = this.camera.position.clone().sub(this.controls.target);
    const side = new Vector3().crossVectors(this.camera.up, way).normalize();
    way.applyQuaternion(new Quaternion().setFromAxisAngle(side, polar_rad));
    way.applyQuaternion(new Quaternion().setFromAxisAngle(this.camera.up, azimuth_rad));
    this.camera.position.copy(this.controls.target).add(way);
    this.controls.update();
  }

  zoom(factor: number): void {
    this.view.hand();
    this.camera.zoom *= factor;
    this.camera.updateProjectionMatrix();
    this.request();
  }

  /** What lies under a place of the canvas, in CSS pixels. */
  hit(x: number, y: number): Hit | null {
    if (!this.store) return null;
    const matrix = new Matrix4().multiplyMatrices(
      this.camera.projectionMatrix,
      this.camera.matrixWorldInverse,
    );
    const aim = {
      matrix: matrix.elements,
      width: this.width,
      height: this.height,
      x,
      y,
      reach_px: PICK_REACH_PX,
    };
    return pick(this.store, aim);
  }

  /** Draws with the next frame, and never before the last one is there. */
  request(): void {
    if (this.wanted || this.closed) return;
    this.wanted = true;
    if (!this.in_work) requestAnimationFrame(() => this.frame());
  }

  private frame(): void {
    if (this.closed) return;
    this.wanted = false;
    clearTimeout(this.rest_timer);
    const level = this.level();
    this.draw_and_wait(
      (now) => this.draw(now, level),
      (cost_ms) => {
        this.detail.took(cost_ms);
        if (this.next_frame() || level === FINE) return;
        this.rest_timer = window.setTimeout(() => this.rest(level), REST_AFTER_MS);
      },
    );
  }

  /** Nothing has changed for a while: once more with all detail, in slices between which a hand may take over. */
  private rest(last: Level): void {
    if (this.closed || this.wanted) return;
    const one_of = slices_at_rest(last);
    const slice = (part: number) =>
      this.draw_and_wait(
        (now) => (part ? this.draw_path(part, one_of) : this.draw(now, { ...FINE, one_of })),
        () => this.next_frame() || (part + 1 < one_of && !this.closed && slice(part + 1)),
      );
    slice(0);
  }

  private level(): Level {
    return this.detail.level(this.store?.facts.segments ?? 0);
  }

  private next_frame(): boolean {
    if (this.wanted) requestAnimationFrame(() => this.frame());
    return this.wanted;
  }

  private draw_and_wait(draw: (now: number) => void, drawn: (cost_ms: number) => void): void {
    const begin = performance.now();
    this.in_work = true;
    draw(begin);
    when_drawn(this.renderer.getContext() as WebGL2RenderingContext, () => {
      this.in_work = false;
      drawn(performance.now() - begin);
    });
  }

  private draw(now: number, { slack_px, one_of }: Level): void {
    const glides = this.pose_model(now);
    const pixel_mm = this.pixel_mm();
    this.path.choose_detail(pixel_mm, slack_px);
    this.model?.scale(pixel_mm);
    if (this.furniture) size_labels(this.furniture, pixel_mm);
    this.renderer.clear();
    this.draw_path(0, one_of);
    this.renderer.render(this.scene, this.camera);
    this.draw_corner();
    if (glides) this.request();
  }

  private draw_path(part: number, one_of: number): void {
    this.material.set_part(part, one_of);
    this.renderer.setViewport(0, 0, this.width, this.height);
    this.renderer.render(this.path_scene, this.camera);
  }

  private pose_model(now: number): boolean {
    const pose = this.glide.at(now);
    if (pose) this.model?.set(pose);
    return this.glide.moves(now);
  }

  private draw_corner(): void {
    this.corner_camera.quaternion.copy(this.camera.quaternion);
    this.corner_camera.position.set(0, 0, 0);
    this.renderer.setViewport(4, 4, CORNER_PX, CORNER_PX);
    this.renderer.setScissor(4, 4, CORNER_PX, CORNER_PX);
    this.renderer.setScissorTest(true);
    this.renderer.clearDepth();
    this.renderer.render(this.corner_scene, this.corner_camera);
    this.renderer.setScissorTest(false);
    this.renderer.setViewport(0, 0, this.width, this.height);
  }

  private fit_to(box: Box): void {
    if (is_empty(box)) return;
    const centre = new Vector3(...box.min).add(new Vector3(...box.max)).multiplyScalar(0.5);
    const way = this.camera.position.clone().sub(this.controls.target);
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).add(way);
    this.camera.zoom = 1;
    this.camera.updateMatrixWorld();
    this.half_height_mm = this.half_height_for(box);
    this.frame_camera();
    this.controls.update();
    this.request();
  }

  private pixel_mm(): number {
    return (2 * this.half_height_mm) / this.camera.zoom / this.height;
  }

  private frame_camera(): void {
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
    let half = 1;
    for (let corner = 0; corner < 8; corner++) {
      const point = new Vector3(
        ...[0, 1, 2].map((i) => ((corner >> i) & 1 ? box.max : box.min)[i]),
      );
      point.applyMatrix4(inverse);
      half = Math.max(half, Math.abs(point.y), Math.abs(point.x) / aspect);
    }
    return half * 1.14;
  }

  private path_is_empty(): boolean {
    return !this.store || !is_path(this.store.facts.bounds);
  }

  /** What the picture is about: the path, with the machine's parts around it on a linkage. */
  private subject(least_cuts: number): Box {
    if (!this.store || this.path_is_empty()) return this.travel;
    const { cuts, bounds } = this.store.facts;
    // An arm reaches from its base to the tool wherever that is.
    if (this.definition?.kinematics.kind === 'arm') least_cuts = 0;
    const { rapids } = this.shown;
    const box = fit_box(cuts, bounds, { rapids, tip: this.tip, least_cuts });
    return with_linkage(box, this.definition, this.store);
  }

  private build_model(): void {
    if (!this.definition || !this.palette) return;
    if (this.model) dispose(this.model.group);
    const reach = Math.max(10, diagonal(this.subject(1)) / 2);
    this.model = model_of(this.definition, this.palette, Math.min(reach, 120));
    this.scene.add(this.model.group);
    const pose = this.glide.at(performance.now());
    if (pose) this.model.set(pose);
  }

  private build_furniture(): void {
    if (!this.palette) return;
    dispose(this.furniture);
    this.furniture = new Group();
    if (!is_empty(this.travel)) {
      this.furniture.add(ground_grid(this.grid_box(), this.palette));
      if (this.shown.travel) this.furniture.add(box_edges(this.travel, this.palette.travel, true));
    }
    const cuts = this.store?.facts.cuts;
    if (this.shown.stock && cuts && !is_empty(cuts))
      this.furniture.add(stock_box(cuts, this.palette));
    this.scene.add(this.furniture);
    this.request();
  }

  /** The grid lies on the floor of the travel, or below the work where the travel is far under it. */
  private grid_box(): Box {
    const cuts = this.store?.facts.cuts;
    if (!cuts || is_empty(cuts) || this.definition?.kinematics.kind === 'arm') return this.travel;
    const box = structuredClone(this.travel);
    box.min[2] = Math.max(box.min[2], cuts.min[2]);
    return box;
  }

  private add_lights(): void {
    const key = new DirectionalLight(0xffffff, 2.4);
    key.position.set(-0.6, -0.9, 1.6);
    const fill = new DirectionalLight(0xffffff, 0.9);
    fill.position.set(1, 0.5, 0.4);
    this.scene.add(new AmbientLight(0xffffff, 1.1), key, fill);
  }
}

/** Where the tip may be: linear axes of the program; what has no travel gets the reach of the linkage. */
function travel_of(definition: MachineDefinition): Box {
  const box = empty_box();
  const { kinematics } = definition;
  const reach = Number(kinematics.upper_arm ?? 0) + Number(kinematics.forearm ?? 0);
  ['X', 'Y', 'Z'].forEach((name, i) => {
    const axis =
      definition.axes.find((a) => a.name === name) ??
      definition.joints.find((a) => a.name === name);
    const far = reach || radius_of(definition);
    box.min[i] = axis?.min ?? -far;
    box.max[i] = axis?.max ?? far;
  });
  return box;
}

function radius_of(definition: MachineDefinition): number {
  const x = definition.joints.find((a) => a.name === 'X');
  return (x?.max ?? 100) + Number(definition.kinematics.x1 ?? 0);
}

function with_linkage(box: Box, definition: MachineDefinition | null, store: PathStore): Box {
  if (definition?.kinematics.kind === 'arm') {
    join(box, { min: [-30, -30, -30], max: [30, 30, 60] });
  }
  if (definition?.kinematics.kind === 'head-ac') {
    for (const place of cut_places(store)) join(box, head_box(definition, store, place));
  }
  return box;
}

/** Some places of the path while it cuts, evenly over its time. */
function cut_places(store: PathStore): PathPlace[] {
  const places: PathPlace[] = [];
  for (let i = 0; i <= SAMPLES; i++) {
    const place = store.place_at((store.facts.end_s * i) / SAMPLES);
    const chunk = place && store.chunks[place.chunk];
    if (chunk && chunk.kind[Math.min(place.vertex + 1, chunk.vertices - 1)] === Kind.cut)
      places.push(place);
  }
  return places;
}

/** The head from its pivot to its carriage while the tip stands there. */
function head_box(definition: MachineDefinition, store: PathStore, place: PathPlace): Box {
  const [a, c] = store.rotary_at(place) ?? [0, 0];
  const joints = joints_of(definition.kinematics, store.point_at(place), { A: a, C: c }, {});
  const { carriage, pivot } = head_pose(definition.kinematics, joints);
  const around = Number(definition.kinematics.r_a) * 0.35;
  const box = empty_box();
  grow(box, carriage[0] - around, carriage[1] - around, carriage[2]);
  grow(box, carriage[0] + around, carriage[1] + around, carriage[2] + 3 * around);
  grow(box, ...pivot);
  return box;
}

function vertices_before(store: PathStore, place: PathPlace): number {
  let count = 0;
  for (let i = 0; i < place.chunk; i++) count += store.chunks[i].vertices;
  return count + place.vertex + place.fraction;
}
