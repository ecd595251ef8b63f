/** The part that is cut: what the server is asked to show of it, what it has told, and how a person looks at it. */
import type { Breakpoint } from '../logic/protocol';
import type { Finding } from '../logic/stock/part_store';
import { colourings_of } from '../logic/stock/part_colours';
import { asks_for_fine, finding_marks, wanted_time } from '../logic/stock/part_view';
import { position } from '../logic/format';
import { measure, type MeasureKind, type Place } from '../logic/stock/measure';
import type { StockColouring } from '../logic/stock/owner_colours';
import { documents } from './documents.svelte';
import { panel } from './panel.svelte';
import { preferences } from './preferences.svelte';
import { progress } from './progress.svelte';
import { selection } from './selection.svelte';
import { slider } from './slider.svelte';

export type SectionAxis = 'off' | 'x' | 'y' | 'z';
const REST_MS = 500;
/** The finding that a program has cut nothing. */
const NOT_CUT = 'STOCK_MISSED';

class Part {
  colouring = $state<StockColouring>('tool');
  section = $state<SectionAxis>('off');
  /** 0 to 1 of the way through the stock; of a lathe of half a turn. */
  section_at = $state(0.5);
  /** Of a lathe a quarter. */
  sector_at = $state(0.5);
  from_above = $state(false);
  measuring = $state<MeasureKind | null>(null);
  places = $state.raw<Place[]>([]);
  /** Which finding stands out. */
  chosen = $state.raw<Finding | null>(null);
  /** The server has been asked to show it, and has not refused. */
  is_asked = $state(false);
  private asking = false;
  private wish: string | null = null;
  private told: string | null = null;
  private rest: ReturnType<typeof setTimeout> | null = null;
  private rests = $state(false);

  facts = $derived((void panel.part_version, panel.part.facts));
  /** Something of it is there, and is to be seen. */
  is_shown = $derived.by(() => {
    void panel.part_version;
    return preferences.show_stock && panel.part.shape !== null;
  });
  /** Whoever takes only what he needs of the facts does not begin anew with each of them. */
  stock = $derived(this.facts.stock);
  design = $derived(this.facts.design);
  owners_version = $derived((void panel.part_version, panel.part.owners_version));
  /** Of what is shown, along both ways; empty: it is no grid. */
  cells = $derived.by(() => {
    void panel.part_version;
    return this.facts.levels[panel.part.level]?.cells.join(' × ') ?? '';
  });
  findings = $derived(this.facts.findings);
  /** With the part, as long as it is asked for, or nothing is cut: its path says more of such a program. */
  shows_path = $derived(
    preferences.show_path || !this.is_shown || this.findings.some(({ code }) => code === NOT_CUT),
  );
  /** The text has been changed since it was loaded: findings and part are those of the earlier one. */
  is_stale = $derived(documents.is_ahead);
  /** Of the state that is shown, seconds of the program. */
  shown_s = $derived((void panel.part_version, panel.part.time_s));
  /** What it can be coloured by. */
  colourings = $derived.by(() => {
    void [this.owners_version, this.is_shown, this.design, this.facts.run];
    return colourings_of(panel.part);
  });
  /** By what it is coloured: as chosen, where that can be. */
  coloured = $derived(
    this.colourings.includes(this.colouring) ? this.colouring : this.colourings[0],
  );
  marks = $derived(finding_marks(this.findings, slider.end_s, (s) => this.run_seconds(s)));
  /** Seconds of the program that are to be shown; null: as far as it is cut. */
  wanted_s = $derived(
    wanted_time({
      slider_s: slider.time_s === null ? null : progress.path_seconds(slider.time_s),
      path_s: progress.path_s,
      is_over: panel.state.status === 'end',
    }),
  );
  /** Of the places that were clicked, and its number in words. */
  measured = $derived.by(() => {
    const upright = this.facts.model === 'profile' ? 0 : 2;
    const found = this.measuring ? measure(this.measuring, this.places, upright) : null;
    const sign = found?.kind === 'diameter' ? 'Ø ' : '';
    return { found, words: found ? `${sign}${position(found.value)}` : '' };
  });
  /** The model has not come as far as the machine. */
  is_behind = $derived(
    this.is_shown &&
      !this.facts.done &&
      this.wanted_s !== null &&
      this.wanted_s > this.facts.done_s + 0.1,
  );

