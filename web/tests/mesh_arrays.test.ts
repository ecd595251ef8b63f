import { expect, it } from 'vitest';
import { MeshArrays } from '../src/logic/stock/mesh_arrays';

function plate(x0: number, x1: number, z: number) {
  const out = new MeshArrays();
  out.plate(x0, 0, x1, 1, z, 1);
  out.line_if(0, 1, true);
  return out.made();
}

it('tiles put together have the triangles, normals and lines of each', () => {
  const [a, b] = [plate(0, 1, 5), plate(2, 4, 6)];
  const all = new MeshArrays();
  all.add(a);
  all.add(b);
  const { positions, normals, indices, lines } = all.made();
  expect([...positions]).toEqual([...a.positions, ...b.positions]);
  expect([...normals]).toEqual([...a.normals, ...b.normals]);
  expect([...indices]).toEqual([...a.indices, ...[...b.indices].map((i) => i + 4)]);
  expect([...lines]).toEqual([...a.lines, ...b.lines]);
});

it('more than their arrays had room for find room', () => {
  const all = new MeshArrays();
  const one = plate(0, 1, 0);
  for (let i = 0; i < 5000; i++) all.add(one);
  const { positions, lines, indices } = all.made();
  expect([positions.length, lines.length, indices.length]).toEqual([60_000, 30_000, 30_000]);
  expect(Math.max(...indices)).toBe(19_999);
});
