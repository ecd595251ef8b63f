// Drives along random paths and holds every set-point against what was promised, by means of its
// own: differences of points for the limits, distances to the programmed lines and circles for the
// path.
//
//   kerf_motion_tests [--paths N] [--seed S] [--operator]     one seed a path, S, S + 1, …
//
// With --operator the feed is held, overridden and reset at random instants.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <numbers>

#include "control/plane_axes.hpp"
#include "geometry/arc.hpp"
#include "motion/interpolator.hpp"
#include "random_path.hpp"

namespace kerf::test {
namespace {

using base::AxisVector;
using geometry::Vec2;

// Relative excess that is allowed over a limit, and what the differences lose to rounding: a point
// of 100 mm is known to 1.4e-14, its third difference over (1 ms)³ to some 1e-4 mm/s³.
constexpr double kExcess = 1e-6;
constexpr double kPointError_mm = 1e-13;

double distance_to_segment(const AxisVector& p, const AxisVector& a, const AxisVector& b) {
  double dot = 0;
  double square = 0;
  for (std::size_t m = 0; m < 3; ++m) {
    const double d = b.values[m] - a.values[m];
    dot += (p.values[m] - a.values[m]) * d;
    square += d * d;
  }
  const double t = square > 0 ? std::clamp(dot / square, 0.0, 1.0) : 0;
  double distance = 0;
  for (std::size_t m = 0; m < 3; ++m) {
    const double on = a.values[m] + t * (b.values[m] - a.values[m]);
    distance += (p.values[m] - on) * (p.values[m] - on);
  }
  return std::sqrt(distance);
}

/// A programmed arc as a function of the part of it that is behind, 0 to 1.
class ProgrammedArc {
 public:
  ProgrammedArc(const AxisVector& from, const control::Arc& arc, const control::AxisSetup& axes)
      : from_(from), arc_(arc), plane_(*control::plane_axes(arc.plane, axes)) {
    const bool clockwise = arc.direction == control::Direction::clockwise;
    const Vec2 start = plane_.project(from) - centre();
    sweep_ =
        geometry::sweep_rad(plane_.project(from), plane_.project(arc.to), centre(), clockwise) +
        2 * std::numbers::pi * arc.turns;
    if (clockwise) sweep_ = -sweep_;
    angle_ = std::atan2(start.v, start.u);
    radius_ = length(start);
    end_radius_ = length(plane_.project(arc.to) - centre());
  }

  [[nodiscard]] double distance(const AxisVector& p) const {
    const Vec2 here = plane_.project(p) - centre();
    double least = std::numeric_limits<double>::infinity();
    for (int turn = -2; turn <= 2; ++turn) {
      const double at = std::atan2(here.v, here.u) + turn * 2 * std::numbers::pi;
      least = std::min(least, distance_at(p, std::clamp((at - angle_) / sweep_, 0.0, 1.0)));
    }
    return least;
  }
  /// The same for steep helices, whose nearest point lies at another angle.
  [[nodiscard]] double searched_distance(const AxisVector& p) const {
    constexpr int kPlaces = 2000;
    int best = 0;
    for (int i = 1; i <= kPlaces; ++i) {
      if (distance_at(p, i * 1.0 / kPlaces) < distance_at(p, best * 1.0 / kPlaces)) best = i;
    }
    double low = std::max(0.0, (best - 1.0) / kPlaces);
    double high = std::min(1.0, (best + 1.0) / kPlaces);
    for (int i = 0; i < 60; ++i) {
      const double third = (high - low) / 3;
      const bool nearer_low = distance_at(p, low + third) < distance_at(p, high - third);
      (nearer_low ? high : low) += nearer_low ? -third : third;
    }
    return distance_at(p, low);
  }

 private:
  [[nodiscard]] Vec2 centre() const { return {arc_.center[0], arc_.center[1]}; }
  [[nodiscard]] double distance_at(const AxisVector& p, double part) const {
    const double radius = radius_ + (end_radius_ - radius_) * part;
    const double at = angle_ + part * sweep_;
    const Vec2 on{radius * std::cos(at), radius * std::sin(at)};
    const base::Axis normal = *plane_.normal;
    const double height = from_[normal] + part * (arc_.to[normal] - from_[normal]);
    return std::hypot(length(plane_.project(p) - centre() - on), p[normal] - height);
  }

