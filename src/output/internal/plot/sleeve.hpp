#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "output/internal/plot/space.hpp"

namespace kerf::output::plot {

/// Simplifies a polyline in one pass, in constant time and memory per point: says which points to
/// keep so that every point left out lies within the tolerance of the polyline of those kept, in
/// each coordinate.
///
/// From the last point kept, the anchor, a straight line is laid along the axis on which the path
/// goes furthest, s. Each point at s lets the line pass it at +-tolerance, so it leaves the line's
/// two slopes an interval; the intervals of all points are intersected as they come. A point whose
/// own slope lies inside can be the line's end in place of the one before it. A point outside, or
/// one that goes back along s, cannot: the point before it is kept and is the next anchor.
///
///            .-'   widest line that all points so far allow
///        o .-' o
///    A <    o      -->  s
///          '-.
///             '-.  steepest the other way
class Sleeve {
 public:
  /// `tolerance` > 0, mm.
  explicit Sleeve(double tolerance = 1) : tolerance_(tolerance) {}

  void start(const Point3& at) {
    anchor_ = end_ = at;
    open_ = false;
  }

  /// The last point added: the path's end, to be kept when the path stops here.
  [[nodiscard]] const Point3& end() const { return end_; }

  /// Adds the path's next point. True: the point before it must be kept; it is anchor() now.
  bool add(const Point3& point) {
    const bool fits = !open_ || narrow(point - anchor_);
    if (!fits) start(end_);
    if (!open_) open(point - anchor_);
    end_ = point;
    return !fits;
  }
  [[nodiscard]] const Point3& anchor() const { return anchor_; }

 private:
  // An interval of slopes, aside over along > 0. The first point's slopes are at most 1.
  struct Slopes {
    double low = -2, high = 2;
    [[nodiscard]] bool allows(double aside, double along) const {
      return aside >= low * along && aside <= high * along;
    }
    void narrow(double aside, double along, double tolerance) {
      if (aside - tolerance > low * along) low = (aside - tolerance) / along;
      if (aside + tolerance < high * along) high = (aside + tolerance) / along;
    }
  };

  // Points within the tolerance of the anchor say nothing about a direction.
  void open(const Point3& step) {
    const Point3 reach{std::abs(step[kX]), std::abs(step[kY]), std::abs(step[kZ])};
    const double furthest = std::max({reach[kX], reach[kY], reach[kZ]});
    if (furthest <= tolerance_) return;
    along_ = reach[kX] == furthest ? kX : reach[kY] == furthest ? kY : kZ;
    sign_ = step[along_] < 0 ? -1 : 1;
    side_ = {(along_ + 1) % 3, (along_ + 2) % 3};
    reach_ = 0;
    first_ = second_ = Slopes{};
    open_ = true;
    narrow(step);
  }

  bool narrow(const Point3& step) {
    const double along = step[along_] * sign_;
    if (along < reach_) return false;
    const double a = step[side_[0]], b = step[side_[1]];
    if (!first_.allows(a, along) || !second_.allows(b, along)) return false;
    first_.narrow(a, along, tolerance_);
    second_.narrow(b, along, tolerance_);
    reach_ = along;
    return true;
  }

  double tolerance_;
  Point3 anchor_{}, end_{};
  bool open_ = false;      // whether a direction is chosen
  std::size_t along_ = 0;  // the coordinate that is s
  double sign_ = 1;
  std::array<std::size_t, 2> side_{};
  double reach_ = 0;  // s of the end
  Slopes first_, second_;
};

}  // namespace kerf::output::plot
