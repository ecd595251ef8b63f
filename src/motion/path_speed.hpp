#pragma once

#include <cmath>
#include <cstdint>
#include <span>

#include "motion/curve.hpp"
#include "motion/motion.hpp"

namespace kerf::motion {

/// The speed that the program wants along a curve, in units of its parameter s a second:
///
///   constant   v(s) = speed; infinite: as fast as the axes can
///   surface    v(s) = F n(s) / 60, n = 1000 S / (2 π |x(s) - x0|), at most the spindle's limit:
///              feed per revolution under constant surface speed
///   growing    v(s)² = v0² + 2 a s: a thread whose lead grows by the same with every turn
///
/// Value type. Real-time safe.
class PathSpeed {
 public:
  /// Over a part of a curve up to part_end() the speed changes by this share of itself at most.
  static constexpr double kStep = 0.02;

  PathSpeed() = default;
  static PathSpeed constant(double speed);
  /// `feed` in mm per revolution, > 0. Precondition: spindle.follows_radius().
  static PathSpeed surface(const Spindle& spindle, double feed);
  /// `speed` > 0 at the begin of the curve, and 2 `rate` more of its square with every mm.
  static PathSpeed growing(double speed, double rate);
  /// The slower one of both where they meet, at `here`; elsewhere as that one goes on.
  static PathSpeed slower(const PathSpeed& a, double here_a, const PathSpeed& b, double here_b);

  [[nodiscard]] bool is_constant() const { return kind_ == Kind::constant; }
  /// At `s`.
  [[nodiscard]] double at(const Curve& curve, double s) const {
    return is_constant() ? value_ : changing_at(curve, s);
  }
  /// How long the part of the curve takes, from <= to: of lines to rounding, of other curves to
  /// 1e-4 of it.
  [[nodiscard]] double seconds(const Curve& curve, double from, double to) const;
  /// The constant speed that takes as long, from < to.
  [[nodiscard]] double mean(const Curve& curve, double from, double to) const {
    return is_constant() ? value_ : (to - from) / seconds(curve, from, to);
  }
  /// As far as a part from `from` may go that is driven at its mean(), at most `to`.
  [[nodiscard]] double part_end(const Curve& curve, double from, double to) const;
  /// For a parameter of which `units` are one of this one's.
  [[nodiscard]] PathSpeed over(double units) const;
  /// So many times as fast.
  [[nodiscard]] PathSpeed times(double factor) const;

 private:
  enum class Kind : std::uint8_t { constant, surface, growing };

  [[nodiscard]] double changing_at(const Curve& curve, double s) const;
  [[nodiscard]] double radius_at(const Curve& curve, double s) const;
  [[nodiscard]] double effective_radius(const Curve& curve, double s) const;
  [[nodiscard]] double seconds_of_line(const Curve& line, double from, double to) const;
  [[nodiscard]] double seconds_of_part(const Curve& curve, double from, double to) const;
  [[nodiscard]] double surface_part(const Curve& curve, double from, double to) const;
  [[nodiscard]] double growing_part(double from, double to) const;
  [[nodiscard]] double growing_at(double s) const;

  Kind kind_ = Kind::constant;
  base::Axis axis_{};
  double value_ = 0;   // the speed; of a surface speed times the radius; of a growing one at s = 0
  double centre_ = 0;  // of the radius; of a growing speed: its rate
  double least_radius_ = 0;
};

/// With the tip along these curves: the constant speed of the spindle, rpm, at which a feed per
/// revolution takes as long. Precondition: spindle.follows_radius(), and there is a way.
[[nodiscard]] double mean_rpm(const Spindle& spindle, std::span<const Curve> curves);

}  // namespace kerf::motion
