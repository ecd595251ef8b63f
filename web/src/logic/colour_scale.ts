/**
 * Colours of the picture. A scale rises in lightness as in value, so it reads in grey and with any colour vision; colours of
 * tools differ in lightness as well as in hue, and the legend and the markers name them.
 */

export type Rgb = [number, number, number];
export type Colouring = 'tool' | 'feed' | 'speed' | 'power';
export type Scheme = 'dark' | 'light';

/** Stops from low to high on a dark ground: lightness rises. On a light one it falls, so that high stands out on both. */
const STOPS: Record<Scheme, Rgb[]> = {
  dark: [hex('#3b4c9b'), hex('#3f7fc4'), hex('#3fb3b0'), hex('#86d27a'), hex('#f4e46a')],
  light: [hex('#7fb2dc'), hex('#3f95a8'), hex('#2d7a5c'), hex('#5d5a1e'), hex('#7a1f2b')],
};

const TOOLS: Record<Scheme, Rgb[]> = {
  dark: [
    '#4fb3ff',
    '#ffb454',
    '#7ddc8a',
    '#ff7d92',
    '#c9a2ff',
    '#f2ea73',
    '#5fe0d8',
    '#ff9ad8',
  ].map(hex),
  light: [
    '#0a63b0',
    '#a65100',
    '#177334',
    '#b3203d',
    '#6a3fb5',
    '#6b6200',
    '#006e70',
    '#a02a7c',
  ].map(hex),
};

const RAPID: Record<Scheme, Rgb> = { dark: hex('#7d8b99'), light: hex('#6a7682') };

export const rapid_colour = (scheme: Scheme): Rgb => RAPID[scheme];

/** Threads have the lightest or darkest colour, which no tool has. */
const THREAD: Record<Scheme, Rgb> = { dark: hex('#f3f6f9'), light: hex('#0b0d10') };

export const thread_colour = (scheme: Scheme): Rgb => THREAD[scheme];

export function tool_colour(tool: number, scheme: Scheme): Rgb {
  const colours = TOOLS[scheme];
  return colours[Math.max(0, tool - 1) % colours.length];
}

export const scale_stops = (scheme: Scheme): Rgb[] => STOPS[scheme];

/** Colour of `share`, 0 to 1, of a scale; beyond it the end's. */
export function scale_colour(share: number, scheme: Scheme): Rgb {
  return between_stops(STOPS[scheme], share);
}

/** Of colours that stand at equal distances from 0 to 1. */
export function between_stops(stops: readonly Rgb[], share: number): Rgb {
  const place = Math.min(1, Math.max(0, share)) * (stops.length - 1);
  const below = Math.min(stops.length - 2, Math.floor(place));
  const [a, b] = [stops[below], stops[below + 1]];
  return a.map((value, i) => value + (place - below) * (b[i] - value)) as Rgb;
}

/** What is cut away too deep is blue, what is left is red, and what is as it shall be has no colour; the same on both grounds. */
const DEVIATION: Rgb[] = [
  hex('#1f4fd0'),
  hex('#7fa8ee'),
  hex('#c6cbd0'),
  hex('#f2a285'),
  hex('#c8281a'),
];

export const deviation_stops = (): Rgb[] => DEVIATION;

/** Round numbers that a legend writes beside its scale, at most `count`, the ends among them. */
export function ticks(low: number, high: number, count: number): number[] {
  if (!(high > low)) return [low];
  const raw = (high - low) / Math.max(1, count - 1);
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((m) => m * power).find((s) => s >= raw) ?? raw;
  const first = Math.ceil(low / step) * step;
  const values: number[] = [];
  for (let i = 0; first + i * step <= high + step * 1e-9; i++) values.push(first + i * step);
  return values;
}

export function css(colour: Rgb): string {
  return `rgb(${colour.map((c) => Math.round(c * 255)).join(' ')})`;
}

/** Relative luminance of WCAG, 0 to 1. */
export function luminance(colour: Rgb): number {
  const [r, g, b] = colour.map((c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

export function contrast(a: Rgb, b: Rgb): number {
  const [dark, light] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (light + 0.05) / (dark + 0.05);
}

export function hex(text: string): Rgb {
  const value = Number.parseInt(text.slice(1), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}