  AxisVector from_;
  const control::Arc& arc_;
  control::PlaneAxes plane_;
  double sweep_ = 0;
  double angle_ = 0;
  double radius_ = 0;
  double end_radius_ = 0;
};

class Checker {
 public:
  Checker(const RandomPath& path, bool with_operator, unsigned seed)
      : path_(path), operator_(with_operator), random_(seed) {}

  /// A sentence about the first broken promise, or nothing.
  std::string run() {
    motion::Interpolator interpolator(path_.axes, path_.limits, path_.settings);
    for (const control::Motion& motion : path_.motions) {
      if (!interpolator.room()) drain(interpolator);
      interpolator.take(motion);
    }
    if (!interpolator.room()) drain(interpolator);
    interpolator.finish();
    drain(interpolator);
    if (was_reset_) go_on(interpolator);
    const AxisVector end = was_reset_ ? new_end_ : end_of_path();
    if (problem_.empty() && !(points_[0] == end)) tell("the end is not exact");
    return problem_;
  }
  [[nodiscard]] std::uint64_t wishes() const { return wishes_; }
  [[nodiscard]] std::uint64_t setpoints() const { return rows_; }

 private:
  enum class Way : std::uint8_t { quick, searched };

  void drain(motion::Interpolator& interpolator) {
    motion::Setpoint point;
    while (problem_.empty() && !was_reset_) {
      if (operator_) act(interpolator);
      if (!interpolator.next(point)) break;
      check(point);
      if (interpolator.held()) held(interpolator);
    }
  }

  // At one of some periods the operator holds, turns an override, or resets.
  void act(motion::Interpolator& interpolator) {
    if (random_.count(0, 30) != 0) return;
    ++wishes_;
    switch (random_.count(0, 5)) {
      case 0:
      case 1: interpolator.hold(); break;
      case 2: interpolator.resume(); break;
      case 3:
        if (random_.count(0, 9) == 0) interpolator.reset();
        break;
      default: interpolator.set_overrides({random_.size(0.01, 2), random_.size(0.01, 1)});
    }
  }

  void held(motion::Interpolator& interpolator) {
    motion::Setpoint point;
    for (int i = random_.count(1, 5); i > 0 && interpolator.next(point); --i) {
      check(point);
      if (!(points_[0] == points_[1])) tell("no rest while the feed is held");
    }
    was_reset_ = interpolator.at_reset();
    interpolator.resume();
  }

  // After a reset: a line from where the tool is.
  void go_on(motion::Interpolator& interpolator) {
    new_end_ = points_[0];
    new_end_.values[0] += 1;
    control::Motion motion;
    motion.line = 1;
    motion.action = control::Line{new_end_, {1000, control::FeedMode::per_minute}};
    interpolator.take(motion);
    interpolator.finish();
    motion::Setpoint point;
    off_path_ = true;
    while (problem_.empty() && interpolator.next(point)) check(point);
  }

  void check(const motion::Setpoint& point) {
    std::copy_backward(points_.begin(), points_.end() - 1, points_.end());
    points_[0] = point.tip;
    ++rows_;
    line_ = point.mark.line;
    if (std::fabs(point.time_s - static_cast<double>(rows_) * path_.settings.period_s) > 1e-9)
      tell("a period is missing");
    for (std::size_t m = 0; m < path_.axes.count(); ++m) limits_of(m);
    if (off_path_) return;
    const double most = path_.settings.tolerance_mm + 1e-9;
    double off = distance(point.tip, point.mark.line, 1, Way::quick);
    if (off > most) off = distance(point.tip, point.mark.line, 40, Way::quick);
    if (off > most) off = distance(point.tip, point.mark.line, 40, Way::searched);
    if (off > path_.settings.tolerance_mm * (1 + kExcess) + 1e-9)
      tell("off the path", off, path_.settings.tolerance_mm);
  }