  /** Has it shown, or no more; called when machine, program or preference change. */
  async show(shows: boolean): Promise<void> {
    if (!shows) {
      panel.part.clear();
      panel.part_version++;
    }
    this.told = null;
    const answer = await panel.ask('stock', { shows }).catch(() => null);
    this.is_asked = shows && answer !== null;
    if (this.is_asked) this.want();
  }

  /** Tells the server what is to be shown, one wish at a time and the newest next. */
  want(): void {
    const level = asks_for_fine(this.facts, preferences.stock_fine && this.rests) ? 1 : 0;
    const time = this.wanted_s === null ? {} : { time_s: this.wanted_s };
    const deviation = this.coloured === 'deviation' ? { deviation: true } : {};
    const wish = JSON.stringify({ ...time, level, ...deviation });
    if (wish === this.told) return;
    if (!this.is_same_time(wish)) this.stir();
    this.wish = wish;
    void this.ask();
  }

  /** The time of the run at which a second of the program is. */
  run_seconds(program_s: number): number {
    const { path_s } = progress;
    if (path_s === null || program_s <= path_s) return program_s;
    return progress.now.done_s + program_s - path_s;
  }

  /** To the line, the instant and the place. */
  async go_to(finding: Finding): Promise<void> {
    this.chosen = finding;
    if (finding.line > 0) {
      if (finding.file !== documents.current) await documents.follow(finding.file);
      const line = documents.text_line(finding.file, finding.line);
      if (line !== null) {
        selection.choose(finding.file, line);
        documents.go_to(line);
      }
    }
    if (!panel.moves) slider.move_to(this.run_seconds(finding.time_s));
  }

  /** The finding behind (1) or before (-1) the chosen one, or the time that is shown, around the end. */
  beside(way: 1 | -1): void {
    const list = this.findings;
    if (!list.length) return;
    const at = this.chosen ? list.indexOf(this.chosen) : -1;
    const next = (at < 0 ? (way > 0 ? 0 : list.length - 1) : at + way + list.length) % list.length;
    void this.go_to(list[next]);
  }

  /** The lines of findings have breakpoints that this has set. */
  get stops_at_findings(): boolean {
    return this.stops.length > 0;
  }
  private stops = $state.raw<{ file: string; line: number }[]>([]);

  /** The machine stops before the block of each finding, or no more. */
  async stop_at_findings(): Promise<void> {
    const is_stop = (b: Breakpoint, list: { file: string; line: number }[]) =>
      list.some(({ file, line }) => b.file === file && b.line === line);
    if (this.stops.length) {
      const stops = this.stops;
      this.stops = [];
      return panel.set_breakpoints(panel.breakpoints.filter((b) => !is_stop(b, stops)));
    }
    const wanted = [...new Map(this.findings.map((f) => [`${f.line} ${f.file}`, f])).values()]
      .filter(({ line }) => line > 0)
      .map(({ file, line }) => ({ file, line }))
      .filter((place) => !panel.breakpoints.some((b) => is_stop(b, [place])));
    this.stops = wanted;
    await panel.set_breakpoints([...panel.breakpoints, ...wanted]);
  }

  measure(kind: MeasureKind | null): void {
    this.measuring = this.measuring === kind ? null : kind;
    this.places = [];
  }
  add_place(place: Place, needed: number): void {
    this.places = this.places.length >= needed ? [place] : [...this.places, place];
  }

  private is_same_time = (wish: string): boolean =>
    this.told !== null && JSON.parse(this.told).time_s === JSON.parse(wish).time_s;

  /** While the time changes the coarse level is quick enough; the fine one comes when it rests. */
  private stir(): void {
    this.rests = false;
    if (this.rest !== null) clearTimeout(this.rest);
    this.rest = setTimeout(() => {
      this.rests = true;
      this.want();
    }, REST_MS);
  }

  private async ask(): Promise<void> {
    if (this.asking) return;
    this.asking = true;
    while (this.wish !== null && this.wish !== this.told) {
      const wish = this.wish;
      this.told = wish;
      await panel.ask('stock_at', JSON.parse(wish)).catch(() => null);
    }
    this.asking = false;
  }
}

export const part = new Part();
