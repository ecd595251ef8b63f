import { describe, expect, it } from 'vitest';
import { type Grid, HeightField, VOID } from '../src/logic/stock/height_field';
import { HeightMesher, type TileMesh } from '../src/logic/stock/height_mesh';
import { is_wall } from '../src/logic/stock/walls';
import { random } from './random';

const grid = (nx: number, ny: number, cell = 0.5): Grid => ({
  nx,
  ny,
  cell: [cell, cell],
  corner: [-3, 7, -20],
  top: 0,
});

/** A field whose columns have the height that a function says at their middles. */
function field_of(place: Grid, height: (x: number, y: number) => number): HeightField {
  const field = new HeightField(place);
  for (let j = 0; j < place.ny; j++)
    for (let i = 0; i < place.nx; i++)
      field.heights[j * place.nx + i] = height(
        (i + 0.5) * place.cell[0],
        (j + 0.5) * place.cell[1],
      );
  return field;
}

function meshes(field: HeightField): TileMesh[] {
  const mesher = new HeightMesher(0);
  const all: TileMesh[] = [];
  for (let y = 0; y < field.tiles_y; y++)
    for (let x = 0; x < field.tiles_x; x++) all.push(mesher.mesh(field, x, y));
  return all;
}

/** By the theorem of Gauss; `open` is the sum of all faces as vectors, which is 0 for a closed body. */
function body_of(field: HeightField) {
  const [ox, oy, oz] = field.grid.corner;
  let volume = 0;
  const open = [0, 0, 0];
  let wrong_side = 0;
  for (const { positions: p, normals, indices } of meshes(field)) {
    for (let t = 0; t < indices.length; t += 3) {
      const [a, b, c] = [0, 1, 2].map((n) => {
        const v = 3 * indices[t + n];
        return [p[v] - ox, p[v + 1] - oy, p[v + 2] - oz];
      });
      const u = b.map((value, i) => value - a[i]);
      const w = c.map((value, i) => value - a[i]);
      const cross = [0, 1, 2].map(
        (i) => u[(i + 1) % 3] * w[(i + 2) % 3] - u[(i + 2) % 3] * w[(i + 1) % 3],
      );
      cross.forEach((value, i) => (open[i] += value / 2));
      volume += (a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]) / 6;
      const n = 4 * indices[t];
      const along = cross[0] * normals[n] + cross[1] * normals[n + 1] + cross[2] * normals[n + 2];
      if (along < -1e-3 * Math.hypot(...cross) * 127) wrong_side++;
    }
  }
  return { volume, open: Math.hypot(...open), wrong_side };
}

function columns_volume({ heights, grid: { cell, corner } }: HeightField): number {
  let sum = 0;
  for (const height of heights) if (height !== VOID) sum += height - corner[2];
  return sum * cell[0] * cell[1];
}

const in_circle = (x: number, y: number, cx: number, cy: number, r: number): boolean =>
  Math.hypot(x - cx, y - cy) < r;

