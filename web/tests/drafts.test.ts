import { expect, it } from 'vitest';
import { type Draft, DraftKeeper, type DraftStore } from '../src/logic/drafts';

class Memory implements DraftStore {
  drafts = new Map<string, Draft>();
  writes: string[] = [];
  broken = false;
  async get(name: string) {
    return this.drafts.get(name) ?? null;
  }
  async put(draft: Draft) {
    await null;
    if (this.broken) throw new Error('full');
    this.writes.push(draft.text);
    this.drafts.set(draft.name, draft);
  }
  async remove(name: string) {
    this.writes.push(`-${name}`);
    this.drafts.delete(name);
  }
}

const draft = (text: string, name = 'a.nc'): Draft => ({ name, text, at: 1 });

it('a draft is kept until it is taken away', async () => {
  const store = new Memory();
  const keeper = new DraftKeeper(store);
  keeper.keep('a.nc', draft('one'));
  expect(await keeper.of('a.nc')).toEqual(draft('one'));
  await keeper.written();
  expect(store.drafts.get('a.nc')?.text).toBe('one');
  keeper.keep('a.nc', null);
  expect(await keeper.of('a.nc')).toBeNull();
  await keeper.written();
  expect(store.drafts.size).toBe(0);
});

it('of edits that come faster than they are written the newest is', async () => {
  const store = new Memory();
  const keeper = new DraftKeeper(store);
  for (const text of ['1', '12', '123']) keeper.keep('a.nc', draft(text));
  await keeper.written();
  expect(store.writes).toEqual(['123']);
});

it('an edit while the last one is written comes after it', async () => {
  const store = new Memory();
  const keeper = new DraftKeeper(store);
  keeper.keep('a.nc', draft('1'));
  await null;
  keeper.keep('a.nc', draft('2'));
  keeper.keep('b.nc', draft('3', 'b.nc'));
  await keeper.written();
  expect(store.writes).toEqual(['1', '2', '3']);
});

it('a page that is left takes along no edit that waits for another', async () => {
  const store = new Memory();
  const asked: string[] = [];
  store.put = (made: Draft) => (asked.push(made.text), new Promise(() => {}));
  const keeper = new DraftKeeper(store);
  keeper.keep('a.nc', draft('1'));
  await null;
  keeper.keep('a.nc', draft('12'));
  keeper.keep('b.nc', draft('3', 'b.nc'));
  expect(asked).toEqual(['1']);
  keeper.leave();
  expect(asked).toEqual(['1', '12', '3']);
});

it('a browser that keeps nothing does no harm', async () => {
  const store = new Memory();
  store.broken = true;
  const keeper = new DraftKeeper(store);
  keeper.keep('a.nc', draft('1'));
  await keeper.written();
  expect(await keeper.of('a.nc')).toBeNull();
});
