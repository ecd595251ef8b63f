/** Between two states of the machine, which come at most 20 times a second, its picture glides. */
import type { Point } from '../logic/kinematics';
import type { Axes } from '../logic/protocol';
import type { Pose } from './models';

const GLIDE_MS = 60;

export class PoseGlide {
  private from: Pose | null = null;
  private to: Pose | null = null;
  private since = 0;

  aim(pose: Pose, at_once: boolean, now: number): void {
    this.from = at_once ? null : this.at(now);
    this.to = pose;
    this.since = now;
  }

  forget(): void {
    this.from = this.to = null;
  }

  at(now: number): Pose | null {
    const { from, to } = this;
    if (!from || !to) return to;
    const share = Math.min(1, (now - this.since) / GLIDE_MS);
    return {
      ...to,
      tip: between(from.tip, to.tip, share),
      joints: axes_between(from.joints, to.joints, share),
    };
  }

  moves(now: number): boolean {
    return this.from !== null && now - this.since < GLIDE_MS;
  }
}

const between = (a: Point, b: Point, share: number): Point =>
  a.map((value, i) => value + share * (b[i] - value)) as Point;

function axes_between(a: Axes, b: Axes, share: number): Axes {
  return Object.fromEntries(
    Object.entries(b).map(([name, value]) => [
      name,
      (a[name] ?? value) + share * (value - (a[name] ?? value)),
    ]),
  );
}
