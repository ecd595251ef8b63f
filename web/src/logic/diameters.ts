/** Positions of an axis may be diameters, twice its way; joints and paths of the picture are the way itself, mm. */
import type { AxisDefinition } from './protocol';

export const DIAMETER = 'Ø';

const count_per_mm = (axis: AxisDefinition | undefined): number => (axis?.diameter ? 2 : 1);

/** What the position shows while the axis has gone so far. */
export const counted = (axis: AxisDefinition | undefined, way_mm: number): number =>
  way_mm * count_per_mm(axis);

export const way_of = (axis: AxisDefinition | undefined, shown: number): number =>
  shown / count_per_mm(axis);

/** The letter of an axis, with the sign of a diameter. */
export const letter_of = (axis: AxisDefinition): string =>
  axis.diameter ? `${axis.name}${DIAMETER}` : axis.name;
