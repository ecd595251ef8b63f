/**
 * The 3-D picture of a machine: a scene without perspective, drawn only when something in it has changed. It knows nothing of
 * the page around it: it is told what to show, and tells where the pointer is on the path.
 */
import { Group, Scene, type WebGLRenderer } from 'three';
import { type Box, diagonal, empty_box, is_empty, join } from '../logic/box';
import type { Colouring, Scheme } from '../logic/colour_scale';
import { Detail, FINE, type Level, REST_AFTER_MS, slices_at_rest } from '../logic/detail';
import { fit_box, is_path } from '../logic/fit_box';
import type { Point } from '../logic/kinematics';
import type { PathPlace, PathStore, Range } from '../logic/path_store';
import { type Hit, pick } from '../logic/pick';
import type { MachineDefinition } from '../logic/protocol';
import type { ToolShape } from '../logic/stock/tool_shape';
import type { BodyHit } from './body';
import { ViewKeeper } from '../logic/view_keeper';
import { AxesCorner } from './corner';
import { Eye } from './eye';
import {
  type Palette,
  dispose,
  ground_grid,
  size_labels,
  stock_box,
  travel_edges,
} from './furniture';
import { when_drawn } from './frame_fence';
import { Highlight, type Region } from './highlight';
import { type Model, type Pose, model_of } from './models';
import { PartMaker } from './part_maker';
import { PathLayer } from './path_layer';
import { PathMaterial } from './path_material';
import { PoseGlide } from './pose_glide';
import { PIXELS } from './pixels';
import { ShapedTool } from './shaped_tool';
import { renderer_of } from './renderer';
import { draws_by_software, MOST_SMOOTH_SEGMENTS, SMOOTH_BY } from './software';
import { StockLayer } from './stock_layer';
import { travel_of, with_linkage } from './subject';
import { type WorkZero, turning_sheet, with_mirrored } from './turning_sheet';
import { IN_THE_CHUCK, ON_THE_TABLE, type ViewName } from './views';

const PICK_REACH_PX = 7;
/** Of the diagonal of what is seen, unless all of it is asked for. */
const LEAST_CUTS = 0.4;
/** The part is what the picture is about: rapids and tool are seen with it where they are near. */
const LEAST_OF_PART = 0.95;

export interface Shown {
  rapids: boolean;
  travel: boolean;
  stock: boolean;
  /** The path, while the part is shown. */
  path_with_part: boolean;
}