describe('the triangles of a height field', () => {
  it('of uncut stock are twelve and six plates, its volume is that of the box', () => {
    const field = field_of(grid(65, 65), () => 0);
    const [mesh] = meshes(field);
    expect(mesh.indices.length / 3).toBe(12);
    expect(body_of(field).volume).toBeCloseTo(32.5 * 32.5 * 20, 0);
  });

  const cases: [string, (x: number, y: number) => number, number][] = [
    ['a rectangular pocket', (x, y) => (x > 10 && x < 60 && y > 5 && y < 30 ? -6 : 0), 3e-4],
    ['an island in a pocket', (x, y) => (in_circle(x, y, 40, 20, 8) ? -1 : -9), 2e-3],
    ['a round hole through', (x, y) => (in_circle(x, y, 30, 22, 9) ? VOID : 0), 2e-3],
    ['a hole in a pocket', (x, y) => (in_circle(x, y, 40, 20, 5) ? VOID : x > 20 ? -5 : 0), 2e-3],
    ['a dome', (x, y) => -0.02 * ((x - 40) ** 2 + (y - 20) ** 2) * 0.2, 1e-3],
    [
      'a ball groove',
      (x, y) => (Math.abs(y - 20) < 3 ? -Math.sqrt(9 - (y - 20) ** 2) : 0) + 0 * x,
      2e-3,
    ],
    ['a slot across the grid', (x, y) => (Math.abs(0.6 * x - 0.8 * y - 5) < 3 ? -7 : 0), 2e-3],
    ['terraces of one column', (x) => -0.1 * Math.floor(x / 0.5), 3e-3],
    ['a staircase', (x, y) => -Math.floor(x / 8) - Math.floor(y / 8), 1e-3],
  ];
  it.each(cases)('of %s close a body with the volume of its columns', (_, height, share) => {
    const field = field_of(grid(160, 90), height);
    const { volume, open, wrong_side } = body_of(field);
    const wanted = columns_volume(field);
    expect(Math.abs(volume - wanted) / wanted).toBeLessThan(share);
    expect(open).toBeLessThan(1e-3);
    expect(wrong_side).toBe(0);
  });

  it('have upright walls with the normal of the circle that they stand on', () => {
    const field = field_of(grid(130, 130, 0.25), (x, y) => (in_circle(x, y, 16, 16, 10) ? -8 : 0));
    let walls = 0;
    for (const { positions: p, normals } of meshes(field)) {
      for (let v = 0; 3 * v < p.length; v++) {
        const at = [p[3 * v] + 3 - 16, p[3 * v + 1] - 7 - 16];
        const radius = Math.hypot(...at);
        if (normals[4 * v + 2] !== 0 || Math.abs(radius - 10) > 1) continue;
        walls++;
        expect(Math.abs(radius - 10)).toBeLessThan(0.2);
        const inwards = -(at[0] * normals[4 * v] + at[1] * normals[4 * v + 1]) / radius / 127;
        expect(inwards).toBeGreaterThan(Math.cos((16 * Math.PI) / 180));
      }
    }
    expect(walls).toBeGreaterThan(400);
  });

  it('stand at the border of the part, and their lines are its edges', () => {
    const [mesh] = meshes(field_of(grid(40, 20), () => -4));
    const x = [...mesh.positions].filter((_, i) => i % 3 === 0);
    expect(Math.min(...x)).toBeCloseTo(-3, 1);
    expect(Math.max(...x)).toBeCloseTo(17, 1);
    expect(mesh.lines.length / 6).toBe(12);
  });

  it('of tiles side by side meet in the same places', () => {
    const next = random(3);
    const blobs = Array.from({ length: 30 }, () => [
      next() * 80,
      next() * 45,
      2 + 5 * next(),
      -9 * next(),
    ]);
    const field = field_of(grid(160, 90), (x, y) =>
      blobs.reduce(
        (low, [cx, cy, r, z]) => (in_circle(x, y, cx, cy, r) ? Math.min(low, z) : low),
        0,
      ),
    );
    const border = field.grid.corner[0] + 64.5 * 0.5;
    const on_border = ({ positions: p }: TileMesh): Set<string> => {
      const places = new Set<string>();
      for (let v = 0; v < p.length; v += 3)
        // Columns within a rectangle have no corner; where walls cross the border both tiles must have one.
        if (Math.abs(p[v] - border) < 1e-6 && Math.abs((p[v + 1] % 0.5) - 0.25) > 1e-3)
          places.add(`${p[v + 1].toFixed(3)} ${p[v + 2].toFixed(4)}`);
      return places;
    };
    const [left, right] = meshes(field);
    expect(on_border(left).size).toBeGreaterThan(5);
    expect([...on_border(left)].sort()).toEqual([...on_border(right)].sort());
  });

  it('of any columns whatever are closed', () => {
    const next = random(11);
    for (let round = 0; round < 20; round++) {
      const field = field_of(grid(2 + Math.floor(next() * 30), 2 + Math.floor(next() * 30)), () =>
        next() < 0.3 ? -10 * next() : -Math.floor(3 * next()),
      );
      const { open } = body_of(field);
      expect(open).toBeLessThan(1e-3);
    }
  });
});

describe('a step between two columns is a wall', () => {
  it('where it stands out from those beside it', () => {
    expect(is_wall(0, -5, 0, 0.5)).toBe(true);
    expect(is_wall(-0.1, -5, 0.2, 0.5)).toBe(true);
    expect(is_wall(5, -5, 0, 0.5)).toBe(true); // a rib of one column
  });
  it('but not on a slope, however steep, nor where it is small', () => {
    expect(is_wall(-5, -5, -5, 0.5)).toBe(false);
    expect(is_wall(0, -5, -4, 0.5)).toBe(false);
    expect(is_wall(0, -0.3, 0, 0.5)).toBe(false);
  });
  it('where nothing is left on one side, and nowhere where nothing is left on both', () => {
    expect(is_wall(0, -Infinity, NaN, 0.5)).toBe(true);
    expect(is_wall(NaN, NaN, NaN, 0.5)).toBe(false);
  });
});
