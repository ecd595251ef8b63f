import { describe, expect, it } from 'vitest';
import { deviation_stops, luminance } from '../src/logic/colour_scale';
import { hit_of_field } from '../src/logic/stock/field_ray';
import { colourings_of, legend_of } from '../src/logic/stock/part_colours';
import { PartStore } from '../src/logic/stock/part_store';
import { decode_stock_frame, NO_DEVIATION } from '../src/logic/stock/stock_frame';
import { height_bytes, StockBytes } from './stock_bytes';

const event = {
  event: 'stock',
  run: 5,
  model: 'zmap',
  stock: { origin: [0, 0, 0], low: [0, 0, -10], high: [4, 3, 0] },
  levels: [{ first: [0.5, 0.5], cell_mm: [1, 1], cells: [4, 3] }],
};
const twelve = (value: number): number[] => Array.from({ length: 12 }, () => value);
const facts = (values: number[], wish: { run?: number; x?: number; what?: number } = {}) =>
  decode_stock_frame(
    new StockBytes(4, { run: wish.run ?? 5, number: 1 })
      .words(wish.x ?? 0, 0, 0)
      .halves(wish.what ?? 0, 0)
      .words(values.length)
      .floats(0.01)
      .halves(...values)
      .part()
      .made(),
  );
const heights = (number = 0, height = twelve(20)) =>
  decode_stock_frame(height_bytes(0, 0, 4, height, { run: 5, number, z0: -10, dz: 0.5 }));

function store(change: Record<string, unknown> = {}): PartStore {
  const part = new PartStore();
  part.take_event({ ...event, ...change });
  part.take_frame(heights());
  return part;
}
function deviation(part: PartStore): Float32Array | null {
  if (part.shape?.kind !== 'heights') throw new Error();
  return part.shape.field.deviation;
}

describe('facts of places', () => {
  it('are kept with their columns until these are others', () => {
    const part = store();
    expect(deviation(part)).toBeNull();
    expect(part.take_frame(facts([...twelve(5).slice(1), -32768]))).toBe(true);
    expect(deviation(part)![0]).toBeCloseTo(0.05, 6);
    expect(deviation(part)![11]).toBe(NO_DEVIATION);
    part.take_frame(heights(2, [19, ...twelve(20).slice(1)]));
    expect(deviation(part)![0]).toBe(NO_DEVIATION);
    expect(deviation(part)![1]).toBeCloseTo(0.05, 6);
  });
  it.each([
    ['another run', facts(twelve(1), { run: 4 }), false],
    ['a tile that is not there', facts(twelve(1), { x: 9 }), true],
    ['other columns than there are', facts([1, 2, 3]), true],
    ['owners, which columns have brought themselves', facts(twelve(1), { what: 1 }), true],
  ])('are left out where they are of %s', (_, frame, is_taken) => {
    const part = store();
    expect(part.take_frame(frame)).toBe(is_taken);
    expect(deviation(part)).toBeNull();
  });
  it('are told of the place that a line of sight meets', () => {
    const part = store();
    part.take_frame(facts(twelve(-7)));
    if (part.shape?.kind !== 'heights') throw new Error();
    const hit = hit_of_field(part.shape.field, [1.5, 1.5, 50], [0, 0, -1]);
    expect(hit!.deviation).toBeCloseTo(-0.07, 6);
  });
  it('say of a turned part who has cut its pieces', () => {
    const part = new PartStore();
    part.take_event({ ...event, model: 'profile' });
    const loop = new StockBytes(2, { run: 5 }).words(2).doubles(-9, 0, 0, 0, 4, 0).part().made();
    part.take_frame(decode_stock_frame(loop));
    expect(colourings_of(part)).toEqual(['stock']);
    part.take_frame(facts([1, -1], { what: 1 }));
    if (part.shape?.kind !== 'profile') throw new Error();
    expect([...part.shape.loops[0].owner!]).toEqual([1, 65535]);
    expect(colourings_of(part)).toEqual(['tool', 'line', 'stock']);
  });
  it('of a turned part replace it together with its lines, so that no colour flickers', () => {
    const part = new PartStore();
    part.take_event({ ...event, model: 'profile' });
    const lines = (number: number, rho: number) =>
      decode_stock_frame(
        new StockBytes(2, { run: 5, number })
          .words(2)
          .doubles(-9, 0, 0, 0, rho, 0)
          .part()
          .words(2)
          .doubles(-9, 0, 0, -20, rho, 0)
          .part()
          .made(),
      );
    const radii = () => part.shape?.kind === 'profile' && part.shape.loops.map(({ rho }) => rho[1]);
    part.take_frame(lines(0, 4));
    expect(radii()).toEqual([4, 4]);
    part.take_frame(facts([1, 1], { what: 1 }));
    part.take_frame(facts([1, 1], { what: 1, x: 1 }));
    part.take_frame(lines(1, 3));
    expect(radii()).toEqual([4, 4]);
    part.take_frame(facts([2, 1], { what: 1 }));
    expect(radii()).toEqual([4, 4]);
    part.take_frame(facts([7, 7]));
    part.take_frame(facts([2, 1], { what: 1, x: 1 }));
    expect(radii()).toEqual([3, 3]);
    if (part.shape?.kind !== 'profile') throw new Error();
    expect(part.shape.loops[0].deviation![0]).toBeCloseTo(0.07, 6);
    expect([...part.shape.loops[0].owner!]).toEqual([2, 1]);
    part.take_frame(lines(0, 2));
    expect(radii()).toEqual([2, 2]);
  });
});

describe('a part is coloured', () => {
  const rows = [
    [0, 0, 0],
    [0, 5, 3],
    [0, 6, 1, 40],
    [0, 7, 3],
  ];
  it('by what is known of it', () => {
    expect(colourings_of(store())).toEqual(['tool', 'line', 'stock']);
    const all = store({
      owners: { from: 0, rows },
      design: { file: 'part.stl', tolerance_mm: 0.05 },
    });
    expect(colourings_of(all)).toEqual(['tool', 'line', 'engagement', 'deviation', 'stock']);
  });
  it('with a legend of the tools that have cut, or a scale', () => {
    const part = store({ owners: { from: 0, rows }, design: { file: '', tolerance_mm: 0.05 } });
    expect(legend_of('tool', part, 'dark')).toEqual({ kind: 'tools', tools: [1, 3] });
    expect(legend_of('engagement', part, 'dark')).toMatchObject({
      low: 0,
      high: 180,
      marks: [0, 45, 90, 135, 180],
    });
    expect(legend_of('deviation', part, 'dark')).toMatchObject({ low: -0.1, high: 0.1 });
    expect(legend_of('line', part, 'dark')).toBeNull();
    expect(legend_of('energy', part, 'dark')).toBeNull();
  });
  it('by deviations whose middle is the lightest, so that both ways read in grey', () => {
    const shades = deviation_stops().map(luminance);
    expect(shades[2]).toBe(Math.max(...shades));
    expect(shades[0]).toBeLessThan(shades[1]);
    expect(shades[4]).toBeLessThan(shades[3]);
  });
});
