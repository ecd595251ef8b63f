/** Numbers as an operator reads them. Never in hash or locale order: a point is a point in every language. */

/** The minus of typography is as wide as a digit, so that columns stand still. */
const MINUS = '\u2212';
export const NOTHING = '\u2013';

export function fixed(value: number | null | undefined, decimals: number): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return NOTHING;
  const text = Math.abs(value).toFixed(decimals);
  return value < 0 && Number(text) !== 0 ? MINUS + text : text;
}

/** A coordinate: three decimals, mm and degrees alike. */
export const position = (value: number | null | undefined): string => fixed(value, 3);

/** A rate: whole, or with as many decimals as make three digits. */
export function rate(value: number | null | undefined): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return NOTHING;
  const size = Math.abs(value);
  if (size === 0 || size >= 100) return thousands(fixed(value, 0));
  return fixed(value, size >= 10 ? 1 : 2).replace(/\.?0+$/, '');
}

/** 12 345: a thin space between thousands from five digits on. */
export function thousands(text: string): string {
  const [whole, part] = text.split('.');
  const digits = whole.replace(MINUS, '');
  if (digits.length < 5) return text;
  const grouped = whole.replace(/(\d)(?=(\d{3})+$)/g, '$1\u2009');
  return part === undefined ? grouped : `${grouped}.${part}`;
}

/** h:mm:ss, or m:ss.s below an hour. */
export function duration(seconds: number | null | undefined): string {
  if (seconds === null || seconds === undefined || !Number.isFinite(seconds)) return NOTHING;
  const tenths = Math.max(0, Math.round(seconds * 10));
  const h = Math.floor(tenths / 36000);
  const m = Math.floor(tenths / 600) % 60;
  const s = Math.floor(tenths / 10) % 60;
  if (h > 0) return `${h}:${pad(m)}:${pad(s)}`;
  return `${m}:${pad(s)}.${tenths % 10}`;
}

const pad = (value: number): string => String(value).padStart(2, '0');

export function percent(value: number | null | undefined): string {
  return value === null || value === undefined ? NOTHING : `${Math.round(value)} %`;
}

export function bytes(value: number): string {
  if (value < 1024) return `${value} B`;
  if (value < 1024 * 1024) return `${(value / 1024).toFixed(1)} KiB`;
  return `${(value / 1024 / 1024).toFixed(1)} MiB`;
}

/** The value of a variable: what reads back, at most nine digits; vacant has its own word. */
export function variable(value: number | null): string {
  if (value === null) return '';
  const size = Math.abs(value);
  const is_long = size >= 1e10 || (size > 0 && size < 1e-4);
  const text = is_long ? value.toExponential(6) : String(Number(value.toPrecision(9)));
  return text.replace('-', MINUS);
}

/** What a person types into a number field; null: it is empty, undefined: it is no number. */
export function typed_number(text: string): number | null | undefined {
  const plain = text.trim().replace(MINUS, '-').replace(',', '.');
  if (plain === '') return null;
  return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(plain) ? Number(plain) : undefined;
}

/** Of a part: small ones in mm³. */
export const volume = (mm3: number): string =>
  mm3 < 1000 ? `${Number(mm3.toPrecision(3))} mm³` : `${(mm3 / 1000).toFixed(2)} cm³`;
