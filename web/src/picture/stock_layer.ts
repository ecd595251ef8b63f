/** The part in the picture, in the frame of the machine: body, clamps, findings, measures. */
import { Box3, type DataTexture, Group, Matrix4, Vector3 } from 'three';
import { type Box, diagonal, join } from '../logic/box';
import type { Scheme } from '../logic/colour_scale';
import { fill_table, most_deviation, type StockColouring } from '../logic/stock/owner_colours';
import type { PartStore, Shape } from '../logic/stock/part_store';
import type { Solid } from '../logic/stock/setup_words';
import type { Body, BodyHit, Section, Vec } from './body';
import { dispose, type Palette } from './furniture';
import { ground_shadow } from './ground_shadow';
import { HeightsBody } from './heights_body';
import { SheetBody } from './sheet_body';
import { MeshBody, TurnedBody } from './solid_bodies';
import { colour_table } from './stock_material';
import { type FindingMark, findings_group, fixtures_group, measure_group } from './stock_marks';

export interface Measured {
  places: readonly Vec[];
  line: readonly Vec[];
  text: string;
}

/** How dark the shadow is under the part. */
const SHADOW: Record<Scheme, number> = { dark: 0.62, light: 0.34 };

/** Clamps that make the picture larger by this stay outside of it. */
const MOST_AROUND = 1.8;

export class StockLayer {
  readonly group = new Group();
  private body: Body | null = null;
  private shape: Shape | null = null;
  private part: PartStore | null = null;
  private readonly table: DataTexture = colour_table();
  private palette: Palette | null = null;
  private scheme: Scheme = 'dark';
  private section: Section | null = null;
  private fixtures: Group | null = null;
  private findings: Group | null = null;
  private measured: Group | null = null;
  private shadow: Group | null = null;
  private colouring: StockColouring = 'tool';

  constructor(
    private readonly is_calm: () => boolean,
    private readonly by_software: boolean,
  ) {}

  /** What is drawn of the part; null: nothing. */
  set_part(part: PartStore | null): void {
    this.part = part;
    const origin = part?.facts.stock?.origin;
    if (origin) this.group.position.set(origin[0], origin[1], origin[2]);
    const shape = part?.shape ?? null;
    if (shape === this.shape) return;
    this.shade_ground(shape);
    this.shape = shape;
    this.body?.dispose();
    this.body = shape && part ? this.made(shape, part) : null;
    if (!this.body) return;
    this.group.add(this.body.group);
    this.dress();
  }

  /** Of a part that stands on a table. */
  private shade_ground(shape: Shape | null): void {
    const stock = this.part?.facts.stock;
    const stands = shape && shape.kind !== 'profile' && stock;
    this.shadow = this.replaced(this.shadow, ({ shadow }) => {
      const group = new Group();
      if (stands) group.add(ground_shadow(stock.low, stock.high, shadow, SHADOW[this.scheme]));
      return group;
    });
  }

  get is_shown(): boolean {
    return this.body !== null;
  }

  /** Triangles are made for at most so long. True: all is as it should be. */
  update(most_ms: number, coarse: boolean): boolean {
    return this.body?.update(most_ms, coarse) ?? true;
  }

  get moves(): boolean {
    return this.body?.moves ?? false;
  }

  set_palette(palette: Palette, scheme: Scheme): void {
    this.palette = palette;
    this.scheme = scheme;
    this.shade_ground(this.shape);
    this.dress();
  }

  set_colours(colouring: StockColouring, chosen: { file: number; line: number } | null): void {
    this.colouring = colouring;
    const table = this.table.image.data as Uint8Array;
    if (this.part) fill_table(table, this.part.owners, colouring, this.scheme, chosen);
    this.table.needsUpdate = true;
    this.paint();
  }

  /** What of the colours is not in the table. */
  private paint(): void {
    const by_deviation = this.colouring === 'deviation' && this.part;
    this.body?.set_deviation(by_deviation ? most_deviation(this.part!.facts) : 0);
    if (this.body instanceof SheetBody)
      this.body.set_scheme(this.scheme, this.colouring === 'energy');
  }

  set_section(section: Section | null): void {
    this.section = section;
    this.body?.set_section(section);
  }

  set_fixtures(solids: readonly Solid[]): void {
    this.fixtures = this.replaced(this.fixtures, (palette) => fixtures_group(solids, palette));
  }
  set_findings(marks: readonly FindingMark[]): void {
    this.findings = this.replaced(this.findings, (palette) => findings_group(marks, palette));
  }
  set_measured({ places, line, text }: Measured): void {
    this.measured = this.replaced(this.measured, (palette) =>
      measure_group(places, line, text, palette),
    );
  }

  /** Along a line of sight of the machine. From the zero of the stock. */
  hit(from: Vec, way: Vec): BodyHit | null {
    if (!this.body) return null;
    const inverse = new Matrix4().copy(this.group.matrixWorld).invert();
    const start = new Vector3(...from).applyMatrix4(inverse);
    const along = new Vector3(...way).transformDirection(inverse);
    return this.body.hit([start.x, start.y, start.z], [along.x, along.y, along.z]);
  }

  /** Of the stock and of what holds it, unless that is much larger, in machine coordinates. */
  box_with_fixtures(): Box | null {
    const box = this.box();
    if (!box || !this.fixtures?.children.length) return box;
    this.group.updateWorldMatrix(false, true);
    const { min, max } = new Box3().setFromObject(this.fixtures);
    const all = { min: min.toArray(), max: max.toArray() };
    join(all, box);
    return diagonal(all) < MOST_AROUND * diagonal(box) ? all : box;
  }

  /** Of the stock, in machine coordinates. */
  box(): Box | null {
    const stock = this.part?.facts.stock;
    if (!stock || !this.body) return null;
    const at = (corner: number[]) => corner.map((v, i) => v + stock.origin[i]) as Vec;
    if (this.shape?.kind !== 'profile') return { min: at(stock.low), max: at(stock.high) };
    const radius = Math.max(...stock.high.slice(0, 2).map(Math.abs));
    return {
      min: at([-radius, -radius, stock.low[2]]),
      max: at([radius, radius, stock.high[2]]),
    };
  }

  dispose(): void {
    this.body?.dispose();
    this.table.dispose();
    for (const group of [this.fixtures, this.findings, this.measured, this.shadow]) dispose(group);
    this.group.removeFromParent();
  }

  private made(shape: Shape, part: PartStore): Body {
    const { low, high } = part.facts.stock ?? { low: [0, 0, 0], high: [0, 0, 0] };
    if (shape.kind === 'heights') return new HeightsBody(shape.field, this.table, this.by_software);
    if (shape.kind === 'sheet') return new SheetBody(shape.field, this.is_calm);
    if (shape.kind === 'profile')
      return new TurnedBody(shape, this.table, () => this.part?.facts.threads ?? []);
    return new MeshBody(shape.tiles, shape.changed, this.table, { low, high });
  }

  private dress(): void {
    const { palette, body } = this;
    if (!palette || !body) return;
    body.set_colours({
      stock: palette.blank,
      face: palette.face,
      hatch: palette.hatch,
      edge: palette.edge,
    });
    body.set_section(this.section);
    this.paint();
  }

  private replaced(old: Group | null, make: (palette: Palette) => Group): Group | null {
    dispose(old);
    if (!this.palette) return null;
    const group = make(this.palette);
    this.group.add(group);
    return group;
  }
}
