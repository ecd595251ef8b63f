/**
 * How much detail a frame may have. Frames of a picture that changes - it is turned, the machine runs, the path arrives - get as
 * much as can be drawn fluently on this computer; once it rests, it is drawn with all of it.
 */
export interface Level {
  /** Pixels that a drawn path may leave the true one. */
  slack_px: number;
  /** One of so many pieces of the path is drawn: where it is dense, pieces lie on each other anyway. */
  one_of: number;
}

export const FINE: Level = { slack_px: 0.7, one_of: 1 };
const LEVELS: Level[] = [
  FINE,
  { slack_px: 1.4, one_of: 1 },
  { slack_px: 2.8, one_of: 1 },
  { slack_px: 4, one_of: 2 },
  { slack_px: 4, one_of: 4 },
  { slack_px: 6, one_of: 8 },
  { slack_px: 6, one_of: 16 },
];
/** A picture that was not drawn for so long rests. */
export const REST_AFTER_MS = 180;
/** Of so few nothing is left out: if frames are slow, they are not what it costs, and a gap would be seen. */
const FEW_SEGMENTS = 30_000;
const VERY_SLOW_MS = 150;
const SLOW_MS = 45;
const QUICK_MS = 18;

/** A picture of the part in all its cells may take so long while it moves. */
const FLUENT_MS = 30;

export class Detail {
  private index = 2;
  private whole_ms = 0;

  /** Whether a picture that moves shows the part in fewer cells. */
  get is_coarse(): boolean {
    return this.whole_ms > FLUENT_MS;
  }
  /** A frame with all cells of the part took `cost_ms`. */
  took_whole(cost_ms: number): void {
    this.whole_ms = cost_ms;
  }

  /** For the next frame of a picture that changes, with a path of so many segments. */
  level(segments: number): Level {
    return segments > FEW_SEGMENTS ? LEVELS[this.index] : FINE;
  }

  /** Such a frame took `cost_ms`. */
  took(cost_ms: number): void {
    if (cost_ms > SLOW_MS) this.move(cost_ms > VERY_SLOW_MS ? 2 : 1);
    else if (cost_ms < QUICK_MS) this.move(-1);
  }

  private move(by: number): void {
    this.index = Math.min(LEVELS.length - 1, Math.max(0, this.index + by));
  }
}

/** In how many frames a picture at rest is drawn, so that each of them is done soon. */
export const slices_at_rest = ({ one_of }: Level): number => one_of;
