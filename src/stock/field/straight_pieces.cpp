#include "stock/field/straight_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "stock/field/lanes.hpp"

namespace kerf::stock::field {
namespace {

constexpr double kWholeBall_mm = 1e-9;

float narrow(double value) { return static_cast<float>(value); }

/// The steps of a way at which a piece of an outer radius is over the columns of a block. `none` is
/// added to heights, and makes them none where there are no such steps: what is branched around
/// cannot be done for several columns at once.
struct Steps {
  Steps(const StraightSlope& way, float reach2, const BlockValues& along,
        const BlockValues& across2) {
    for (std::size_t i = 0; i < kBlockCells; ++i) {
      const float w2 = reach2 - across2[i];
      const float w = root(w2);
      first[i] = larger(along[i] - way.length, -w);
      last[i] = smaller(along[i], w);
      none[i] = (w2 >= 0 ? 0.0F : kNowhere) + (first[i] <= last[i] ? 0.0F : kNowhere);
    }
  }
  BlockValues first;
  BlockValues last;
  BlockValues none;
};

void lower_by_face(const StraightSlope& way, const EnvelopePiece& piece, const BlockValues& along,
                   const BlockValues& across2, BlockValues& low) {
  const Steps steps(way, narrow(piece.s1 * piece.s1), along, across2);
  const float base = way.z + narrow(piece.z);
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    low[i] = smaller(low[i], base + way.slope * (along[i] - steps.last[i]) + steps.none[i]);
  }
}

/// The gradient along the way of a cone of the slope k is k x / s: equal to the way's slope m at
/// x = u m / √(k² - m²), never where the way is as steep as the cone.
void lower_by_cone(const StraightSlope& way, const EnvelopePiece& piece, const BlockValues& along,
                   const BlockValues& across2, BlockValues& low) {
  const float m = way.slope;
  const float k = narrow(piece.slope);
  const float lean2 = k > m ? m * m / (k * k - m * m) : 0.0F;
  const float steep = k > m ? 0.0F : kNowhere;
  const Steps steps(way, narrow(piece.s1 * piece.s1), along, across2);
  const float inner = narrow(piece.s0);
  const float inner2 = narrow(piece.s0 * piece.s0);
  const float level = m > 0 ? 1.0F : 0.0F;  // a level way is lowest where the axis is nearest
  const float base = way.z + narrow(piece.z);
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const float best = level * larger(steep + root(across2[i] * lean2), root(inner2 - across2[i]));
    const float x = larger(steps.first[i], smaller(best, steps.last[i]));
    const float s = std::sqrt(across2[i] + x * x);
    const float z = base + m * (along[i] - x) + k * larger(0.0F, s - inner);
    low[i] = smaller(low[i], z + steps.none[i]);
  }
}

/// A ball up to its equator. w is half the chord that the column's plane across the way cuts from
/// it; the lowest place is at x = w m / √(1 + m²), w / √(1 + m²) below the axis, unless an end of
/// the way comes before it. Which it is shows in squares, so that one root is enough.
void lower_by_ball(const StraightSlope& way, const EnvelopePiece& piece, const BlockValues& along,
                   const BlockValues& across2, BlockValues& low) {
  const float steep2 = 1 + way.slope * way.slope;
  const float lean2 = way.slope * way.slope / steep2;
  const float upright2 = 1 / steep2;
  const float radius2 = narrow(piece.radius * piece.radius);
  const float base = way.z + narrow(piece.z);
  const Lanes none{};
  for (std::size_t i = 0; i < kBlockCells; i += kLanes) {
    const Lanes begin = load(&along[i]);
    const Lanes end = begin - way.length;
    const Lanes w2 = radius2 - load(&across2[i]);
    const Lanes best2 = w2 * lean2;
    const auto at_begin = (begin <= none) | (begin * begin <= best2);
    const auto at_end = (end > none) & (end * end > best2);
    const Lanes at = at_begin ? begin : end;
    const Lanes depth2 = (at_begin | at_end) ? w2 - at * at : w2 * upright2;
    const Lanes depth = root(depth2);
    const Lanes x = (at_begin | at_end) ? at : depth * way.slope;
    const Lanes z = base + way.slope * (begin - x) - depth;
    const Lanes before = load(&low[i]);
    store(((depth2 >= none) & (z < before)) ? z : before, &low[i]);
  }
}

/// A part of a ball.
void lower_by_cap(const StraightSlope& way, const EnvelopePiece& piece, const BlockValues& along,
                  const BlockValues& across2, BlockValues& low) {
  const float lean = way.slope / std::sqrt(1 + way.slope * way.slope);
  const Steps steps(way, narrow(piece.s1 * piece.s1), along, across2);
  const float radius2 = narrow(piece.radius * piece.radius);
  const float base = way.z + narrow(piece.z);
  for (std::size_t i = 0; i < kBlockCells; i += kLanes) {
    const Lanes w2 = radius2 - load(&across2[i]);
    const Lanes best = root(w2) * lean;
    const Lanes x = larger(load(&steps.first[i]), smaller(best, load(&steps.last[i])));
    const Lanes z = base + way.slope * (load(&along[i]) - x) - root(w2 - x * x);
    store(smaller(load(&low[i]), z + load(&steps.none[i])), &low[i]);
  }
}

/// Where an arc about (core, z) in the section of a tool is met along a way.
class ArcSlope {
 public:
  ArcSlope(const EnvelopePiece& piece, double slope, double across2)
      : piece_(piece), slope_(slope), across2_(across2) {}

