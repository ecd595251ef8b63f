/**
 * Where the parts of a linkage stand, for the picture (docs/kinematics.md has the mathematics). Lengths in mm, angles of
 * joints in degrees, places in machine coordinates.
 */
import type { Axes, Kinematics } from './protocol';

export type Point = [number, number, number];

const rad = (deg: number): number => (deg * Math.PI) / 180;
const deg = (value: number): number => (value * 180) / Math.PI;
const length_of = (k: Kinematics, key: string): number => Number(k[key] ?? 0);
const axis = (axes: Axes, name: string): number => axes[name] ?? 0;

export interface ArmPose {
  shoulder: Point;
  elbow: Point;
  wrist: Point;
  /** Angles from +X. */
  upper_arm_rad: number;
  forearm_rad: number;
  wheel_rad: number;
}

export function arm_pose(k: Kinematics, joints: Axes): ArmPose {
  const z = axis(joints, 'Z');
  const upper = rad(axis(joints, 'T2'));
  const forearm = k.forearm_absolute ? rad(axis(joints, 'T1')) : upper + rad(axis(joints, 'T1'));
  const elbow = polar([0, 0, z], length_of(k, 'upper_arm'), upper);
  return {
    shoulder: [0, 0, z],
    elbow,
    wrist: polar(elbow, length_of(k, 'forearm'), forearm),
    upper_arm_rad: upper,
    forearm_rad: forearm,
    wheel_rad: forearm + rad(axis(joints, 'T3')),
  };
}

const polar = (from: Point, length: number, angle: number): Point => [
  from[0] + length * Math.cos(angle),
  from[1] + length * Math.sin(angle),
  from[2],
];

export interface HeadPose {
  carriage: Point;
  /** On the axis of A, where the arm of C ends. */
  pivot: Point;
  focus: Point;
  /** From the focus to the head. */
  beam: Point;
  a_rad: number;
  c_rad: number;
}

export function head_pose(k: Kinematics, joints: Axes): HeadPose {
  const a = rad(axis(joints, 'A'));
  const c = rad(axis(joints, 'C'));
  const carriage: Point = [axis(joints, 'X'), axis(joints, 'Y'), axis(joints, 'Z')];
  const r_c = length_of(k, 'r_c');
  const r_a = length_of(k, 'r_a');
  const pivot: Point = [
    carriage[0] + r_c * Math.cos(c),
    carriage[1] + r_c * Math.sin(c),
    carriage[2],
  ];
  const beam: Point = [Math.sin(a) * Math.sin(c), -Math.sin(a) * Math.cos(c), Math.cos(a)];
  const focus = pivot.map((value, i) => value - r_a * beam[i]) as Point;
  return { carriage, pivot, focus, beam, a_rad: a, c_rad: c };
}

export interface TurningPose {
  /** How far the work has turned. */
  work_rad: number;
  tip: Point;
}

export function turning_pose(k: Kinematics, joints: Axes): TurningPose {
  const work = rad(axis(joints, 'C') + length_of(k, 'theta0_deg'));
  const radius = axis(joints, 'X') + length_of(k, 'x1');
  return {
    work_rad: work,
    tip: [radius * Math.cos(work), radius * Math.sin(work), axis(joints, 'Z') + length_of(k, 'z0')],
  };
}

/** Where the tip is when the joints stand so. */
export function tip_of(k: Kinematics, joints: Axes): Point {
  if (k.kind === 'arm') return arm_pose(k, joints).wrist;
  if (k.kind === 'head-ac') return head_pose(k, joints).focus;
  if (k.kind === 'x-theta-z') return turning_pose(k, joints).tip;
  return [axis(joints, 'X'), axis(joints, 'Y'), axis(joints, 'Z')];
}

/**
 * Joints that hold the tip, as near to `before` as they can be: for instants that only the path knows. On places where the
 * linkage has no answer the joints stay where they were.
 */
export function joints_of(k: Kinematics, tip: Point, rotary: Axes, before: Axes): Axes {
  if (k.kind === 'arm') return arm_joints(k, tip, rotary, before);
  if (k.kind === 'head-ac') return head_joints(k, tip, rotary);
  if (k.kind === 'x-theta-z') return turning_joints(k, tip, before);
  return { ...before, X: tip[0], Y: tip[1], Z: tip[2], ...rotary };
}

function head_joints(k: Kinematics, tip: Point, rotary: Axes): Axes {
  const at_origin = head_pose(k, { ...rotary, X: 0, Y: 0, Z: 0 }).focus;
  return {
    X: tip[0] - at_origin[0],
    Y: tip[1] - at_origin[1],
    Z: tip[2] - at_origin[2],
    A: axis(rotary, 'A'),
    C: axis(rotary, 'C'),
  };
}

function turning_joints(k: Kinematics, tip: Point, before: Axes): Axes {
  const radius = Math.hypot(tip[0], tip[1]);
  const open = radius < 1e-9;
  const c = open ? axis(before, 'C') : deg(Math.atan2(tip[1], tip[0])) - length_of(k, 'theta0_deg');
  return {
    X: radius - length_of(k, 'x1'),
    C: nearest_turn(c, axis(before, 'C'), 360),
    Z: tip[2] - length_of(k, 'z0'),
  };
}

function arm_joints(k: Kinematics, tip: Point, rotary: Axes, before: Axes): Axes {
  const upper = length_of(k, 'upper_arm');
  const fore = length_of(k, 'forearm');
  const r = Math.hypot(tip[0], tip[1]);
  if (r > upper + fore + 1e-6 || r < Math.abs(upper - fore) - 1e-6) return before;
  const elbow = elbow_side(k, before) * elbow_angle(upper, fore, r);
  const shoulder =
    Math.atan2(tip[1], tip[0]) - Math.atan2(fore * Math.sin(elbow), upper + fore * Math.cos(elbow));
  const t2 = nearest_turn(deg(shoulder), axis(before, 'T2'), 360);
  const t1 = k.forearm_absolute ? deg(shoulder + elbow) : deg(elbow);
  const heading = axis(rotary, 'C') - deg(shoulder + elbow);
  return { T1: t1, T2: t2, T3: nearest_turn(heading, axis(before, 'T3'), 180), Z: tip[2] };
}

/** As it is bent; where the arm is straight, as the machine says. */
function elbow_side(k: Kinematics, before: Axes): 1 | -1 {
  const t1 = axis(before, 'T1');
  const sine = Math.sin(rad(k.forearm_absolute ? t1 - axis(before, 'T2') : t1));
  const is_minus = Math.abs(sine) < 1e-12 ? k.elbow === 'minus' : sine < 0;
  return is_minus ? -1 : 1;
}

/** At which the wrist is so far from the shoulder; by halves, which stay exact where the arm is nearly straight. */
function elbow_angle(upper: number, fore: number, r: number): number {
  const sum = upper + fore;
  const difference = upper - fore;
  const opening = Math.sqrt(Math.max(0, (sum - r) * (sum + r)));
  const closing = Math.sqrt(Math.max(0, (r - difference) * (r + difference)));
  return 2 * Math.atan2(opening, closing);
}

const nearest_turn = (angle: number, to: number, turn: number): number =>
  angle + turn * Math.round((to - angle) / turn);
