/** What is known of places of the part besides where they are, put where the places are. */
import type { Shape } from './part_store';
import { deviations_of, type FactTile, type ProfileLoop } from './stock_frame';

/** What is of no tile that is there, or of one with other places, is left out. */
export function put_facts(shape: Shape, tile: FactTile): void {
  if (shape.kind === 'profile') put_on_loops(shape, tile);
  else if (tile.what === 'owner')
    return; // all others have brought theirs
  else if (shape.kind === 'heights') shape.field.put_deviation(tile.x, tile.y, deviations_of(tile));
  else if (shape.kind === 'mesh') put_on_mesh(shape, tile);
}

function put_on_mesh({ tiles, changed }: Shape & { kind: 'mesh' }, tile: FactTile): void {
  const key = `${tile.x} ${tile.y} ${tile.z}`;
  const known = tiles.get(key);
  if (known?.owner.length !== tile.value.length) return;
  tiles.set(key, { ...known, deviation: deviations_of(tile) });
  changed.add(key);
}

function put_on_loops(shape: Shape & { kind: 'profile' }, tile: FactTile): void {
  const loops = (shape.next ?? shape.loops).map((loop, i) =>
    i === tile.x && loop.z.length === tile.value.length ? { ...loop, ...facts_of(tile) } : loop,
  );
  const waits = shape.next && loops.some(({ owner }) => owner === undefined);
  if (waits) {
    shape.next = loops;
  } else {
    shape.loops = loops;
    shape.next = null;
  }
}

const facts_of = (tile: FactTile): Partial<ProfileLoop> =>
  tile.what === 'owner'
    ? { owner: Uint16Array.from(tile.value) }
    : { deviation: deviations_of(tile) };
