/** A height field in the picture: in all its cells, and in fewer of them while the picture moves and the computer is slow. */
import { Group, type Texture } from 'three';
import { hit_of_field } from '../logic/stock/field_ray';
import { CoarseField } from '../logic/stock/coarse_field';
import { far_corner, type HeightField } from '../logic/stock/height_field';
import type { Body, BodyHit, Section, Vec } from './body';
import { FieldBody } from './field_body';
import { plane_of, SectionPlane } from './section_plane';
import type { SurfaceColours } from './stock_material';

/** Along the longer side, of what moves. */
const COLUMNS = 180;
const SOFTWARE_COLUMNS = 110;

export class HeightsBody implements Body {
  readonly group = new Group();
  private readonly fine: FieldBody;
  private readonly coarse: FieldBody | null;
  private readonly coarse_field: CoarseField | null;
  private readonly plane: SectionPlane;
  private section: Section | null = null;

  constructor(
    readonly field: HeightField,
    table: Texture,
    by_software: boolean,
  ) {
    this.fine = new FieldBody(field, table);
    this.coarse_field = CoarseField.of(field, by_software ? SOFTWARE_COLUMNS : COLUMNS);
    this.coarse = this.coarse_field && new FieldBody(this.coarse_field.field, table, this.fine);
    this.plane = new SectionPlane(this.fine.materials);
    this.group.add(this.fine.group, this.plane.mesh);
    if (this.coarse) this.group.add(this.coarse.group);
  }

  update(most_ms: number, wants_coarse: boolean): boolean {
    const shown = wants_coarse && this.coarse ? this.coarse : this.fine;
    this.coarse_field?.follow();
    const is_done = shown.update(most_ms);
    // Until the first time that all tiles are there the other one is seen.
    const other = shown === this.fine ? this.coarse : this.fine;
    const shows_other = !is_done && !shown.is_whole && !!other?.is_whole;
    this.fine.group.visible = (shown === this.fine) !== shows_other;
    if (this.coarse) this.coarse.group.visible = !this.fine.group.visible;
    return is_done;
  }

  set_colours(colours: SurfaceColours): void {
    this.fine.materials.set_colours(colours);
  }

  set_deviation(most_mm: number): void {
    this.fine.materials.set_deviation(most_mm);
  }

  set_section(section: Section | null): void {
    this.section = section;
    this.plane.set(section, this.field.grid.corner, far_corner(this.field.grid));
  }

  hit(from: Vec, way: Vec): BodyHit | null {
    return hit_of_field(this.field, from, way, this.section && plane_of(this.section));
  }

  get triangles(): number {
    return (this.fine.group.visible ? this.fine : this.coarse!).triangles;
  }

  dispose(): void {
    this.coarse?.dispose();
    this.fine.dispose();
    this.plane.dispose();
    this.group.removeFromParent();
  }
}
