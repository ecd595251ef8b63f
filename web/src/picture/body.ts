/** The part as one of its models draws it. */
import type { Object3D } from 'three';
import type { Finding, Owner } from '../logic/stock/part_store';
import type { Section } from './section_plane';
import type { SurfaceColours } from './stock_material';

export type Vec = [number, number, number];

export interface BodyHit {
  /** From the zero of the stock. */
  at: Vec;
  normal: Vec;
  /** 0: not cut, or not known. */
  owner: number;
  /** As deviations_of() has it. */
  deviation: number;
}

export interface Body {
  readonly group: Object3D;
  /** Brings what is drawn up to date, for at most so long. True: it is. `coarse`: a picture that moves, on a slow computer. */
  update(most_ms: number, coarse: boolean): boolean;
  /** Something of it moves by itself, and is to be drawn again. */
  readonly moves?: boolean;
  set_colours(colours: SurfaceColours): void;
  /** Colours by deviation, on a scale to so many millimetres; 0: by the motions that have cut. */
  set_deviation(most_mm: number): void;
  set_section(section: Section | null): void;
  hit(from: Vec, way: Vec): BodyHit | null;
  dispose(): void;
}

export type { Finding, Owner, Section };
