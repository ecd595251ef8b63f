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
  MeshStandardMaterial,
  Path,
  Shape,
  Sprite,
  SpriteMaterial,
} from 'three';
import type { Solid } from '../logic/stock/setup_words';
import { label, type Palette } from './furniture';

type Vec = [number, number, number];

export function fixtures_group(solids: readonly Solid[], palette: Palette): Group {
  const group = new Group();
  for (const solid of solids) {
    group.add(...clamp(geometry_of(solid), palette));
  }
  return group;
}

function clamp(geometry: BufferGeometry, palette: Palette): [Mesh, LineSegments] {
  const looks = { color: palette.fixture, roughness: 0.7, metalness: 0.15, opacity: 0.62 };
  const body = new Mesh(geometry, new MeshStandardMaterial({ ...looks, transparent: true }));
  const line = new LineBasicMaterial({ color: palette.fixture });
  return [body, new LineSegments(new EdgesGeometry(geometry, 30), line)];
}

function geometry_of(solid: Solid): BufferGeometry {
  if (solid.kind === 'box') {
    const size = solid.high.map((value, i) => value - solid.low[i]);
    const middle = solid.high.map((value, i) => (value + solid.low[i]) / 2);
    return new BoxGeometry(...(size as Vec)).translate(...(middle as Vec));
  }
  const { axis, centre, from, to, radius, bore } = solid;
  const long = to - from;
  let geometry: BufferGeometry;
  if (bore > 0) {
    const ring = new Shape().absarc(0, 0, radius, 0, 2 * Math.PI);
    ring.holes.push(new Path().absarc(0, 0, bore, 0, 2 * Math.PI, true));
    geometry = new ExtrudeGeometry(ring, { depth: long, bevelEnabled: false, curveSegments: 32 });
    geometry.translate(0, 0, from);
  } else {
    geometry = new CylinderGeometry(radius, radius, long, 64)
      .rotateX(Math.PI / 2)
      .translate(0, 0, from + long / 2);
  }
  // The other two coordinates in alphabetical order.
  if (axis === 0) geometry.rotateY(Math.PI / 2).translate(0, centre[0], centre[1]);
  else if (axis === 1) geometry.rotateX(-Math.PI / 2).translate(centre[0], 0, centre[1]);
  else geometry.translate(centre[0], centre[1], 0);
  return geometry;
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
  for (const { at, severity, chosen } of marks) {
    const colour = severity === 'error' ? palette.alarm : palette.hold;
    const sprite = triangle(colour, palette.ground);
    sprite.position.set(...at);
    sprite.userData = { aspect: 1, pixels: chosen ? CHOSEN_PX : MARK_PX };
    sprite.renderOrder = chosen ? 21 : 20;
    group.add(sprite);
  }
  return group;
}

/** The sign of an alarm, its tip at the place. */
function triangle(colour: string, ground: string): Sprite {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext('2d')!;
  pen.lineJoin = 'round';
  pen.beginPath();
  pen.moveTo(32, 60);
  pen.lineTo(6, 12);
  pen.lineTo(58, 12);
  pen.closePath();
  pen.strokeStyle = ground;
  pen.lineWidth = 8;
  pen.stroke();
  pen.fillStyle = colour;
  pen.fill();
  pen.fillStyle = ground;
  pen.fillRect(29, 18, 6, 18);
  pen.fillRect(29, 40, 6, 6);
  const sprite = flat(canvas);
  sprite.center.set(0.5, 0.06);
  return sprite;
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
  for (const place of places) {
    const dot = round_dot(palette.mark, palette.ground);
    dot.position.set(...place);
    dot.userData = { aspect: 1, pixels: PLACE_PX };
    group.add(dot);
  }
  if (line.length) group.add(drawn(line, palette), words_at(line, text, palette));
  return group;
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
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 32;
  const pen = canvas.getContext('2d')!;
  pen.beginPath();
  pen.arc(16, 16, 12, 0, 2 * Math.PI);
  pen.fillStyle = colour;
  pen.fill();
  pen.lineWidth = 4;
  pen.strokeStyle = ground;
  pen.stroke();
  const sprite = flat(canvas);
  sprite.renderOrder = 23;
  return sprite;
}

/** Before everything, and of one size whatever the scale. */
function flat(canvas: HTMLCanvasElement): Sprite {
  const map = new CanvasTexture(canvas);
  const looks = { map, depthTest: false, sizeAttenuation: false, toneMapped: false };
  return new Sprite(new SpriteMaterial(looks));
}