  /// The surface rises along x here faster than the way does.
  [[nodiscard]] bool rises_at(double x) const {
    const double s = std::sqrt(across2_ + x * x);
    if (s < piece_.s0) return x > 0 && slope_ == 0;
    const double out = s - piece_.core;
    return out * x > slope_ * s * half_chord(piece_.radius * piece_.radius - out * out);
  }
  /// Between a step at which it does not and one at which it does, by halving the height above the
  /// centre, which near the steep end of the arc changes more than x does.
  [[nodiscard]] double lowest(double first, double last) const {
    double falls = depth_at(first);
    double rises = depth_at(last);
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (falls + rises) / 2;
      (rises_at(step_at(middle, first, last)) ? rises : falls) = middle;
    }
    return step_at((falls + rises) / 2, first, last);
  }

 private:
  static constexpr int kHalvings = 40;

  static double half_chord(double squared) { return std::sqrt(std::max(0.0, squared)); }

  [[nodiscard]] double depth_at(double x) const {
    const double s = std::max(piece_.s0, std::sqrt(across2_ + x * x));
    const double out = s - piece_.core;
    return half_chord(piece_.radius * piece_.radius - out * out);
  }
  [[nodiscard]] double step_at(double depth, double first, double last) const {
    const double s = piece_.core + half_chord(piece_.radius * piece_.radius - depth * depth);
    return std::clamp(half_chord(s * s - across2_), first, last);
  }

  const EnvelopePiece& piece_;
  double slope_;
  double across2_;
};

void lower_by_torus(const StraightSlope& way, const EnvelopePiece& piece, const BlockValues& along,
                    const BlockValues& across2, BlockValues& low) {
  const Steps steps(way, narrow(piece.s1 * piece.s1), along, across2);
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    if (steps.none[i] > 0) continue;
    const auto across = static_cast<double>(across2[i]);
    const ArcSlope arc(piece, static_cast<double>(way.slope), across);
    double x = static_cast<double>(steps.last[i]);
    if (x > 0 && arc.rises_at(x)) {
      const double from = std::max(static_cast<double>(steps.first[i]), 0.0);
      x = arc.rises_at(from) ? from : arc.lowest(from, x);
    }
    const float z = way.z + way.slope * (along[i] - narrow(x));
    low[i] = smaller(low[i], z + narrow(piece.at(std::sqrt(across + x * x))));
  }
}

void lower_by_level_torus(const StraightSlope& way, const EnvelopePiece& piece,
                          const BlockValues& along, const BlockValues& across2, BlockValues& low) {
  const Steps steps(way, narrow(piece.s1 * piece.s1), along, across2);
  const float radius2 = narrow(piece.radius * piece.radius);
  const float inner = narrow(piece.s0);
  const float core = narrow(piece.core);
  const float base = way.z + narrow(piece.z);
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const float x = larger(steps.first[i], smaller(0.0F, steps.last[i]));
    const float out = larger(inner, std::sqrt(across2[i] + x * x)) - core;
    low[i] = smaller(low[i], base - root(radius2 - out * out) + steps.none[i]);
  }
}

}  // namespace

void lower_by_piece(const StraightSlope& way, const EnvelopePiece& piece, const BlockValues& along,
                    const BlockValues& across2, BlockValues& low) {
  using Kind = EnvelopePiece::Kind;
  if (piece.kind == Kind::face) return lower_by_face(way, piece, along, across2, low);
  if (piece.kind == Kind::cone) return lower_by_cone(way, piece, along, across2, low);
  if (piece.core == 0 && piece.s0 == 0) {
    const bool whole = std::abs(piece.s1 - piece.radius) <= kWholeBall_mm;
    return (whole ? lower_by_ball : lower_by_cap)(way, piece, along, across2, low);
  }
  if (way.slope == 0) return lower_by_level_torus(way, piece, along, across2, low);
  lower_by_torus(way, piece, along, across2, low);
}

void lowest_at(const LowerEnvelope& tool, const BlockRow& row, const RowValues& distance,
               const RowValues& tip, RowValues& lowest) {
  const LowerEnvelope::Round* round = tool.round();
  if (round == nullptr) {
    for (std::size_t i = row.first; i < row.last; ++i) {
      lowest[i] = tip[i] + narrow(tool.at(static_cast<double>(distance[i])));
    }
    return;
  }
  const float reach = narrow(tool.reach());
  const float core = larger(0.0F, narrow(round->core));
  const float z = narrow(round->z);
  const float radius2 = narrow(round->radius * round->radius);
  const float base = narrow(round->core) - core;  // of a shrunk ball's centre beyond the axis
  for (std::size_t i = row.first; i < row.last; i += kLanes) {
    const Lanes from = load(&distance[i]);
    const Lanes out = larger(from - core, Lanes{}) - base;
    const Lanes over = load(&tip[i]) + z - root(radius2 - out * out);
    store(from <= all(reach) ? over : all(kNowhere), &lowest[i]);
  }
}

void lower_level(const LowerEnvelope& tool, float z, const BlockValues& distance,
                 BlockValues& low) {
  for (const EnvelopePiece& piece : tool.pieces()) {
    const float reach = narrow(piece.s1);
    for (std::size_t i = 0; i < kBlockCells; ++i) {
      if (distance[i] > reach) continue;
      low[i] = smaller(low[i], z + narrow(piece.at(static_cast<double>(distance[i]))));
    }
  }
}

}  // namespace kerf::stock::field
