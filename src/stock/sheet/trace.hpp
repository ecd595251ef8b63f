#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/contour/box.hpp"
#include "geometry/vec2.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock::sheet {

using contour::Box;
using geometry::Vec2;

/// A way of the beam over the sheet, mm, frame of the stock seen from +Z: a line, which may be a
/// place alone, or an arc. Made by straight() and round().
struct Trace {
  Vec2 from;
  Vec2 to;
  // Of an arc.
  double radius = 0;  ///< 0: it is a line
  Vec2 centre{};
  Vec2 middle{};        ///< unit, from the centre to the middle of the arc
  double cos_half = 0;  ///< cosine of half of its angle; -2: a whole circle
  double turn_rad = 0;  ///< not 0, positive counterclockwise, not more than a whole circle

  friend bool operator==(const Trace&, const Trace&) = default;
};

[[nodiscard]] Trace straight(Vec2 from, Vec2 to);
/// Precondition: radius > 0, turn_rad not 0. What is more than a whole circle is one.
[[nodiscard]] Trace round(Vec2 centre, double radius, double angle_rad, double turn_rad);

/// Distances to a line from its nearest point, for many places.
class DistanceToLine {
 public:
  DistanceToLine(Vec2 from, Vec2 to) : from_(from), way_(to - from) {
    const double square = dot(way_, way_);
    if (square > 0 && std::isfinite(1 / square)) inverse_ = 1 / square;
  }
  [[nodiscard]] double operator()(double x, double y) const {
    const double u = x - from_.u;
    const double v = y - from_.v;
    double share = (u * way_.u + v * way_.v) * inverse_;
    share = share < 0 ? 0 : share;
    share = share > 1 ? 1 : share;
    const double du = u - share * way_.u;
    const double dv = v - share * way_.v;
    return std::sqrt(du * du + dv * dv);
  }

 private:
  Vec2 from_;
  Vec2 way_;
  double inverse_ = 0;  // of the square of its length; 0: a place
};

/// Likewise to an arc: within its sector from the circle, elsewhere from the nearer end.
class DistanceToArc {
 public:
  explicit DistanceToArc(const Trace& arc) : arc_(arc) {}
  [[nodiscard]] double operator()(double x, double y) const {
    const double u = x - arc_.centre.u;
    const double v = y - arc_.centre.v;
    const double rho = std::sqrt(u * u + v * v);
    const bool is_beside = u * arc_.middle.u + v * arc_.middle.v >= arc_.cos_half * rho;
    const double to_ends = std::min(square(x, y, arc_.from), square(x, y, arc_.to));
    return is_beside ? std::fabs(rho - arc_.radius) : std::sqrt(to_ends);
  }

 private:
  [[nodiscard]] static double square(double x, double y, Vec2 end) {
    return (x - end.u) * (x - end.u) + (y - end.v) * (y - end.v);
  }

  Trace arc_;
};

/// From the nearest point of the trace.
[[nodiscard]] double distance(const Trace& trace, Vec2 place);
/// Holds every point of it; of an arc that of its circle may be taken.
[[nodiscard]] Box extents(const Trace& trace);
[[nodiscard]] double length(const Trace& trace);
/// Its beginning, up to this share of its way, in (0, 1].
[[nodiscard]] Trace part(const Trace& trace, double share);

/// Adds the ways that a way makes seen from +Z. Lines and circles in the plane stay what they are;
/// of anything else no point is farther than `tolerance_mm` > 0 from where it is drawn.
void add_traces(const Way& way, double tolerance_mm, std::vector<Trace>& traces);

}  // namespace kerf::stock::sheet
