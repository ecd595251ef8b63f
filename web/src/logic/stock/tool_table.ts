/** A `[[tool]]` table and what its keys say, as far as pictures and forms need it (docs/tools.md). */
export type ToolTable = { number: number } & Record<string, unknown>;
export type PartKind = 'cutting' | 'neck' | 'shank' | 'holder';
export type Point2 = [number, number];

export interface ToolPart {
  kind: PartKind;
  /** Rotating: [radius, height] upwards. Turning: a closed outline [z, radius]. */
  outline: Point2[];
}

export interface ToolShape {
  turning: boolean;
  parts: ToolPart[];
}

export const MILL_TYPES = [
  'flat', 'ball', 'bull', 'drill', 'chamfer', 'spot', 'tap', 'reamer', 'face', 'centre-drill',
  'countersink', 'v', 'engrave', 'taper', 'slot', 't-slot', 'saw', 'dovetail', 'lollipop',
  'thread-mill', 'boring', 'form', 'probe',
] as const; // prettier-ignore
export const LATHE_TYPES = [
  'turning', 'boring-bar', 'grooving', 'parting', 'face-grooving', 'threading',
] as const; // prettier-ignore
export type ToolType = (typeof MILL_TYPES)[number] | (typeof LATHE_TYPES)[number];

export const rad = (deg: number): number => (deg * Math.PI) / 180;

export function number_of(tool: ToolTable, key: string, otherwise: number): number {
  const value = tool[key];
  return typeof value === 'number' && Number.isFinite(value) ? value : otherwise;
}

export function type_of(tool: ToolTable): ToolType {
  const type = tool.type as ToolType | undefined;
  if (type && ([...MILL_TYPES, ...LATHE_TYPES] as string[]).includes(type)) return type;
  return tool.insert || tool.nose_radius !== undefined || tool.tip !== undefined
    ? 'turning'
    : 'flat';
}

export const is_turning = (type: ToolType): boolean =>
  (LATHE_TYPES as readonly string[]).includes(type);
