/** What stands around the path: travel, stock, ground grid, work origin, tool changes, the corner with the axes. */
import {
  BoxGeometry,
  BufferGeometry,
  CanvasTexture,
  EdgesGeometry,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineDashedMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Sprite,
  SpriteMaterial,
  type ColorRepresentation,
} from 'three';
import { type Box, size } from '../logic/box';
import { ORDER } from './section_plane';

export interface Palette {
  ground: string;
  grid: string;
  grid_strong: string;
  travel: string;
  stock: string;
  text: string;
  x: string;
  y: string;
  z: string;
  metal: string;
  metal_dark: string;
  tool: string;
  beam: string;
  mark: string;
  /** Stock, its cut face and the lines on it, the edges of the part, clamps. */
  blank: string;
  face: string;
  hatch: string;
  edge: string;
  fixture: string;
  shadow: string;
  alarm: string;
  hold: string;
}

function box_edges(box: Box, colour: ColorRepresentation, dashed: boolean): LineSegments {
  const [x, y, z] = size(box);
  const material = dashed
    ? dashed_line(colour, Math.hypot(x, y))
    : new LineBasicMaterial({ color: colour });
  const edges = new LineSegments(new EdgesGeometry(solid_box(x, y, z, 1e-6)), material);
  const [cx, cy, cz] = box.min.map((low, i) => (low + box.max[i]) / 2);
  edges.position.set(cx, cy, cz);
  if (dashed) edges.computeLineDistances();
  return edges;
}

/** Behind all that is drawn over it: a line through the part says nothing of it. */
export function travel_edges(box: Box, { travel }: Palette): LineSegments {
  const edges = box_edges(box, travel, true);
  edges.renderOrder = ORDER.behind;
  (edges.material as LineDashedMaterial).depthWrite = false;
  return edges;
}

const dashed_line = (color: ColorRepresentation, long: number): LineDashedMaterial =>
  new LineDashedMaterial({ color, dashSize: long / 90, gapSize: long / 120 });

/** No side of it is less than that. */
const solid_box = (x: number, y: number, z: number, least: number): BoxGeometry =>
  new BoxGeometry(Math.max(x, least), Math.max(y, least), Math.max(z, least));

/** The stock: edges and a breath of body, so that its top reads as a face. */
export function stock_box(box: Box, palette: Palette): Group {
  const group = new Group();
  const [x, y, z] = size(box);
  const looks = { color: palette.stock, transparent: true, opacity: 0.07, depthWrite: false };
  const body = new Mesh(solid_box(x, y, z, 0.01), new MeshBasicMaterial(looks));
  const edges = box_edges(box, palette.stock, false);
  body.position.copy(edges.position);
  group.add(body, edges);
  return group;
}

/** A grid of round millimetres below everything. */
export function ground_grid(box: Box, palette: Palette): Group {
  const [width, depth] = size(box);
  const step = round_step(Math.max(width, depth) / 24);
  const group = new Group();
  group.add(grid_lines(box, step, palette.grid), grid_lines(box, step * 5, palette.grid_strong));
  return group;
}

export const round_step = (wanted: number): number =>
  [1, 2, 5, 10, 20, 50, 100, 200, 500].find((step) => step >= wanted) ?? 1000;

function grid_lines(box: Box, step: number, colour: string): LineSegments {
  const points: number[] = [];
  const [x0, y0, z] = box.min;
  const [x1, y1] = box.max;
  for (let x = Math.ceil(x0 / step) * step; x <= x1; x += step) points.push(x, y0, z, x, y1, z);
  for (let y = Math.ceil(y0 / step) * step; y <= y1; y += step) points.push(x0, y, z, x1, y, z);
  return lines(points, colour);
}

export function lines(points: number[], colour: ColorRepresentation): LineSegments {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(points, 3));
  return new LineSegments(geometry, new LineBasicMaterial({ color: colour }));
}

/** Of the drawing of a text: pixels for one of its pixels on the screen. */
const SHARPNESS = 3;
const FONT = `600 ${13 * SHARPNESS}px "IBM Plex Sans", sans-serif`;

/** Text that keeps its size on the screen; `height` is the share of the picture's height. */
export function label(text: string, colour: string, pixels: number): Sprite {
  const canvas = written(text, colour);
  const map = new CanvasTexture(canvas);
  const looks = { map, depthTest: false, sizeAttenuation: false, toneMapped: false };
  const sprite = new Sprite(new SpriteMaterial(looks));
  sprite.userData = { aspect: canvas.width / canvas.height, pixels };
  sprite.renderOrder = 10;
  return sprite;
}

function written(text: string, colour: string): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = Math.ceil(width_of(text, canvas)) + 4 * SHARPNESS;
  canvas.height = 18 * SHARPNESS;
  const pen = canvas.getContext('2d')!; // its looks went with the new size
  pen.font = FONT;
  pen.fillStyle = colour;
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  pen.fillText(text, canvas.width / 2, canvas.height / 2);
  return canvas;
}

function width_of(text: string, canvas: HTMLCanvasElement): number {
  const pen = canvas.getContext('2d')!;
  pen.font = FONT;
  return pen.measureText(text).width;
}

/** Sprites of label() as large as their pixels ask for, in a picture of this scale. */
export function size_labels(root: Group, mm_per_pixel: number): void {
  root.traverse((object) => {
    const { aspect, pixels } = object.userData as { aspect?: number; pixels?: number };
    if (aspect && pixels)
      object.scale.set(pixels * aspect * mm_per_pixel, pixels * mm_per_pixel, 1);
  });
}

export function axes_corner(palette: Palette): Group {
  const group = new Group();
  const arrows: [string, string, [number, number, number]][] = [
    ['X', palette.x, [1, 0, 0]],
    ['Y', palette.y, [0, 1, 0]],
    ['Z', palette.z, [0, 0, 1]],
  ];
  for (const [name, colour, way] of arrows)
    group.add(lines([0, 0, 0, ...way], colour), name_of_axis(name, colour, way));
  return group;
}

/** Of one size with its arrow. */
function name_of_axis(name: string, colour: string, [x, y, z]: [number, number, number]): Sprite {
  const text = label(name, colour, 1);
  text.userData = {};
  text.scale.set(0.5, 0.5, 1);
  text.position.set(x * 1.3, y * 1.3, z * 1.3);
  return text;
}

export function dispose(root: Group | null): void {
  root?.traverse((object) => {
    const drawn = object as Mesh;
    drawn.geometry?.dispose();
    const material = drawn.material as MeshBasicMaterial | undefined;
    material?.map?.dispose();
    material?.dispose?.();
  });
  root?.removeFromParent();
}
