#include "stock/field/straight_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::stock::field {
namespace {

// Of equal arguments either: the same as the instructions of processors, so loops take them.
constexpr double less(double a, double b) { return a < b ? a : b; }
constexpr double more(double a, double b) { return a > b ? a : b; }
double root(double squared) { return std::sqrt(more(0.0, squared)); }

/// The steps of a way at which a piece of the outer radius `reach` is over a column.
struct Steps {
  double first;
  double last;
  bool any;
};
Steps steps_over(const StraightSlope& way, double reach2, double along, double across2) {
  const double w2 = reach2 - across2;
  const double w = root(w2);
  const double first = more(along - way.length, -w);
  const double last = less(along, w);
  return {first, last, w2 >= 0 && first <= last};
}

void lower_by_face(const StraightSlope& way, const EnvelopePiece& piece, const BlockValues& along,
                   const BlockValues& across2, BlockValues& low) {
  const double reach2 = piece.s1 * piece.s1;
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const Steps steps = steps_over(way, reach2, along[i], across2[i]);
    const double z = way.z + way.slope * (along[i] - steps.last) + piece.z;
    low[i] = steps.any ? less(low[i], z) : low[i];
  }
}

/// The gradient along the way of a cone of the slope k is k x / s: equal to the way's slope m at
/// x = u m / √(k² - m²), never where the way is as steep as the cone.
void lower_by_cone(const StraightSlope& way, const EnvelopePiece& piece, const BlockValues& along,
                   const BlockValues& across2, BlockValues& low) {
  const double m = way.slope;
  const double k = piece.slope;
  const double lean2 = k > m ? m * m / (k * k - m * m) : 0;
  const double steep = k > m ? 0 : kNowhere;
  const double reach2 = piece.s1 * piece.s1;
  const double inner2 = piece.s0 * piece.s0;
  const double level = m > 0 ? 1 : 0;  // a level way is lowest where the axis is nearest
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const Steps steps = steps_over(way, reach2, along[i], across2[i]);
    const double best = level * more(steep + root(across2[i] * lean2), root(inner2 - across2[i]));
    const double x = more(steps.first, less(best, steps.last));
    const double s = std::sqrt(across2[i] + x * x);
    const double z = way.z + m * (along[i] - x) + piece.z + k * more(0.0, s - piece.s0);
    low[i] = steps.any ? less(low[i], z) : low[i];
  }
}

/// A ball: x = w m / √(1 + m²), where w is half the chord that the column's plane across the axis
/// cuts from it.
void lower_by_ball(const StraightSlope& way, const EnvelopePiece& piece, const BlockValues& along,
                   const BlockValues& across2, BlockValues& low) {
  const double lean = way.slope / std::sqrt(1 + way.slope * way.slope);
  const double reach2 = piece.s1 * piece.s1;
  const double radius2 = piece.radius * piece.radius;
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const Steps steps = steps_over(way, reach2, along[i], across2[i]);
    const double w2 = radius2 - across2[i];
    const double best = root(w2) * lean;
    const double x = more(steps.first, less(best, steps.last));
    const double z = way.z + way.slope * (along[i] - x) + piece.z - root(w2 - x * x);
    low[i] = steps.any ? less(low[i], z) : low[i];
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
    return out * x > slope_ * s * root(piece_.radius * piece_.radius - out * out);
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

  [[nodiscard]] double depth_at(double x) const {
    const double s = more(piece_.s0, std::sqrt(across2_ + x * x));
    const double out = s - piece_.core;
    return root(piece_.radius * piece_.radius - out * out);
  }
  [[nodiscard]] double step_at(double depth, double first, double last) const {
    const double s = piece_.core + root(piece_.radius * piece_.radius - depth * depth);
    return more(first, less(root(s * s - across2_), last));
  }

  const EnvelopePiece& piece_;
  double slope_;
  double across2_;
};

void lower_by_torus(const StraightSlope& way, const EnvelopePiece& piece, const BlockValues& along,
                    const BlockValues& across2, BlockValues& low) {
  const double reach2 = piece.s1 * piece.s1;
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const Steps steps = steps_over(way, reach2, along[i], across2[i]);
    if (!steps.any) continue;
    const ArcSlope arc(piece, way.slope, across2[i]);
    double x = steps.last;
    if (x > 0 && arc.rises_at(x)) {
      const double from = more(steps.first, 0.0);
      x = arc.rises_at(from) ? from : arc.lowest(from, x);
    }
    const double s = std::sqrt(across2[i] + x * x);
    low[i] = less(low[i], way.z + way.slope * (along[i] - x) + piece.at(s));
  }
}

void lower_by_level_torus(const StraightSlope& way, const EnvelopePiece& piece,
                          const BlockValues& along, const BlockValues& across2, BlockValues& low) {
  const double reach2 = piece.s1 * piece.s1;
  const double radius2 = piece.radius * piece.radius;
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const Steps steps = steps_over(way, reach2, along[i], across2[i]);
    const double x = more(steps.first, less(0.0, steps.last));
    const double out = more(piece.s0, std::sqrt(across2[i] + x * x)) - piece.core;
    const double z = way.z + piece.z - root(radius2 - out * out);
    low[i] = steps.any ? less(low[i], z) : low[i];
  }
}

}  // namespace

void lower_by_piece(const StraightSlope& way, const EnvelopePiece& piece, const BlockValues& along,
                    const BlockValues& across2, BlockValues& low) {
  using Kind = EnvelopePiece::Kind;
  if (piece.kind == Kind::face) return lower_by_face(way, piece, along, across2, low);
  if (piece.kind == Kind::cone) return lower_by_cone(way, piece, along, across2, low);
  if (piece.core == 0 && piece.s0 == 0) return lower_by_ball(way, piece, along, across2, low);
  if (way.slope == 0) return lower_by_level_torus(way, piece, along, across2, low);
  lower_by_torus(way, piece, along, across2, low);
}

void lowest_at(const LowerEnvelope& tool, const RowValues& distance, const RowValues& tip,
               RowValues& lowest) {
  const LowerEnvelope::Round* round = tool.round();
  if (round == nullptr) {
    for (std::size_t i = 0; i < kTileBlocks; ++i) lowest[i] = tip[i] + tool.at(distance[i]);
    return;
  }
  const double reach = tool.reach();
  const double core = more(0.0, round->core);
  const double z = round->z;
  const double radius2 = round->radius * round->radius;
  const double base = round->core - core;  // of a shrunk ball's centre beyond the axis
  for (std::size_t i = 0; i < kTileBlocks; ++i) {
    const double out = more(0.0, distance[i] - core) - base;
    const double over = tip[i] + z - root(radius2 - out * out);
    lowest[i] = distance[i] <= reach ? over : kNowhere;
  }
}

void lower_level(const LowerEnvelope& tool, double z, const BlockValues& distance,
                 BlockValues& low) {
  for (const EnvelopePiece& piece : tool.pieces()) {
    for (std::size_t i = 0; i < kBlockCells; ++i) {
      const double over = z + piece.at(distance[i]);
      low[i] = distance[i] <= piece.s1 ? less(low[i], over) : low[i];
    }
  }
}

}  // namespace kerf::stock::field
