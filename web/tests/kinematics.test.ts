import { describe, expect, it } from 'vitest';
import { arm_pose, head_pose, joints_of, tip_of } from '../src/logic/kinematics';
import type { Kinematics } from '../src/logic/protocol';
import { random } from './random';

const ARM: Kinematics = { kind: 'arm', upper_arm: 132, forearm: 132, forearm_absolute: false };
const HEAD: Kinematics = { kind: 'head-ac', r_a: 150, r_c: 80 };
const TURNING: Kinematics = { kind: 'x-theta-z', x1: 25, theta0_deg: 10, z0: 5 };

const near = (a: readonly number[], b: readonly number[]) =>
  a.forEach((value, i) => expect(value).toBeCloseTo(b[i], 6));

describe('the head', () => {
  // Rows that `kerf run examples/13_tube/tube.tch --points` has written: tip and angles, then joints.
  it.each([
    [
      [0.0020322504784313724, -0.0002456381908496732, 0.002007843137254902],
      [0.0006023529411764705, 0.0003722708496732026],
      [-79.9979677375869, -0.0023423826660533913, 150.00200783484794],
    ],
    [
      [0.01625800382745098, -0.0019651055267973856, 0.016062745098039215],
      [0.004818823529411764, 0.0029781667973856206],
      [-79.98374123235408, -0.018739061295167232, 150.01606221458255],
    ],
  ] as const)('stands where the machine has it', (tip, [A, C], [X, Y, Z]) => {
    near(tip_of(HEAD, { X, Y, Z, A, C }), tip);
    const joints = joints_of(HEAD, [...tip], { A, C }, {});
    near([joints.X, joints.Y, joints.Z], [X, Y, Z]);
  });
  it('keeps its lengths whatever the angles', () => {
    const { carriage, pivot, focus } = head_pose(HEAD, { X: 5, Y: -3, Z: 200, A: 37, C: 211 });
    expect(Math.hypot(...carriage.map((v, i) => v - pivot[i]))).toBeCloseTo(80, 9);
    expect(Math.hypot(...focus.map((v, i) => v - pivot[i]))).toBeCloseTo(150, 9);
  });
});

describe('the arm', () => {
  it('is stretched along X with its joints at 0', () => {
    near(arm_pose(ARM, { T1: 0, T2: 0, T3: 0, Z: 2 }).wrist, [264, 0, 2]);
  });
  it('counts the forearm from +X where a linkage drives it', () => {
    near(tip_of({ ...ARM, forearm_absolute: true }, { T1: 90, T2: 0, T3: 0, Z: 0 }), [132, 132, 0]);
  });
  it('finds joints that hold the tip, the elbow on the side where it was', () => {
    const next = random(11);
    for (let i = 0; i < 200; i++) {
      const joints = {
        T1: (next() < 0.5 ? -1 : 1) * (5 + 150 * next()),
        T2: 340 * (next() - 0.5),
        T3: 90 * next(),
        Z: 3,
      };
      const tip = tip_of(ARM, joints);
      const heading = joints.T1 + joints.T2 + joints.T3;
      const found = joints_of(
        ARM,
        tip,
        { C: heading },
        { ...joints, T1: joints.T1 + 1, T2: joints.T2 - 1 },
      );
      near([found.T1, found.T2, found.T3, found.Z], [joints.T1, joints.T2, joints.T3, joints.Z]);
    }
  });
  it('bends from stretched to the side that the machine file names', () => {
    const t1 = (elbow: string): number | undefined =>
      joints_of({ ...ARM, elbow }, [132, 132, 0], { C: 0 }, { T1: 0, T2: 0, T3: 0, Z: 0 }).T1;
    expect(t1('plus')).toBeCloseTo(90, 9);
    expect(t1('minus')).toBeCloseTo(-90, 9);
  });
  it('stays where it was when the tip is out of reach', () => {
    const before = { T1: 1, T2: 2, T3: 3, Z: 4 };
    expect(joints_of(ARM, [300, 0, 0], { C: 0 }, before)).toBe(before);
  });
});

describe('the turning work', () => {
  it('has its tip where its joints at 0 say', () => {
    near(tip_of(TURNING, { X: 0, C: 0, Z: 0 }), [
      25 * Math.cos(Math.PI / 18),
      25 * Math.sin(Math.PI / 18),
      5,
    ]);
  });
  it('finds joints on the nearest turn', () => {
    const joints = { X: 12, C: 735, Z: -4 };
    const found = joints_of(TURNING, tip_of(TURNING, joints), {}, { X: 0, C: 720, Z: 0 });
    near([found.X, found.C, found.Z], [12, 735, -4]);
  });
});

it('a machine without a linkage has its joints at the tip', () => {
  expect(tip_of({ kind: 'cartesian' }, { X: 1, Y: 2, Z: 3 })).toEqual([1, 2, 3]);
  expect(joints_of({ kind: 'cartesian' }, [1, 2, 3], { A: 30 }, { B: 7 })).toEqual({
    X: 1,
    Y: 2,
    Z: 3,
    A: 30,
    B: 7,
  });
});
