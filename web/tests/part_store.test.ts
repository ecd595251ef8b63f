import { describe, expect, it } from 'vitest';
import { HeightField, VOID } from '../src/logic/stock/height_field';
import { PartStore } from '../src/logic/stock/part_store';
import { SheetField } from '../src/logic/stock/sheet_field';
import { decode_stock_frame, NOTHING_LEFT } from '../src/logic/stock/stock_frame';
import { height_bytes, StockBytes } from './stock_bytes';

const told = {
  event: 'stock',
  machine: 'mill',
  run: 5,
  model: 'zmap',
  stock: { origin: [100, 50, -80], low: [0, 0, -10], high: [4, 3, 0] },
  levels: [
    { first: [0.5, 0.5], cell_mm: [1, 1], cells: [4, 3] },
    { first: [0.25, 0.25], cell_mm: [0.5, 0.5], cells: [8, 6] },
  ],
  files: ['O1.nc'],
};
const frame = (
  heights: number[],
  wish: { number?: number; level?: number; nx?: number; run?: number; owner?: number[] } = {},
) =>
  decode_stock_frame(
    height_bytes(0, 0, wish.nx ?? 4, heights, { run: 5, z0: -10, dz: 0.5, ...wish }),
  );
const twelve = (value: number): number[] => Array.from({ length: 12 }, () => value);

function store(): PartStore {
  const part = new PartStore();
  part.take_event(told);
  return part;
}
function field_of(part: PartStore): HeightField {
  if (part.shape?.kind !== 'heights') throw new Error(String(part.shape?.kind));
  return part.shape.field;
}

describe('what is known of the part', () => {
  it('is the uncut stock until tiles come, and then what they say', () => {
    const part = store();
    expect(part.take_frame(frame(twelve(20), { owner: twelve(3) }))).toBe(true);
    const field = field_of(part);
    expect(field.height_at(0.2, 0.2)).toBe(0);
    part.take_frame(frame([0, NOTHING_LEFT, ...twelve(20).slice(2)], { number: 1 }));
    expect(field_of(part)).toBe(field);
    expect(field.height_at(0.2, 0.2)).toBe(-10);
    expect(field.height_at(1.5, 0.5)).toBeNull();
    expect(field.height_at(-0.1, 0.5)).toBeNull();
    expect(field.owner_at(3.5, 2.5)).toBe(0);
  });

  it('keeps what an event does not tell again, and nothing of another run', () => {
    const part = store();
    part.take_event({ event: 'stock', run: 5, done_s: 3 });
    expect(part.facts).toMatchObject({ model: 'zmap', done_s: 3 });
    part.take_event({ event: 'stock', run: 6 });
    expect(part.facts).toMatchObject({ model: '', done_s: 0, findings: [] });
  });

  it('collects owners in the order of their numbers', () => {
    const part = store();
    part.take_event({
      owners: {
        from: 0,
        rows: [
          [0, 0, 0],
          [0, 7, 1],
        ],
      },
    });
    part.take_event({ owners: { from: 2, rows: [[0, 9, 2]] } });
    expect(part.owners[2]).toEqual({ file: 0, line: 9, tool: 2, engagement_deg: null });
    part.take_event({ owners: { from: 2, rows: [[0, 9, 2, 53.1]] } });
    expect(part.owners[2].engagement_deg).toBe(53.1);
    part.take_event({ owners: { from: 0, rows: [[0, 0, 0]] } });
    expect(part.owners.length).toBe(1);
  });

  it('a finer level looks like the coarse one until its tiles are there', () => {
    const part = store();
    part.take_frame(frame([0, ...twelve(20).slice(1)], { owner: twelve(4) }));
    part.take_frame(frame(twelve(10).slice(0, 4), { level: 1, nx: 2 }));
    const field = field_of(part);
    expect(field.grid.nx).toBe(8);
    expect(field.height_at(0.1, 0.1)).toBe(-5);
    expect(field.height_at(2.1, 0.1)).toBe(0);
    expect(field.owner_at(3.9, 2.9)).toBe(4);
  });

  it('begins anew with the first frame of another pass', () => {
    const part = store();
    part.take_frame(frame(twelve(4)));
    part.take_frame(frame([20], { number: 0, nx: 1, run: 6 }));
    expect(field_of(part).height_at(3, 2)).toBe(0);
  });

  it('shows no frame of a level that nobody has told', () => {
    const part = store();
    expect(part.take_frame(frame(twelve(4), { level: 2 }))).toBe(false);
    part.take_event({ run: 5, levels: [{ first: [0, 0], cell_mm: [1, 1], cells: [1e6, 1e6] }] });
    expect(part.take_frame(frame(twelve(4)))).toBe(false);
  });

  it('drops tiles of triangles that are empty now', () => {
    const mesh = (triangles: boolean) => {
      const bytes = new StockBytes(1, { run: 5, number: triangles ? 0 : 1 }).words(1, 2, 3);
      return decode_stock_frame(
        (triangles
          ? bytes
              .words(3, 1)
              .floats(0, 0, 0, 1)
              .halves(0, 0, 0, 1, 0, 0, 0, 1, 0)
              .bytes(0, 0, 0, 0, 0, 0)
              .halves(0, 0, 0)
              .halves(0, 1, 2)
          : bytes.words(0, 0).floats(0, 0, 0, 1)
        )
          .part()
          .made(),
      );
    };
    const part = store();
    part.take_frame(mesh(true));
    if (part.shape?.kind !== 'mesh') throw new Error();
    expect([...part.shape.tiles.keys()]).toEqual(['1 2 3']);
    part.take_frame(mesh(false));
    expect(part.shape.tiles.size).toBe(0);
    expect([...part.shape.changed]).toEqual(['1 2 3']);
  });
});