export class Picture {
  private readonly renderer: WebGLRenderer;
  private readonly by_software = draws_by_software();
  private readonly scene = new Scene();
  private readonly path_scene = new Scene();
  private readonly eye: Eye;
  private readonly corner = new AxesCorner();
  private readonly material = new PathMaterial();
  private readonly path = new PathLayer(this.material);
  private readonly highlight = new Highlight();
  private readonly glide = new PoseGlide();
  /** The part; whoever changes it asks for a picture. */
  readonly stock: StockLayer;
  private readonly maker: PartMaker;
  private tool: ShapedTool | null = null;
  private model: Model | null = null;
  private furniture: Group | null = null;
  private definition: MachineDefinition | null = null;
  private palette: Palette | null = null;
  private store: PathStore | null = null;
  private travel: Box = empty_box();
  private shown: Shown = { rapids: true, travel: true, stock: true, path_with_part: false };
  private width = 1;
  private height = 1;
  private wanted = false;
  private in_work = false;
  private rest_timer = 0;
  private readonly detail = new Detail();
  private closed = false;
  private readonly view = new ViewKeeper();
  private tip: Point | null = null;
  private zero: WorkZero = { x: 0, z: 0 };

  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly calm: () => boolean,
  ) {
    this.renderer = renderer_of(canvas, !this.by_software);
    this.eye = new Eye(
      canvas,
      () => this.request(),
      () => this.view.hand(),
    );
    this.path_scene.add(this.path.group);
    this.stock = new StockLayer(calm, this.by_software);
    this.maker = new PartMaker(this.stock, (coarse) =>
      !coarse && this.detail.is_coarse ? this.rest(this.level()) : this.request(),
    );
    this.scene.add(this.highlight.group, this.stock.group);
    this.look('iso');
  }

  dispose(): void {
    this.closed = true;
    clearTimeout(this.rest_timer);
    this.maker.close();
    this.path.clear();
    this.stock.dispose();
    this.tool?.dispose();
    this.eye.dispose();
    this.renderer.dispose();
  }

  set_palette(palette: Palette, scheme: Scheme): void {
    this.palette = palette;
    this.material.set_scheme(scheme, palette.ground);
    this.highlight.set_colour(palette.mark);
    this.corner.set_palette(palette);
    this.stock.set_palette(palette, scheme);
    if (this.definition) this.build_model();
    this.build_furniture();
  }

  set_machine(definition: MachineDefinition): void {
    this.definition = definition;
    this.travel = travel_of(definition);
    this.view.forget();
    this.tip = null;
    this.glide.forget();
    this.eye.stand(definition.lathe ? IN_THE_CHUCK : ON_THE_TABLE);
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

  /** As its set-up describes it; null: nobody has, and the machine's own stands for it. */
  set_tool(shape: ToolShape | null): void {
    if ((shape === null && !this.tool) || !this.palette) return;
    this.tool?.dispose();
    this.tool = shape && new ShapedTool(shape, this.palette);
    if (this.tool) this.scene.add(this.tool.group);
    this.request();
  }

  /** The part is another one, or has begun or ceased to be shown. */
  part_changed(): void {
    this.build_furniture();
    if (this.view.goes_with_path) this.fit();
  }

  /** What of the part lies under a place of the canvas, in CSS pixels; from the zero of the stock. */
  hit_part(x: number, y: number): BodyHit | null {
    if (!this.stock.is_shown) return null;
    const { from, way } = this.eye.sight(x, y);
    return this.stock.hit(from, way);
  }

  set_pose(pose: Pose, at_once: boolean): void {
    this.tip = pose.tip;
    this.glide.aim(pose, at_once || this.calm(), performance.now());
    this.request();
  }

  /** Of a lathe: where the zero of the work system lies, whose X is the centre of the part. */
  set_work_zero(zero: WorkZero): void {
    if (zero.x === this.zero.x && zero.z === this.zero.z) return;
    this.zero = zero;
    this.build_furniture();
    if (this.view.goes_with_path) this.fit();
  }

  set_highlight(ranges: Range[], region: Region | null): void {
    this.highlight.set(this.store, ranges, region);
    this.request();
  }

  resize(width: number, height: number): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    this.renderer.setSize(this.width, this.height, false);
    this.material.uniforms.viewport.value.set(this.width, this.height);
    this.eye.resize(this.width, this.height);
    this.draw(performance.now(), this.level());
    this.request(); // with rest behind it
  }

  look(view: ViewName): void {
    this.eye.look(view);
    this.request();
  }

  /** The path, or the travel when there is none, in the middle and as large as it may be, with what is not far off. */
  fit(): void {
    this.fit_to(this.subject(this.stock.is_shown ? LEAST_OF_PART : LEAST_CUTS));
  }

  /** With the last rapid and the tool. */
  fit_all(): void {
    this.fit_to(this.subject(0));
  }

  turn(azimuth_rad: number, polar_rad: number): void {
    this.view.hand();
    this.eye.turn(azimuth_rad, polar_rad);
  }

  zoom(factor: number): void {
    this.view.hand();
    this.eye.zoom(factor);
    this.request();
  }

  /** What lies under a place of the canvas, in CSS pixels. */
  hit(x: number, y: number): Hit | null {
    const { store, width, height } = this;
    const matrix = this.eye.matrix();
    return store && pick(store, { matrix, width, height, x, y, reach_px: PICK_REACH_PX });
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
      (now) => this.draw(now, level, this.detail.is_coarse),
      (cost_ms) => {
        const was_coarse = this.detail.is_coarse;
        this.detail.took(cost_ms);
        if (!was_coarse && this.stock.is_shown) this.detail.took_whole(cost_ms);
        const has_rest = this.by_software || this.stock.is_shown;
        const is_final = level === FINE && !was_coarse && !has_rest;
        if (this.next_frame() || is_final) return;
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
        (now) => (part ? this.draw_path(part, one_of) : this.draw_at_rest(now, one_of)),
        (cost_ms) => {
          if (part === 0 && this.stock.is_shown) this.detail.took_whole(cost_ms);
          if (!this.next_frame() && part + 1 < one_of && !this.closed) slice(part + 1);
        },
      );
    slice(0);
  }

  private draw_at_rest(now: number, one_of: number): void {
    const segments = this.store?.facts.segments ?? 0;
    this.draw(now, { ...FINE, one_of }, false, this.by_software && segments < MOST_SMOOTH_SEGMENTS);
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

  private draw(now: number, { slack_px, one_of }: Level, coarse = false, smooth = false): void {
    const glides = this.pose_model(now);
    this.maker.make(coarse);
    this.set_pixels(Math.min(2, devicePixelRatio) * (smooth ? SMOOTH_BY : 1));
    const pixel_mm = this.eye.pixel_mm();
    this.path.choose_detail(pixel_mm, slack_px);
    this.model?.scale(pixel_mm);
    if (this.furniture) size_labels(this.furniture, pixel_mm);
    size_labels(this.stock.group, pixel_mm);
    this.renderer.clear();
    this.draw_path(0, one_of);
    this.renderer.render(this.scene, this.eye.camera);
    this.corner.draw(this.renderer, this.eye.camera, this.width, this.height);
    this.maker.drawn_at = now;
    if (glides || this.stock.moves) this.request();
  }

  private set_pixels(ratio: number): void {
    if (ratio === this.renderer.getPixelRatio()) return;
    PIXELS.value = ratio;
    this.renderer.setPixelRatio(ratio); // the canvas is empty then, until something is drawn
  }

  private draw_path(part: number, one_of: number): void {
    if (this.stock.is_shown && !this.shown.path_with_part) return;
    this.material.set_part(part, one_of);
    this.renderer.setViewport(0, 0, this.width, this.height);
    if (this.definition?.lathe && this.shown.stock) this.draw_other_half();
    this.renderer.render(this.path_scene, this.eye.camera);
  }

  /** A turned part is as well where the tool is not: its cuts beyond the centre line, faint. */
  private draw_other_half(): void {
    this.material.set_mirrored(true);
    this.path_scene.scale.x = -1;
    this.path_scene.position.x = 2 * this.zero.x;
    this.renderer.render(this.path_scene, this.eye.camera);
    this.path_scene.scale.x = 1;
    this.path_scene.position.x = 0;
    this.material.set_mirrored(false);
  }

  private pose_model(now: number): boolean {
    const pose = this.glide.at(now);
    if (pose) this.model?.set(pose);
    if (pose) this.tool?.group.position.set(...pose.tip);
    if (this.model) this.model.group.visible = !this.tool;
    return this.glide.moves(now);
  }

  private fit_to(box: Box): void {
    if (is_empty(box)) return;
    this.eye.fit(box);
    this.request();
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
    const is_lathe = this.definition?.lathe === true;
    const work = structuredClone(is_lathe ? with_mirrored(cuts, this.zero) : cuts);
    const stock = this.stock.box_with_fixtures();
    if (stock) join(work, stock);
    const box = fit_box(work, bounds, { rapids, tip: this.tip, least_cuts });
    if (stock && least_cuts > 0) return box;
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
      this.furniture.add(this.ground(this.palette));
      if (this.shown.travel) this.furniture.add(travel_edges(this.travel, this.palette));
    }
    const cuts = this.store?.facts.cuts;
    const has_outline = this.shown.stock && !this.stock.is_shown && !this.definition?.lathe;
    if (has_outline && cuts && !is_empty(cuts)) this.furniture.add(stock_box(cuts, this.palette));
    this.scene.add(this.furniture);
    this.request();
  }

  private ground(palette: Palette): Group {
    const cuts = this.store?.facts.cuts ?? empty_box();
    if (this.definition?.lathe) return turning_sheet(cuts, this.travel, this.zero, palette);
    return ground_grid(this.grid_box(), palette);
  }

  /** The grid lies on the floor of the travel, or below the work where the travel is far under it. */
  private grid_box(): Box {
    const work = this.stock.box() ?? this.store?.facts.cuts;
    if (!work || is_empty(work) || this.definition?.kinematics.kind === 'arm') return this.travel;
    const box = structuredClone(this.travel);
    box.min[2] = Math.max(box.min[2], work.min[2]);
    return box;
  }
}

function vertices_before(store: PathStore, place: PathPlace): number {
  let count = 0;
  for (let i = 0; i < place.chunk; i++) count += store.chunks[i].vertices;
  return count + place.vertex + place.fraction;
}
