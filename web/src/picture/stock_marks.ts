/** What stands on and around the part: clamps, findings, what is being measured. All from the zero of the stock. */
import {
  BoxGeometry,
  BufferGeometry,
  CanvasTexture,
  CylinderGeometry,
  EdgesGeometry,
  ExtrudeGeometry,
  Float32BufferAttribute,
  Group,
  Line,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  Path,
  Shape,
  Sprite,
  SpriteMaterial,
} from 'three';
import type { Solid } from '../logic/stock/setup_words';
import { label, type Palette } from './furniture';
import { metal } from './metal';

type Vec = [number, number, number];

export function fixtures_group(solids: readonly Solid[], palette: Palette): Group {
  const group = new Group();
  for (const solid of solids) group.add(...clamp(geometry_of(solid), palette));
  return group;
}

function clamp(geometry: BufferGeometry, palette: Palette): [Mesh, LineSegments] {
  const body = new Mesh(geometry, metal({ colour: palette.fixture, polish: 0.35 }));
  const line = new LineBasicMaterial({ color: palette.edge });
  return [body, new LineSegments(new EdgesGeometry(geometry, 30), line)];
}

const geometry_of = (solid: Solid): BufferGeometry =>
  solid.kind === 'box' ? block(solid) : standing(round(solid), solid);

function block({ low, high }: Solid & { kind: 'box' }): BufferGeometry {
  const size = high.map((value, i) => value - low[i]);
  const middle = high.map((value, i) => (value + low[i]) / 2);
  return new BoxGeometry(...(size as Vec)).translate(...(middle as Vec));
}

type Round = Solid & { kind: 'round' };

/** About Z. */
function round({ from, to, radius, bore }: Round): BufferGeometry {
  const long = to - from;
  if (bore > 0) return tube(radius, bore, long).translate(0, 0, from);
  return new CylinderGeometry(radius, radius, long, 64)
    .rotateX(Math.PI / 2)
    .translate(0, 0, from + long / 2);
}

function tube(radius: number, bore: number, depth: number): BufferGeometry {
  const ring = new Shape().absarc(0, 0, radius, 0, 2 * Math.PI);
  ring.holes.push(new Path().absarc(0, 0, bore, 0, 2 * Math.PI, true));
  return new ExtrudeGeometry(ring, { depth, bevelEnabled: false, curveSegments: 32 });
}

/** Turned from Z to its axis; the other two coordinates in alphabetical order. */
function standing(geometry: BufferGeometry, { axis, centre: [u, v] }: Round): BufferGeometry {
  if (axis === 0) return geometry.rotateY(Math.PI / 2).translate(0, u, v);
  if (axis === 1) return geometry.rotateX(-Math.PI / 2).translate(u, 0, v);
  return geometry.translate(u, v, 0);
}

export interface FindingMark {
  at: Vec;
  severity: 'error' | 'warning' | 'note';
  chosen: boolean;
}

const MARK_PX = 20;
const CHOSEN_PX = 30;

export function findings_group(marks: readonly FindingMark[], palette: Palette): Group {
  const group = new Group();
  for (const mark of marks) group.add(finding_sign(mark, palette));
  return group;
}

function finding_sign({ at, severity, chosen }: FindingMark, palette: Palette): Sprite {
  const sprite = triangle(severity === 'error' ? palette.alarm : palette.hold, palette.ground);
  sprite.position.set(...at);
  sprite.userData = { aspect: 1, pixels: chosen ? CHOSEN_PX : MARK_PX };
  sprite.renderOrder = chosen ? 21 : 20;
  return sprite;
}

/** The sign of an alarm, its tip at the place. */
function triangle(colour: string, ground: string): Sprite {
  const pen = pen_of(64);
  pen.beginPath();
  pen.moveTo(32, 60);
  pen.lineTo(6, 12);
  pen.lineTo(58, 12);
  pen.closePath();
  outlined(pen, colour, ground, 8);
  pen.fillStyle = ground;
  pen.fillRect(29, 18, 6, 18);
  pen.fillRect(29, 40, 6, 6);
  const sprite = flat(pen.canvas);
  sprite.center.set(0.5, 0.06);
  return sprite;
}

function pen_of(pixels: number): CanvasRenderingContext2D {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = pixels;
  return canvas.getContext('2d')!;
}

/** The outline lies below: half of it is seen. */
function outlined(
  pen: CanvasRenderingContext2D,
  colour: string,
  ground: string,
  width: number,
): void {
  pen.lineJoin = 'round';
  pen.lineWidth = width;
  pen.strokeStyle = ground;
  pen.stroke();
  pen.fillStyle = colour;
  pen.fill();
}

const PLACE_PX = 9;

/** Places that were clicked, the line or circle through them and what it measures. */
export function measure_group(
  places: readonly Vec[],
  line: readonly Vec[],
  text: string,
  palette: Palette,
): Group {
  const group = new Group();
  for (const place of places) group.add(dot_at(place, palette));
  if (line.length) group.add(drawn(line, palette), words_at(line, text, palette));
  return group;
}

function dot_at(place: Vec, palette: Palette): Sprite {
  const dot = round_dot(palette.mark, palette.ground);
  dot.position.set(...place);
  dot.userData = { aspect: 1, pixels: PLACE_PX };
  return dot;
}

function drawn(line: readonly Vec[], palette: Palette): Line {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(line.flat(), 3));
  const material = new LineBasicMaterial({ color: palette.mark, depthTest: false });
  const whole = new Line(geometry, material);
  whole.renderOrder = 22;
  return whole;
}

function words_at(line: readonly Vec[], text: string, palette: Palette): Sprite {
  const words = label(text, palette.mark, 18);
  words.center.set(0.5, -0.35);
  words.renderOrder = 24;
  const middle = [0, 1, 2].map((i) => (line[0][i] + line[line.length - 1][i]) / 2) as Vec;
  words.position.set(...(line.length === 2 ? middle : line[Math.floor(line.length / 2)]));
  return words;
}

function round_dot(colour: string, ground: string): Sprite {
  const pen = pen_of(32);
  pen.beginPath();
  pen.arc(16, 16, 10, 0, 2 * Math.PI);
  outlined(pen, colour, ground, 8);
  const sprite = flat(pen.canvas);
  sprite.renderOrder = 23;
  return sprite;
}

/** Before everything, and of one size whatever the scale. */
function flat(canvas: HTMLCanvasElement): Sprite {
  const map = new CanvasTexture(canvas);
  const looks = { map, depthTest: false, sizeAttenuation: false, toneMapped: false };
  return new Sprite(new SpriteMaterial(looks));
}
