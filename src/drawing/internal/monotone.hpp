#pragma once

#include <algorithm>
#include <cmath>

#include "drawing/fit.hpp"

namespace kerf::drawing {

/// The tangent of half the angle from `a` to `b`, which are not 0 and no more than half a turn
/// apart.
inline double half_tangent(Vec2 a, Vec2 b) {
  const double lengths = std::sqrt(geometry::dot(a, a) * geometry::dot(b, b));
  return geometry::cross(a, b) / (lengths + geometry::dot(a, b));
}

/// How far a point is from a circle at most, whose distance from the centre, squared, differs by
/// `square` at most from the radius squared: (d - r)(d + r) = d² - r².
inline double way_from_square(double square, double radius) {
  return square / (radius + std::sqrt(std::max(0.0, radius * radius - square)));
}

/// The lens of a piece between its ends: the heights of the two arcs over the chord, mm, positive
/// to the right of it (a piece that turns left).
struct Lens {
  double at_begin;  ///< of the arc that touches at the beginning
  double at_end;
  bool is_flat;  ///< neither arc is more than 2 · 45 degrees: beyond that nothing is proven here

  [[nodiscard]] bool is_straight() const {
    return is_flat && std::max(std::abs(at_begin), std::abs(at_end)) <= kStraight_mm;
  }
  [[nodiscard]] bool turns_one_way() const { return (at_begin >= 0) == (at_end >= 0); }
  [[nodiscard]] double width() const { return std::abs(at_begin - at_end); }
};

inline Lens lens_of(Vec2 chord, Vec2 begins, Vec2 ends) {
  constexpr double kFlat = 0.41421356;  // tan(45° / 2)
  const double from = half_tangent(begins, chord);
  const double to = half_tangent(chord, ends);
  const double half = 0.5 * geometry::length(chord);
  const bool goes_on = geometry::dot(begins, chord) > 0 && geometry::dot(chord, ends) > 0;
  return {half * from, half * to, goes_on && std::max(std::abs(from), std::abs(to)) <= kFlat};
}

/// The two arcs that meet with one tangent at the middle of the line between two points that are
/// equally far along the end tangents (K. M. Bolton, "Biarc curves", Comput.-Aided Des. 7, 1975).
inline void append_biarc(Vec2 from, Vec2 to, Vec2 begins, Vec2 ends, Fit& fit) {
  const Vec2 chord = to - from;
  const Vec2 first = geometry::unit(begins);
  const Vec2 last = geometry::unit(ends);
  const double along = geometry::dot(chord, first + last);
  const double square = geometry::dot(chord, chord);
  const double open = 2 * (1 - geometry::dot(first, last));
  const double reach = square / (along + std::sqrt(along * along + open * square));
  const Vec2 joint = 0.5 * (from + to + reach * (first - last));
  fit.steps.push_back({joint, half_tangent(first, joint - from)});
  fit.steps.push_back({to, half_tangent(to - joint, last)});
}

/// Whether it is no number, or so far out that its path is refused whatever it is between its ends
/// (Canvas): there would be no end of halves.
inline bool is_beyond_all(Vec2 point) {
  constexpr double kBeyond_mm = 1e7;
  return !(std::abs(point.u) < kBeyond_mm && std::abs(point.v) < kBeyond_mm);
}

/// Appends what stands for a piece of monotone curvature. A Piece has begin(), end(), and its
/// directions there, begins() and ends(), which are not 0; is_point(), and halves().
template <typename Piece>
void fit_monotone(const Piece& piece, Fit& fit, int depth = 0) {
  constexpr int kDeepest = 40;
  const Vec2 from = piece.begin();
  const Vec2 to = piece.end();
  if (piece.is_point() || depth >= kDeepest || is_beyond_all(from) || is_beyond_all(to)) {
    fit.steps.push_back({to, 0});
    return;
  }
  const Vec2 chord = to - from;
  if (chord != Vec2{}) {
    const Lens lens = lens_of(chord, piece.begins(), piece.ends());
    if (lens.is_straight()) {
      fit.error = std::max({fit.error, std::abs(lens.at_begin), std::abs(lens.at_end)});
      fit.steps.push_back({to, 0});
      return;
    }
    if (lens.is_flat && lens.turns_one_way() && lens.width() <= fit.tolerance) {
      fit.error = std::max(fit.error, lens.width());
      append_biarc(from, to, piece.begins(), piece.ends(), fit);
      return;
    }
  }
  const auto [low, high] = piece.halves();
  fit_monotone(low, fit, depth + 1);
  fit_monotone(high, fit, depth + 1);
}

}  // namespace kerf::drawing
