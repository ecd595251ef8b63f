/** The time slider: now, or an instant of the run, with position, modal codes and variables of that instant. */
import type { Chunk } from '../logic/chunk';
import { Refusal } from '../logic/connection';
import { joints_of } from '../logic/kinematics';
import type { Axes, Instant, MachineState, Variable } from '../logic/protocol';
import { panel, said } from './panel.svelte';
import { progress } from './progress.svelte';

/** The machine answers with the set-point at or before the time asked for. */
const SAME_INSTANT_S = 0.05;

class Slider {
  /** Seconds of the path of that number: another program begins at now, and so does whatever the operator starts. */
  private place = $state.raw<{ time_s: number; path: number; begun: number } | null>(null);
  instant = $state.raw<Instant | null>(null);
  /** The server's sentence, when it has no such instant. */
  refused = $state('');
  private asking = false;
  private wanted: number | null = null;

  /** Seconds of the run; null: now. */
  get time_s(): number | null {
    const { place } = this;
    const holds = place?.path === panel.path?.run && place?.begun === panel.begun;
    return place && holds ? place.time_s : null;
  }
  get is_back(): boolean {
    return this.time_s !== null;
  }
  get end_s(): number {
    void panel.path_version;
    const { done_s, left_s } = progress.now;
    const program_s =
      progress.stop_s ?? Math.max(panel.preview.facts.end_s, panel.path?.time_s ?? 0);
    // Behind the stop no machine comes: there is nothing to go to.
    if (progress.stop_s !== null) return Math.max(program_s, done_s);
    return done_s > 0 ? done_s + (left_s ?? program_s) : program_s;
  }

  move_to(time_s: number): void {
    if (!panel.path) return;
    const within = Math.min(Math.max(0, time_s), this.end_s);
    this.place = { time_s: within, path: panel.path.run, begun: panel.begun };
    this.wanted = within;
    void this.ask();
  }

  now(): void {
    this.place = null;
    this.wanted = null;
    this.instant = null;
    this.refused = '';
  }

  /** The state to be shown: the live one, or that of the instant as far as it is known. */
  get shown(): MachineState {
    const live = panel.state;
    if (this.time_s === null) return live;
    return { ...live, ...this.of_path(this.time_s), ...this.of_server() };
  }

  get variables(): Variable[] | null {
    return this.time_s === null ? null : (this.instant?.variables ?? []);
  }

  /** One question at a time, and the newest wish next: however fast the thumb moves. */
  private async ask(): Promise<void> {
    if (this.asking) return;
    this.asking = true;
    while (this.wanted !== null) {
      const time_s = this.wanted;
      this.wanted = null;
      await this.ask_for(time_s);
    }
    this.asking = false;
  }
  private async ask_for(time_s: number): Promise<void> {
    try {
      const answer = await panel.ask('instant', { time_s });
      if (this.time_s !== null) this.instant = answer as unknown as Instant;
      this.refused = '';
    } catch (reason) {
      this.refused = reason instanceof Refusal ? said(reason) : String(reason);
    }
  }

  /** At once, from the path's vertices: where tip and joints are, and which line moves them. */
  private of_path(time_s: number): Partial<MachineState> {
    const { definition, preview } = panel;
    const place = preview.place_at(progress.path_seconds(time_s));
    if (!place || !definition) return {};
    const tip = preview.point_at(place);
    const rotary = rotary_axes(preview.rotary_at(place));
    return {
      position: this.instant?.position ?? panel.state.position,
      joints: joints_of(definition.kinematics, tip, rotary, panel.state.joints),
      ...facts_of(preview.chunks[place.chunk], place.vertex),
    };
  }

  /** All that the machine says of the instant, but what belongs to now: operator and switches. */
  private of_server(): Partial<MachineState> {
    const instant = this.instant;
    if (!instant || this.time_s === null) return {};
    if (Math.abs(instant.time_s - this.time_s) > SAME_INSTANT_S) return {};
    const { position, joints, modal, file, line, text, stack } = instant;
    const { feed, spindle, tool, coolant } = instant;
    return { position, joints, modal, file, line, text, stack, feed, spindle, tool, coolant };
  }
}

/** Of the segment behind a vertex. */
function facts_of(chunk: Chunk, vertex: number): Partial<MachineState> {
  const end = Math.min(vertex + 1, chunk.vertices - 1);
  return {
    line: chunk.line[end],
    file: panel.path?.files[chunk.file[end]] ?? panel.state.file,
    tool: chunk.tool[end],
    power_percent: chunk.power_percent[end],
    motion: chunk.motion[end],
  };
}

function rotary_axes(values: [number, number] | null): Axes {
  if (!values || !panel.definition) return {};
  const names = panel.definition.axes.filter((axis) => axis.rotary).map((axis) => axis.name);
  return Object.fromEntries(names.slice(0, 2).map((name, i) => [name, values[i]]));
}

export const slider = new Slider();
