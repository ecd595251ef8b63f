/** A curve over the time of the run, by uPlot: with the cursor of the slider, a readout, a jump by click, a zoom by dragging. */
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import type { Waves } from '../logic/waves';

export interface ChartWishes {
  jump(time_s: number): void;
  zoom(from_s: number, to_s: number): void;
  describe(index: number): string;
}

type Look = Pick<uPlot.Options, 'series' | 'axes' | 'scales'>;

const CLICK_PX = 3;

export class Chart {
  private plot: uPlot | null = null;
  /** What the plot was made for: with the same it only gets new data. */
  private form = '';
  private waves: Waves | null = null;
  private cursor_s = 0;
  private readonly readout = document.createElement('div');
  private readonly watch: ResizeObserver;

  constructor(
    private readonly host: HTMLElement,
    private readonly wishes: ChartWishes,
  ) {
    this.readout.className = 'chart-readout';
    this.watch = new ResizeObserver(() => this.plot?.setSize(this.size()));
    this.watch.observe(host);
  }

  dispose(): void {
    this.watch.disconnect();
    this.plot?.destroy();
  }

  set_speed(time_s: number[], speed: number[], axis: string): void {
    const { accent } = colours(this.host);
    this.waves = null;
    this.draw([time_s, speed], `speed ${accent}`, () => ({
      series: [{}, { stroke: accent, fill: `${accent}22`, width: 1.4, points: { show: false } }],
      axes: [
        this.time_axis(),
        { ...this.axis(), label: axis, labelSize: 18, labelFont: FONT, size: 54 },
      ],
    }));
  }

  set_waves(waves: Waves): void {
    this.waves = waves;
    const names = waves.lanes.map((lane) => lane.name);
    const data = [Array.from(waves.time_s), ...waves.curves.map((curve) => Array.from(curve))];
    this.draw(data, `waves ${names.join(' ')} ${colours(this.host).text}`, () => ({
      series: [{}, ...names.map((_, i) => this.lane(i, names.length))],
      axes: [this.time_axis(), this.lane_axis(names)],
      scales: { y: { range: [0, Math.max(1, names.length)] } },
    }));
  }

  set_cursor(time_s: number): void {
    this.cursor_s = time_s;
    this.plot?.redraw(false);
  }

  private draw(data: number[][], form: string, look: () => Look): void {
    if (this.plot && form === this.form) {
      this.plot.setData(data as uPlot.AlignedData);
      return;
    }
    this.form = form;
    this.plot?.destroy();
    this.plot = new uPlot(this.options(look()), data as uPlot.AlignedData, this.host);
    this.plot.over.append(this.readout);
  }

  private options({ series, axes, scales }: Look): uPlot.Options {
    return {
      ...this.size(),
      series,
      axes,
      scales: { x: { time: false }, ...scales },
      legend: { show: false },
      padding: [8, 10, 0, 0],
      cursor: { y: false, drag: { x: true, y: false, setScale: false } },
      hooks: this.hooks(),
    };
  }

  private hooks(): uPlot.Hooks.Arrays {
    return {
      draw: [(plot) => this.mark_lines(plot), (plot) => this.draw_cursor(plot)],
      setCursor: [(plot) => this.read_out(plot)],
      ready: [(plot) => this.listen(plot)],
      setSelect: [(plot) => this.select(plot)],
    };
  }

  private lane(index: number, count: number): uPlot.Series {
    const { lanes } = colours(this.host);
    const colour = lanes[index % lanes.length];
    return {
      stroke: colour,
      fill: `${colour}38`,
      fillTo: () => count - 1 - index + 0.5,
      width: 1,
      points: { show: false },
    };
  }

  private lane_axis(names: string[]): uPlot.Axis {
    return {
      ...this.axis(),
      size: 34,
      splits: () => names.map((_, i) => names.length - 1 - i + 0.5),
      values: () => names,
      grid: { show: false },
    };
  }