  void limits_of(std::size_t m) {
    const double t = path_.settings.period_s;
    const auto p = [&](std::size_t n) { return points_[n].values[m]; };
    const auto hold = [&](const char* what, double value, double limit, double rounding) {
      if (std::fabs(value) > limit * (1 + kExcess) + rounding) tell(what, value, limit, m);
    };
    hold("velocity", (p(0) - p(1)) / t, path_.limits.velocity.values[m], 2 * kPointError_mm / t);
    hold("acceleration", (p(0) - 2 * p(1) + p(2)) / (t * t), path_.limits.acceleration.values[m],
         4 * kPointError_mm / (t * t));
    hold("jerk", (p(0) - 3 * p(1) + 3 * p(2) - p(3)) / (t * t * t), path_.limits.jerk.values[m],
         8 * kPointError_mm / (t * t * t));
  }

  // To the nearest of the motions around the one that the point says it belongs to.
  [[nodiscard]] double distance(const AxisVector& tip, std::uint32_t line, std::size_t around,
                                Way way) const {
    const std::size_t first = line > around ? line - around : 1;
    const std::size_t last = std::min(path_.motions.size(), line + around);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t n = first; n <= last; ++n) {
      const control::Motion& motion = path_.motions[n - 1];
      const auto* const rapid = std::get_if<control::Rapid>(&motion.action);
      if (rapid != nullptr && !rapid->linear) return 0;  // only its end is promised
      const AxisVector* const to = control::target_of(motion);
      if (to == nullptr) continue;
      const AxisVector from = start_of(n - 1);
      const auto* const arc = std::get_if<control::Arc>(&motion.action);
      least = std::min(least, arc != nullptr
                                  ? distance_to(tip, ProgrammedArc(from, *arc, path_.axes), way)
                                  : distance_to_segment(tip, from, *to));
    }
    return std::isfinite(least) ? least : 0;
  }

  [[nodiscard]] static double distance_to(const AxisVector& tip, const ProgrammedArc& arc,
                                          Way way) {
    return way == Way::quick ? arc.distance(tip) : arc.searched_distance(tip);
  }

  [[nodiscard]] AxisVector start_of(std::size_t motion) const {
    while (motion-- > 0) {
      if (const AxisVector* const to = control::target_of(path_.motions[motion])) return *to;
    }
    return {};
  }
  [[nodiscard]] AxisVector end_of_path() const { return start_of(path_.motions.size()); }

  void tell(const char* what, double value = 0, double limit = 0, std::size_t axis = 9) {
    if (!problem_.empty()) return;
    char text[200];
    std::snprintf(text, sizeof text, "%s: %.9g, limit %.9g, axis %zu, motion %u, point %llu", what,
                  value, limit, axis, line_, static_cast<unsigned long long>(rows_));
    problem_ = text;
  }

  const RandomPath& path_;
  std::array<AxisVector, 4> points_{};  // the newest first
  bool operator_;
  SeededRandom random_;
  std::uint64_t wishes_ = 0;
  bool was_reset_ = false;
  bool off_path_ = false;
  AxisVector new_end_;
  std::uint64_t rows_ = 0;
  std::uint32_t line_ = 0;
  std::string problem_;
};

}  // namespace
}  // namespace kerf::test

int main(int count, char** words) {
  unsigned long paths = 3000;
  unsigned seed = kerf::test::kSeed;
  bool with_operator = false;
  for (int i = 1; i < count; ++i) {
    with_operator |= std::strcmp(words[i], "--operator") == 0;
    if (i + 1 == count) break;
    if (std::strcmp(words[i], "--paths") == 0) paths = std::strtoul(words[i + 1], nullptr, 10);
    if (std::strcmp(words[i], "--seed") == 0)
      seed = static_cast<unsigned>(std::strtoul(words[i + 1], nullptr, 10));
  }
  std::uint64_t setpoints = 0;
  std::uint64_t wishes = 0;
  int failures = 0;
  for (unsigned long i = 0; i < paths && failures < 20; ++i) {
    const auto path = kerf::test::random_path(seed + static_cast<unsigned>(i));
    kerf::test::Checker checker(path, with_operator, seed + static_cast<unsigned>(i));
    const std::string problem = checker.run();
    setpoints += checker.setpoints();
    wishes += checker.wishes();
    if (problem.empty()) continue;
    std::printf("seed %lu: %s\n", seed + i, problem.c_str());
    ++failures;
  }
  std::printf("%lu paths from seed %u, %llu set-points, %llu wishes: %d failures\n", paths, seed,
              static_cast<unsigned long long>(setpoints), static_cast<unsigned long long>(wishes),
              failures);
  return failures == 0 ? 0 : 1;
}
