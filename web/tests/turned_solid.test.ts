import { describe, expect, it } from 'vitest';
import { NO_DEVIATION, type ProfileLoop } from '../src/logic/stock/stock_frame';
import { outline_of, revolved, ring_of } from '../src/logic/stock/turned_solid';

const loop = (...corners: [number, number, number?][]): ProfileLoop => ({
  z: Float64Array.from(corners, ([z]) => z),
  rho: Float64Array.from(corners, ([, rho]) => rho),
  bulge: Float64Array.from(corners, ([, , bulge]) => bulge ?? 0),
});
const bar = loop([-40, 0], [0, 0], [0, 10], [-40, 10]);
const QUARTER = Math.tan(Math.PI / 8);

/** Of the shell with the faces of the sector: both faces have the axis in their plane. */
function volume(loops: ProfileLoop[], open_rad = 0): number {
  const { positions: p, indices } = revolved(outline_of(loops), open_rad);
  let sum = 0;
  for (let t = 0; t < indices.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((n) => [
      ...p.slice(3 * indices[t + n], 3 * indices[t + n] + 3),
    ]);
    sum +=
      (a[0] * (b[1] * c[2] - b[2] * c[1]) -
        a[1] * (b[0] * c[2] - b[2] * c[0]) +
        a[2] * (b[0] * c[1] - b[1] * c[0])) /
      6;
  }
  return sum;
}

describe('a turned solid', () => {
  // 96 chords of a circle have sin(2π/96)/(2π/96) of its area.
  const chords = Math.sin((2 * Math.PI) / 96) / ((2 * Math.PI) / 96);
  it('has the volume of its half section turned about the axis', () => {
    expect(volume([bar]) / (Math.PI * 100 * 40 * chords)).toBeCloseTo(1, 5);
  });
  it('is the same whichever way its loops turn', () => {
    const other = loop([-40, 10], [0, 10], [0, 0], [-40, 0]);
    expect(volume([other])).toBeCloseTo(volume([bar]), 6);
  });
  it('has round arcs: a hemisphere, and a groove of a half circle', () => {
    const hemisphere = loop([0, 0], [10, 0, QUARTER], [0, 10]);
    expect(volume([hemisphere]) / ((2 / 3) * Math.PI * 1000 * chords)).toBeCloseTo(1, 2);
    const groove = loop([-40, 0], [0, 0], [0, 10], [-15, 10, -1], [-25, 10], [-40, 10]);
    const lost = Math.PI * 100 * 40 - volume([groove]) / chords;
    // Pappus: half a disc of radius 5 whose centroid lies 4 r / 3 π below the surface.
    expect(lost / (2 * Math.PI * (10 - 20 / (3 * Math.PI)) * ((25 * Math.PI) / 2))).toBeCloseTo(
      1,
      1,
    );
  });
  it('loses what a hole in its section encloses, whichever way that turns', () => {
    const cavity = [
      [-30, 2],
      [-10, 2],
      [-10, 6],
      [-30, 6],
    ] as [number, number][];
    const lost = Math.PI * (36 - 4) * 20 * chords;
    for (const hole of [cavity, [...cavity].reverse()])
      expect(volume([bar]) - volume([bar, loop(...hole)])).toBeCloseTo(lost, 3);
  });
  it('with a sector cut out has that share less, and the sector opens from X to Y', () => {
    const { positions } = revolved(outline_of([bar]), Math.PI / 2);
    for (let v = 0; v < positions.length; v += 3)
      expect(positions[v] > 1e-4 && positions[v + 1] > 1e-4).toBe(false);
    // The axis lies in both faces, so they add nothing.
    expect(volume([bar], Math.PI / 2) / volume([bar])).toBeCloseTo(0.75, 2);
  });
  it('has normals that point out of the material', () => {
    const { positions, normals } = revolved(outline_of([bar]), 0);
    for (let v = 0; 3 * v < positions.length; v++) {
      const radial = positions[3 * v] * normals[4 * v] + positions[3 * v + 1] * normals[4 * v + 1];
      if (normals[4 * v + 2] === 0 && Math.hypot(positions[3 * v], positions[3 * v + 1]) > 1)
        expect(radial).toBeGreaterThan(0);
      else if (normals[4 * v + 2])
        expect(Math.sign(normals[4 * v + 2])).toBe(positions[3 * v + 2] > -1 ? 1 : -1);
    }
  });
  it('has a line round each edge and none along a smooth joint', () => {
    const rounded = loop([-40, 0], [0, 0], [0, 8, QUARTER], [-2, 10], [-40, 10]);
    const edges = (loops: ProfileLoop[]) => revolved(outline_of(loops), 0).lines.length / 6 / 96;
    expect(edges([bar])).toBe(2);
    expect(edges([rounded])).toBe(1);
  });
  it('shows a thread as a helix of its starts', () => {
    const thread = { line: 1, from: 0, to: -20, major: 20, minor: 17, pitch: 2, starts: 2 };
    const bare = revolved(outline_of([bar]), 0).lines.length;
    const { lines } = revolved(outline_of([bar]), 0, [thread]);
    expect((lines.length - bare) / 6 / 48).toBeCloseTo(2 * 5, 0);
    const z = [...lines.slice(bare)].filter((_, i) => i % 3 === 2);
    expect(Math.min(...z)).toBeGreaterThanOrEqual(-20);
    expect(Math.max(...z)).toBe(0);
  });
  it('is nothing where nothing is left', () => {
    expect(outline_of([loop()])).toEqual([]);
    expect(revolved([], 0).indices.length).toBe(0);
    expect(ring_of(outline_of([bar])[0]).length).toBe(4);
  });

  it('tells of each place who has cut it and how far off it is, whichever way the loop turns', () => {
    const facts = (l: ProfileLoop, owner: number[], deviation: number[]): ProfileLoop => ({
      ...l,
      owner: Uint16Array.from(owner),
      deviation: Float32Array.from(deviation),
    });
    const there = facts(bar, [1, 2, 3, 4], [0, 0.5, 1, NO_DEVIATION]);
    const back = facts(
      loop([-40, 10], [0, 10], [0, 0], [-40, 0]),
      [3, 2, 1, 4],
      [NO_DEVIATION, 1, 0.5, 0],
    );
    for (const one of [there, back]) {
      const solid = revolved(outline_of([one]), 0);
      const seen = new Map<number, Set<number>>();
      solid.owners.forEach((owner, i) => {
        if (!seen.has(owner)) seen.set(owner, new Set());
        seen.get(owner)!.add(solid.deviations[i]);
      });
      // The line along the axis is no surface; the face at Z0 runs from its middle to its rim.
      expect([...seen.keys()].sort()).toEqual([2, 3, 4]);
      expect([...seen.get(2)!].sort()).toEqual([0.5, 1]);
      expect([...seen.get(3)!]).toEqual([NO_DEVIATION]);
    }
  });
});