describe('tiles of a field', () => {
  const grid = {
    nx: 200,
    ny: 150,
    cell: [1, 1] as [number, number],
    corner: [0, 0, -9] as never,
    top: 0,
  };
  const tile = (x: number, y: number, at: number, nx = 65, ny = 65) => {
    const height = new Uint16Array(nx * ny).fill(9);
    height[at] = 1;
    return { x, y, nx, ny, z0: -9, dz: 1, height, owner: new Uint16Array(nx * ny) };
  };
  it('make only those triangles old that a changed column bears upon', () => {
    const field = new HeightField(grid);
    expect(field.changed.size).toBe(4 * 3);
    field.changed.clear();
    field.put(tile(1, 1, 30 * 65 + 30));
    expect([...field.changed]).toEqual([field.tile_key(1, 1)]);
    field.changed.clear();
    field.put(tile(1, 1, 30 * 65 + 30));
    expect(field.changed.size).toBe(0);
    field.put(tile(2, 1, 30 * 65 + 2));
    expect([...field.changed].sort()).toEqual([field.tile_key(1, 1), field.tile_key(2, 1)].sort());
  });
  it('beside the part are left out, and those over its border are cut off', () => {
    const field = new HeightField(grid);
    expect(field.put(tile(9, 0, 0))).toBe(false);
    expect(field.put(tile(-1, 0, 0))).toBe(false);
    expect(field.put(tile(3, 2, 7))).toBe(true);
    expect(field.heights[128 * 200 + 199]).toBe(-8);
  });
});

describe('a sheet', () => {
  const sheet = (cut: (i: number, j: number) => boolean): SheetField => {
    const field = new SheetField({ nx: 40, ny: 30, cell: [1, 1], corner: [0, 0, -1], top: 0 });
    const coverage = new Uint8Array(40 * 30);
    for (let j = 0; j < 30; j++)
      for (let i = 0; i < 40; i++) coverage[j * 40 + i] = cut(i, j) ? 255 : 0;
    field.put({ x: 0, y: 0, nx: 40, ny: 30, full_scale: 10, energy: coverage, coverage });
    return field;
  };
  const ring = (i: number, j: number): boolean =>
    Math.max(Math.abs(i - 20), Math.abs(j - 15)) === 6;

  it('is one piece that is held while nothing is cut through', () => {
    expect(sheet(() => false).pieces()).toMatchObject([{ falls: false }]);
    expect(sheet((i, j) => ring(i, j) && !(i === 26 && j === 15)).pieces().length).toBe(1);
  });
  it('loses what is cut out, and holds what reaches its border', () => {
    const [rest, square] = sheet(ring).pieces();
    expect(rest.falls).toBe(false);
    expect(square).toMatchObject({ falls: true });
    expect(square.cells.length).toBe(11 * 11);
    const halves = sheet((i) => i === 13).pieces();
    expect(halves.map(({ falls }) => falls)).toEqual([false, false]);
  });
  it('knows its hottest cell in J/mm²', () => expect(sheet(ring).peak).toBeCloseTo(10, 6));
  it('VOID is below everything', () => expect(VOID < -1e30).toBe(true));
});
