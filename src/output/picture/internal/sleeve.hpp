#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "output/picture/internal/knot.hpp"

namespace kerf::output::plot {

/// Simplifies a polyline in one pass, in constant time and memory per point: says which points to
/// keep so that every point left out lies within the tolerance of the polyline of those kept, in
/// each coordinate. The value is a coordinate like the others, with a tolerance of its own.
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
  /// Both tolerances > 0: mm, and in the unit of the values.
  explicit Sleeve(double tolerance = 1, double value_tolerance = 1)
      : tolerance_(tolerance), mm_per_value_(tolerance / value_tolerance) {}

  void start(const Knot& at) {
    anchor_ = end_ = at;
    open_ = false;
  }

  /// The last point added: the path's end, to be kept when the path stops here.
  [[nodiscard]] const Knot& end() const { return end_; }

  /// Adds the path's next point. True: the point before it must be kept; it is anchor() now.
  bool add(const Knot& point) {
    const bool fits = !open_ || narrow(step_to(point));
    if (!fits) start(end_);
    if (!open_) open(step_to(point));
    end_ = point;
    return !fits;
  }
  [[nodiscard]] const Knot& anchor() const { return anchor_; }

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

  // From the anchor, with the value as a length.
  [[nodiscard]] Knot step_to(const Knot& point) const {
    return {point[kX] - anchor_[kX], point[kY] - anchor_[kY], point[kZ] - anchor_[kZ],
            (point[kValue] - anchor_[kValue]) * mm_per_value_};
  }

  // Points within the tolerance of the anchor say nothing about a direction.
  void open(const Knot& step) {
    along_ = 0;
    for (std::size_t i = 1; i < step.size(); ++i) {
      if (std::abs(step[i]) > std::abs(step[along_])) along_ = i;
    }
    if (std::abs(step[along_]) <= tolerance_) return;
    sign_ = step[along_] < 0 ? -1 : 1;
    for (std::size_t i = 0; i < slopes_.size(); ++i) side_[i] = (along_ + 1 + i) % step.size();
    reach_ = 0;
    slopes_ = {};
    open_ = true;
    narrow(step);
  }

  bool narrow(const Knot& step) {
    const double along = step[along_] * sign_;
    if (along < reach_) return false;
    for (std::size_t i = 0; i < slopes_.size(); ++i) {
      if (!slopes_[i].allows(step[side_[i]], along)) return false;
    }
    for (std::size_t i = 0; i < slopes_.size(); ++i) {
      slopes_[i].narrow(step[side_[i]], along, tolerance_);
    }
    reach_ = along;
    return true;
  }

  static constexpr std::size_t kSides = std::tuple_size_v<Knot> - 1;

  double tolerance_;
  double mm_per_value_;
  Knot anchor_{}, end_{};
  bool open_ = false;      // whether a direction is chosen
  std::size_t along_ = 0;  // the coordinate that is s
  double sign_ = 1;
  std::array<std::size_t, kSides> side_{};
  double reach_ = 0;  // s of the end
  std::array<Slopes, kSides> slopes_{};
};

}  // namespace kerf::output::plot
