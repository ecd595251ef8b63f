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
  alarm: string;
  hold: string;
}

export function box_edges(box: Box, colour: ColorRepresentation, dashed: boolean): LineSegments {
  const [x, y, z] = size(box);
  const solid = new BoxGeometry(Math.max(x, 1e-6), Math.max(y, 1e-6), Math.max(z, 1e-6));
  const material = dashed
    ? new LineDashedMaterial({
        color: colour,
        dashSize: Math.hypot(x, y) / 90,
        gapSize: Math.hypot(x, y) / 120,
      })
    : new LineBasicMaterial({ color: colour });
  const edges = new LineSegments(new EdgesGeometry(solid), material);
  edges.position.set(
    (box.min[0] + box.max[0]) / 2,
    (box.min[1] + box.max[1]) / 2,
    (box.min[2] + box.max[2]) / 2,
  );
  if (dashed) edges.computeLineDistances();
  return edges;
}

/** The stock: edges and a breath of body, so that its top reads as a face. */
export function stock_box(box: Box, palette: Palette): Group {
  const group = new Group();
  const [x, y, z] = size(box);
  const body = new Mesh(
    new BoxGeometry(Math.max(x, 0.01), Math.max(y, 0.01), Math.max(z, 0.01)),
    new MeshBasicMaterial({
      color: palette.stock,
      transparent: true,
      opacity: 0.07,
      depthWrite: false,
    }),
  );
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

/** Text that keeps its size on the screen; `height` is the share of the picture's height. */
export function label(text: string, colour: string, pixels: number): Sprite {
  const scale = 3;
  const canvas = document.createElement('canvas');
  const font = `600 ${13 * scale}px "IBM Plex Sans", sans-serif`;
  const measure = canvas.getContext('2d')!;
  measure.font = font;
  canvas.width = Math.ceil(measure.measureText(text).width) + 4 * scale;
  canvas.height = 18 * scale;
  const pen = canvas.getContext('2d')!;
  pen.font = font;
  pen.fillStyle = colour;
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  pen.fillText(text, canvas.width / 2, canvas.height / 2);
  const material = new SpriteMaterial({
    map: new CanvasTexture(canvas),
    depthTest: false,
    sizeAttenuation: false,
    toneMapped: false,
  });
  const sprite = new Sprite(material);
  sprite.userData = { aspect: canvas.width / canvas.height, pixels };
  sprite.renderOrder = 10;
  return sprite;
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
  for (const [name, colour, way] of arrows) {
    group.add(lines([0, 0, 0, ...way], colour));
    const text = label(name, colour, 1);
    text.userData = {};
    text.scale.set(0.5, 0.5, 1);
    text.position.set(way[0] * 1.3, way[1] * 1.3, way[2] * 1.3);
    group.add(text);
  }
  return group;
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