  private mark_lines(plot: uPlot): void {
    if (this.waves) mark_lines(plot, this.waves, colours(this.host).text);
  }

  private listen(plot: uPlot): void {
    let from = 0;
    plot.over.addEventListener('pointerdown', (event) => (from = event.clientX));
    plot.over.addEventListener('pointerup', (event) => {
      if (Math.abs(event.clientX - from) <= CLICK_PX)
        this.wishes.jump(plot.posToVal(event.offsetX, 'x'));
    });
  }

  private select(plot: uPlot): void {
    const { left, width } = plot.select;
    if (width > CLICK_PX * 2)
      this.wishes.zoom(plot.posToVal(left, 'x'), plot.posToVal(left + width, 'x'));
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
  }

  private read_out(plot: uPlot): void {
    const { idx, left } = plot.cursor;
    const text = typeof idx === 'number' ? this.wishes.describe(idx) : '';
    this.readout.textContent = text;
    this.readout.hidden = text === '';
    this.readout.style.left = `${Math.min(left ?? 0, plot.over.clientWidth - 170)}px`;
  }

  private draw_cursor(plot: uPlot): void {
    const x = plot.valToPos(this.cursor_s, 'x', true);
    const { left, width } = plot.bbox;
    if (x < left || x > left + width) return;
    const pen = plot.ctx;
    pen.save();
    pen.strokeStyle = colours(this.host).hold;
    pen.lineWidth = 2 * devicePixelRatio;
    upright(plot, x);
    pen.restore();
  }

  private axis(): uPlot.Axis {
    const { text, line } = colours(this.host);
    return {
      stroke: text,
      font: FONT,
      grid: { stroke: line, width: 1 },
      ticks: { stroke: line, width: 1, size: 4 },
    };
  }
  private time_axis(): uPlot.Axis {
    return {
      ...this.axis(),
      size: 26,
      space: 70,
      values: (_, ticks) => ticks.map((tick) => `${tick} s`),
    };
  }
  private size() {
    return {
      width: Math.max(80, this.host.clientWidth),
      height: Math.max(60, this.host.clientHeight),
    };
  }
}

const FONT = '11px "IBM Plex Sans", sans-serif';

function colours(host: HTMLElement) {
  const style = getComputedStyle(host);
  const of = (name: string) => style.getPropertyValue(`--${name}`).trim();
  return {
    text: of('text-3'),
    line: of('line'),
    accent: of('accent'),
    hold: of('hold'),
    lanes: [of('axis-x'), of('axis-y'), of('axis-z'), of('hold'), of('syntax-keyword')],
  };
}

/** Where one NC line ends and the next begins, with their numbers, as far as they have room. */
function mark_lines(plot: uPlot, waves: Waves, colour: string): void {
  const pen = plot.ctx;
  const { left, width } = plot.bbox;
  let free_from = left;
  pen.save();
  dress(pen, colour);
  for (const { from_s, line } of waves.lines) {
    const x = plot.valToPos(from_s, 'x', true);
    if (x < left || x > left + width) continue;
    upright(plot, x);
    if (x >= free_from) free_from = written(plot, String(line), x);
  }
  pen.restore();
}

function dress(pen: CanvasRenderingContext2D, colour: string): void {
  pen.fillStyle = colour;
  pen.strokeStyle = colour;
  pen.font = `${11 * devicePixelRatio}px "IBM Plex Mono", monospace`;
  pen.globalAlpha = 0.8;
  pen.setLineDash([3, 4]);
}

function upright({ ctx: pen, bbox }: uPlot, x: number): void {
  pen.beginPath();
  pen.moveTo(x, bbox.top);
  pen.lineTo(x, bbox.top + bbox.height);
  pen.stroke();
}

/** Beside a line; the next text has room from the returned place on. */
function written({ ctx: pen, bbox }: uPlot, text: string, x: number): number {
  pen.fillText(text, x + 4, bbox.top + 11 * devicePixelRatio);
  return x + pen.measureText(text).width + 14;
}
