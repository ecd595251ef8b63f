/** What is typed into a cell of an offset or a tool: set or added, and whether it is to be asked about first. */
import { typed_number } from './format';
import type { AxisDefinition } from './protocol';

/** As on a control: INPUT sets the value, +INPUT adds to it. */
export type How = 'input' | '+input';

/** The new value; undefined: this is no number. To six decimals, so that 0.1 + 0.2 is 0.3. */
export function entered(text: string, how: How, before: number | null): number | null | undefined {
  const typed = typed_number(text);
  if (how === 'input' || typed === undefined || typed === null) return typed;
  return Math.round(((before ?? 0) + typed) * 1e6) / 1e6;
}

/** Why an entry is asked about: its value is farther than the axis can go, or far from what it was. */
export type Doubt = { kind: 'beyond'; most: number } | { kind: 'far'; by: number };

/** `most`: no value is larger, of either sign; null: no such limit. `step`: no change is larger without a question. */
export function doubt_of(
  value: number,
  before: number,
  most: number | null,
  step: number,
): Doubt | null {
  if (most !== null && Math.abs(value) > most) return { kind: 'beyond', most };
  const by = Math.abs(value - before);
  return by > step + 1e-9 ? { kind: 'far', by } : null;
}

/** An offset lies within the machine: it is at most as long as all the travel of its axis. Null: it turns without end. */
export function travel_of(axis: AxisDefinition | undefined): number | null {
  if (!axis || axis.min === null || axis.max === null) return null;
  return Math.max(axis.max - axis.min, Math.abs(axis.max), Math.abs(axis.min));
}

/** A tool is not longer than the longest way of the machine. */
export function longest_travel(axes: readonly AxisDefinition[]): number | null {
  const all = axes.filter((axis) => !axis.rotary).map(travel_of);
  const known = all.filter((travel) => travel !== null);
  return known.length ? Math.max(...known) : null;
}
