/** Where in the picture a feature lies: its contours at its bottom, in the coordinates of the machine. */
import { feature_of, type FeaturesDocument, hole_of, is_turned, type ToldVertex } from './document';
import { elements_of } from './elements';
import { points_of } from './outline_points';
import type { TreeNode } from './tree';

export type Place = [number, number, number];

export interface Region {
  /** Each an outline, with what stands in it behind it. */
  outlines: Place[][];
  /** They enclose something, which is filled. */
  is_closed: boolean;
}

/** `zero`: of a lathe, where the zero of its work lies. Null: there is nothing to be seen of it. */
export function region_of(
  document: FeaturesDocument,
  { target, layer }: TreeNode,
  zero: { x: number; z: number } | null,
): Region | null {
  const feature = feature_of(document, target);
  const hole = hole_of(document, target);
  const of_pattern = document.patterns.find(({ id }) => id === target)?.holes ?? [];
  const holes = hole ? [hole] : of_pattern.flatMap((id) => hole_of(document, id) ?? []);
  if (holes.length) {
    const outlines = holes.map((each) => {
      const r = each.diameter / 2;
      const [x, y] = each.at;
      const halves: ToldVertex[] = [
        [x - r, y, 1],
        [x + r, y, 1],
      ];
      return placed(halves, origin_of(document, each.setup), each.z[0]);
    });
    return { outlines, is_closed: true };
  }
  if (!feature) return null;
  if (is_turned(feature)) return half_section(feature.contour, zero ?? { x: 0, z: 0 });
  const shown = feature.layers.find(({ n }) => n === layer) ?? feature;
  const z = 'n' in shown ? shown.z : feature.z[1];
  const origin = origin_of(document, feature.setup);
  const contours = [shown.contour, ...(shown.islands ?? [])];
  return { outlines: contours.map((told) => placed(told, origin, z)), is_closed: true };
}

function origin_of({ setups }: FeaturesDocument, id: string): Place {
  const origin = setups.find((setup) => setup.id === id)?.origin ?? {};
  return ['X', 'Y', 'Z'].map((axis) => origin[axis] ?? 0) as Place;
}

const placed = (told: ToldVertex[], [ox, oy, oz]: Place, z: number): Place[] =>
  points_of(elements_of(told, true), true).map(([x, y]): Place => [ox + x, oy + y, oz + z]);

function half_section(told: ToldVertex[], zero: { x: number; z: number }): Region {
  const points = points_of(elements_of(told, false, true), false);
  const outline = points.map(([z, radius]): Place => [zero.x + radius, 0, zero.z + z]);
  return { outlines: [outline], is_closed: false };
}
