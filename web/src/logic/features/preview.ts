/** What the server answers to edits before they are made: the contour behind them, new paths, what is cut more and less, the changed lines. */
import type { ToldVertex } from './document';
import type { Outline } from './steps';

export interface EditProblem {
  /** From 0; null: none of them alone. */
  edit: number | null;
  code: string;
  message: string;
  hint: string;
  /** Where it fails. */
  at: [number, number] | null;
}

export interface PreviewContour {
  feature: string;
  layer: number;
  island: number | null;
  closed: boolean;
  elements: { id: number; from: [number, number]; to: [number, number]; bulge: number }[];
}

export interface Regions {
  feature: string;
  layer: number;
  regions: ToldVertex[][];
}

export interface EditReport {
  blocks: { kept: number; patched: number; inserted: number; removed: number };
  verified?: {
    difference_mm3: number;
    corner_rest_mm2: number;
    new_findings: unknown[];
    time_s: [number, number];
  };
  warnings: { code: string; message: string }[];
}

export interface Preview {
  revision: number;
  problem: EditProblem | null;
  contours: PreviewContour[];
  loops?: { feature: string; layer: number; z: number; paths: ToldVertex[][] }[];
  added?: Regions[];
  removed?: Regions[];
  rest?: Regions[];
  diff?: string;
  blocks?: EditReport['blocks'];
  report?: EditReport;
}

/** Of one feature and layer (otherwise its first one), the outer one and its islands; null: the answer has none of it. */
export function outlines_of(
  { contours }: Preview,
  feature: string,
  layer: number | null,
  turned: boolean,
): Outline[] | null {
  const own = contours.filter((contour) => contour.feature === feature);
  const wanted = layer ?? Math.min(...own.map((contour) => contour.layer));
  const shown = own.filter((contour) => contour.layer === wanted);
  if (!shown.length) return null;
  const in_plane = ([x, y]: [number, number]): [number, number] => [x, turned ? y / 2 : y];
  return shown.map(({ island, closed, elements }) => ({
    island,
    is_closed: closed,
    elements: elements.map(({ id, from, to, bulge }) => ({
      id,
      from: in_plane(from),
      to: in_plane(to),
      bulge,
    })),
  }));
}

/** Contours of a layer, otherwise of the first one: those of several would lie upon each other. */
export function of_layer(list: Regions[] | undefined, layer: number | null): ToldVertex[][] {
  const all = list ?? [];
  const wanted = layer ?? Math.min(...all.map((each) => each.layer));
  return all.filter((each) => each.layer === wanted).flatMap(({ regions }) => regions);
}
