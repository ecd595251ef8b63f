#pragma once

#include <cmath>

#include "stock/field/lane_work.hpp"
#include "stock/field/lanes.hpp"
#include "stock/field/torus_slope.hpp"

// The lowest surface that one piece of a tool leaves along a straight way, over as many columns as
// there are lanes: at `along`, √across2 beside the way.
namespace kerf::stock::field {
namespace KERF_LANES {

struct ColumnLanes {
  Lanes along;
  Lanes across2;
  Lanes offset;  // signed, to the left of the feed
};

inline float narrow(double value) { return static_cast<float>(value); }

/// The steps of a way at which a piece of an outer radius is over columns. `none` is added to
/// heights, and makes them none where there are no such steps.
struct StepLanes {
  StepLanes(const StraightSight& way, float reach2, const ColumnLanes& at) {
    const Lanes w2 = reach2 - at.across2;
    const Lanes w = root(w2);
    first = larger(at.along - way.length, -w);
    last = smaller(at.along, w);
    none = (w2 >= Lanes{} ? Lanes{} : all(kNowhere)) + (first <= last ? Lanes{} : all(kNowhere));
  }
  Lanes first;
  Lanes last;
  Lanes none;
};

inline Lanes face_low(const StraightSight& way, const EnvelopePiece& piece, const ColumnLanes& at) {
  const StepLanes steps(way, narrow(piece.s1 * piece.s1), at);
  return way.z + narrow(piece.z) + way.slope * (at.along - steps.last) + steps.none;
}

/// The gradient along the way of a cone of the slope k is k x / s: equal to the way's slope m at
/// x = u m / √(k² - m²), never where the way is as steep as the cone.
inline Lanes cone_low(const StraightSight& way, const EnvelopePiece& piece, const ColumnLanes& at) {
  const float m = way.slope;
  const float k = narrow(piece.slope);
  const float lean2 = k > m ? m * m / (k * k - m * m) : 0.0F;
  const float steep = k > m ? 0.0F : kNowhere;
  const StepLanes steps(way, narrow(piece.s1 * piece.s1), at);
  const float inner = narrow(piece.s0);
  const float inner2 = narrow(piece.s0 * piece.s0);
  const float level = m > 0 ? 1.0F : 0.0F;  // a level way is lowest where the axis is nearest
  const Lanes best = level * larger(steep + root(at.across2 * lean2), root(inner2 - at.across2));
  const Lanes x = larger(steps.first, smaller(best, steps.last));
  const Lanes s = root(at.across2 + x * x);
  const Lanes over = k * larger(Lanes{}, s - inner);
  return way.z + narrow(piece.z) + m * (at.along - x) + over + steps.none;
}

inline bool is_whole_ball(const EnvelopePiece& piece) {
  constexpr double kWholeBall_mm = 1e-9;
  return piece.kind == EnvelopePiece::Kind::arc && piece.core == 0 && piece.s0 == 0 &&
         std::abs(piece.s1 - piece.radius) <= kWholeBall_mm;
}

/// A ball up to its equator. w is half the chord that the column's plane across the way cuts from
/// it. Under an end of the way that is x off the column its surface is √(w² - x²) below the axis;
/// between them the lowest place is w √(1 + m²) below where the axis is over the column, at
/// x = w m / √(1 + m²), unless an end comes before that.
struct BallLow {
  BallLow(const StraightSight& way, const EnvelopePiece& piece)
      : radius2(all(narrow(piece.radius * piece.radius))),
        base(all(way.z + narrow(piece.z))),
        top(base + way.slope * way.length),
        length(all(way.length)),
        slope(all(way.slope)),
        lean2(all(way.lean2)),
        steep2(all(1 + way.slope * way.slope)) {}

  [[nodiscard]] Lanes operator()(const ColumnLanes& at) const {
    const Lanes begin = at.along;
    const Lanes end = begin - length;
    const Lanes w2 = radius2 - at.across2;
    const Lanes best2 = w2 * lean2;
    const LaneInts at_begin = signed_square(begin) <= best2;
    const LaneInts at_either = at_begin | (signed_square(end) > best2);
    const Lanes x = pick(at_begin, begin, end);
    const Lanes under = pick(at_begin, base, top);
    const Lanes depth2 = pick(at_either, w2 - x * x, w2 * steep2);
    const Lanes z = pick(at_either, under, base + slope * begin) - root(depth2);
    return pick(depth2 >= Lanes{}, z, all(kNowhere));
  }

  // In all lanes, so that nothing is read anew for each block.
  Lanes radius2, base, top, length, slope, lean2, steep2;
};

/// A part of a ball.
inline Lanes cap_low(const StraightSight& way, const EnvelopePiece& piece, const ColumnLanes& at) {
  const float lean = way.slope / std::sqrt(1 + way.slope * way.slope);
  const StepLanes steps(way, narrow(piece.s1 * piece.s1), at);
  const float radius2 = narrow(piece.radius * piece.radius);
  const Lanes w2 = radius2 - at.across2;
  const Lanes best = root(w2) * lean;
  const Lanes x = larger(steps.first, smaller(best, steps.last));
  const Lanes z = way.z + narrow(piece.z) + way.slope * (at.along - x) - root(w2 - x * x);
  return z + steps.none;
}

inline Lanes level_torus_low(const StraightSight& way, const EnvelopePiece& piece,
                             const ColumnLanes& at) {
  const StepLanes steps(way, narrow(piece.s1 * piece.s1), at);
  const float radius2 = narrow(piece.radius * piece.radius);
  const float inner = narrow(piece.s0);
  const float core = narrow(piece.core);
  const Lanes x = larger(steps.first, smaller(Lanes{}, steps.last));
  const Lanes out = larger(all(inner), root(at.across2 + x * x)) - core;
  return way.z + narrow(piece.z) - root(radius2 - out * out) + steps.none;
}

/// On the slope of a torus the lowest place is found for each column by halving.
inline Lanes torus_low(const StraightSight& way, const EnvelopePiece& piece,
                       const ColumnLanes& at) {
  const StepLanes steps(way, narrow(piece.s1 * piece.s1), at);
  Lanes low = all(kNowhere);
  for (std::size_t i = 0; i < kLanes; ++i) {
    if (steps.none[i] > 0) continue;
    low[i] = torus_slope_low(piece, {.z = way.z,
                                     .slope = way.slope,
                                     .along = at.along[i],
                                     .across2 = at.across2[i],
                                     .first = steps.first[i],
                                     .last = steps.last[i]});
  }
  return low;
}

inline Lanes piece_low(const StraightSight& way, const EnvelopePiece& piece,
                       const ColumnLanes& at) {
  using Kind = EnvelopePiece::Kind;
  if (is_whole_ball(piece)) return BallLow(way, piece)(at);
  if (piece.kind == Kind::face) return face_low(way, piece, at);
  if (piece.kind == Kind::cone) return cone_low(way, piece, at);
  if (piece.core == 0 && piece.s0 == 0) return cap_low(way, piece, at);
  return way.slope == 0 ? level_torus_low(way, piece, at) : torus_low(way, piece, at);
}

}  // namespace KERF_LANES
}  // namespace kerf::stock::field
