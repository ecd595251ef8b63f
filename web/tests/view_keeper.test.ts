import { beforeEach, describe, expect, it } from 'vitest';
import { ViewKeeper } from '../src/logic/view_keeper';

let view: ViewKeeper;
beforeEach(() => {
  view = new ViewKeeper();
  view.arrives(1, 'part.nc');
});

describe('the picture', () => {
  it('goes with the path until a hand turns it', () => {
    expect(view.goes_with_path).toBe(true);
    view.hand();
    expect(view.goes_with_path).toBe(false);
    expect(view.arrives(1, 'part.nc')).toBe(false);
    expect(view.goes_with_path).toBe(false);
  });
  it('goes with the path of another program', () => {
    view.hand();
    expect(view.arrives(2, '')).toBe(false);
    expect(view.arrives(2, 'other.nc')).toBe(true);
    expect(view.goes_with_path).toBe(true);
  });
  it('stays when the same program is loaded again', () => {
    view.hand();
    expect(view.arrives(2, 'part.nc')).toBe(true);
    expect(view.goes_with_path).toBe(false);
  });
  it('goes with the path of another machine', () => {
    view.hand();
    view.forget();
    expect(view.arrives(1, 'part.nc')).toBe(true);
    expect(view.goes_with_path).toBe(true);
  });
});
