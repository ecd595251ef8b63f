// Programs whose features the scenarios look at and edit: those of tests/programs/features.
import { readFileSync } from 'node:fs';

const text = (name) =>
  readFileSync(new URL(`../programs/features/${name}`, import.meta.url), 'utf8');

/** A pocket of two layers, a profile, a round pocket and two holes. */
export const P1 = text('p1.nc');
/** A pocket whose two layers are one loop. */
export const LOOPED = text('looped.nc');
/** Two frames by a macro: how large they are stands in the calls. */
export const FRAMED = text('framed.nc');
/** The shape of a roughing cycle, and what it is turned from, and with. */
export const SHAPE = text('shape.nc');
export const SHAPE_SETUP = text('shape.toml');
