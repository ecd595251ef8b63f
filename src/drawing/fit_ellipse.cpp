#include <cmath>
#include <numbers>
#include <utility>

#include "drawing/fit.hpp"
#include "drawing/internal/monotone.hpp"
#include "drawing/pen.hpp"

namespace kerf::drawing {
namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;

Vec2 point_at(const Ellipse& ellipse, double angle) {
  return ellipse.centre + math::cos(angle) * ellipse.first + math::sin(angle) * ellipse.second;
}

Vec2 direction_at(const Ellipse& ellipse, double angle) {
  return math::cos(angle) * ellipse.second - math::sin(angle) * ellipse.first;
}

/// A part of an ellipse within a quarter of it between two of its axes.
struct EllipsePiece {
  const Ellipse& ellipse;
  double from;
  double to;

  [[nodiscard]] Vec2 begin() const { return point_at(ellipse, from); }
  [[nodiscard]] Vec2 end() const { return point_at(ellipse, to); }
  [[nodiscard]] Vec2 begins() const { return way() * direction_at(ellipse, from); }
  [[nodiscard]] Vec2 ends() const { return way() * direction_at(ellipse, to); }
  [[nodiscard]] bool is_point() const { return from == to; }
  [[nodiscard]] std::pair<EllipsePiece, EllipsePiece> halves() const {
    const double middle = 0.5 * (from + to);
    return {{ellipse, from, middle}, {ellipse, middle, to}};
  }

 private:
  [[nodiscard]] double way() const { return to < from ? -1 : 1; }
};

/// The same ellipse by its axes, and how far the parameter of these is behind that of the other.
std::pair<Ellipse, double> by_axes(const Ellipse& any) {
  const double along = geometry::dot(any.first, any.first) - geometry::dot(any.second, any.second);
  const double turn = 0.5 * math::atan2(2 * geometry::dot(any.first, any.second), along);
  return {{any.centre, point_at({{}, any.first, any.second}, turn),
           direction_at({{}, any.first, any.second}, turn)},
          turn};
}

/// No wider than a line: there and back along its longer axis.
void fit_flat(const Ellipse& axes, double from, double to, Fit& fit) {
  const double way = to < from ? -1 : 1;
  for (double turn = way * std::floor(way * from / kQuarter + 1) * kQuarter; way * (to - turn) > 0;
       turn += way * kQuarter)
    fit.steps.push_back({point_at(axes, turn), 0});
  fit.steps.push_back({point_at(axes, to), 0});
}

}  // namespace

void fit_ellipse(const Ellipse& ellipse, double from_rad, double sweep_rad, Fit& fit) {
  const auto [axes, behind] = by_axes(ellipse);
  double from = from_rad - behind;
  const double to = from + sweep_rad;
  if (geometry::length(axes.second) <= kStraight_mm) return fit_flat(axes, from, to, fit);
  const double way = sweep_rad < 0 ? -1 : 1;
  while (way * (to - from) > 0) {
    double next = way * std::floor(way * from / kQuarter + 1) * kQuarter;
    if (std::abs(next - from) < 1e-12) next += way * kQuarter;
    if (way * (next - to) > -1e-12) next = to;
    fit_monotone(EllipsePiece{axes, from, next}, fit);
    from = next;
  }
}

}  // namespace kerf::drawing
