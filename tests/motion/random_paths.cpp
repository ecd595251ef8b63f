// Drives along random paths and holds every set-point against what was promised, by means of its
// own: differences of points for the limits, distances to the programmed lines and circles for the
// path. Where a linkage moves the tip, the joints are found anew from each point.
//
//   kerf_motion_tests [--paths N] [--seed S] [--operator]     one seed a path, S, S + 1, …
//                     [--linkage x-theta-z|head-ac|arm]
//
// With --operator the feed is held, overridden and reset at random instants.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "cell_check.hpp"
#include "kinematics/make.hpp"
#include "machine/run/internal/joint_linkage.hpp"
#include "planner/interpolator.hpp"
#include "programmed_path.hpp"
#include "random_path.hpp"

namespace kerf::test {
namespace {

using base::AxisVector;
using base::JointPoint;
using base::TipPoint;

// Relative excess that is allowed over a limit, and what the differences lose to rounding: a point
// of 100 mm is known to 1.4e-14, its third difference over (1 ms)³ to some 1e-4 mm/s³.
constexpr double kExcess = 1e-6;
constexpr double kPointError_mm = 1e-13;
class Checker {
 public:
  Checker(const RandomPath& path, bool with_operator, unsigned seed)
      : path_(path), programmed_(path), operator_(with_operator), random_(seed) {
    tip_ = path.axes.start;
    joints_.fill(path.machine ? path.machine->joints : base::JointPoint(tip_.numbers()));
    if (path.machine)
      linkage_ = std::make_unique<machine::JointLinkage>(*path.machine->kinematics, joints_[0]);
  }

  /// A sentence about the first broken promise, or nothing.
  std::string run() {
    if (linkage_) problem_ = check_cells(path_, *linkage_);
    planner::Interpolator interpolator(path_.axes, path_.limits, path_.settings, linkage_.get());
    for (const motion::Motion& motion : path_.motions) {
      if (!interpolator.room()) drain(interpolator);
      interpolator.take(motion);
    }
    if (!interpolator.room()) drain(interpolator);
    interpolator.finish();
    drain(interpolator);
    if (was_reset_) go_on(interpolator);
    if (!operator_) slower_ = is_slower_than_with_stops(interpolator.time_s());
    const TipPoint end = was_reset_ ? new_end_ : programmed_.end();
    if (problem_.empty() && !(tip_ == end)) tell("the end is not exact");
    return problem_;
  }
  [[nodiscard]] std::uint64_t wishes() const { return wishes_; }
  [[nodiscard]] std::uint64_t setpoints() const { return rows_; }
  /// To come to rest behind every motion would have been clearly faster. Chains and corners are
  /// smoothed before anything is planned, by estimates, so that happens, but seldom.
  [[nodiscard]] bool slower_than_with_stops() const { return slower_; }

 private:
  [[nodiscard]] bool is_slower_than_with_stops(double time_s) const {
    planner::Interpolator stopping(path_.axes, path_.limits, path_.settings, linkage_.get());
    for (motion::Motion motion : path_.motions) {
      motion.exact_stop = true;
      if (!stopping.room()) stopping.skip();
      stopping.take(motion);
    }
    if (!stopping.room()) stopping.skip();
    stopping.finish();
    stopping.skip();
    return time_s > 1.1 * stopping.time_s() + 4 * path_.settings.period_s;
  }

  void drain(planner::Interpolator& interpolator) {
    motion::Setpoint point;
    while (problem_.empty() && !was_reset_) {
      if (operator_) act(interpolator);
      if (!interpolator.next(point)) break;
      check(point);
      if (interpolator.held()) held(interpolator);
    }
  }

  // At one of some periods the operator holds, turns an override, or resets.
  void act(planner::Interpolator& interpolator) {
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

  void held(planner::Interpolator& interpolator) {
    motion::Setpoint point;
    for (int i = random_.count(1, 5); i > 0 && interpolator.next(point); --i) {
      const TipPoint before = tip_;
      check(point);
      if (!(tip_ == before)) tell("no rest while the feed is held");
    }
    was_reset_ = interpolator.at_reset();
    interpolator.resume();
  }

  // After a reset: a line from where the tool is, through a linkage one that stays in its
  // workspace.
  void go_on(planner::Interpolator& interpolator) {
    new_end_ = tip_;
    new_end_.values[linkage_ ? 2 : 0] += 1;
    motion::Motion motion;
    motion.block.line = 1;
    motion.action = motion::Line{new_end_, {1000, motion::FeedMode::per_minute}};
    interpolator.take(motion);
    interpolator.finish();
    motion::Setpoint point;
    off_path_ = true;
    while (problem_.empty() && interpolator.next(point)) check(point);
  }

  void check(const motion::Setpoint& point) {
    std::copy_backward(joints_.begin(), joints_.end() - 1, joints_.end());
    tip_ = point.tip;
    joints_[0] = base::JointPoint(tip_.numbers());
    if (linkage_) follow(point.tip);
    ++rows_;
    line_ = point.mark.block.line;
    if (std::fabs(point.time_s - static_cast<double>(rows_) * path_.settings.period_s) > 1e-9)
      tell("a period is missing");
    for (std::size_t m = 0; m < path_.axes.count(); ++m) limits_of(m);
    if (off_path_) return;
    const double tolerance = path_.settings.tolerance_mm;
    near_path(point.tip, tolerance * (1 + kExcess) + 1e-9, "off the path");
    if (linkage_ || may_bend(point))
      between(tolerance + (1 + kExcess) * path_.settings.chord_tolerance_mm);
    line_before_ = line_;
  }

  // Between two points of one programmed line nothing does, nor before the first motion.
  [[nodiscard]] bool may_bend(const motion::Setpoint& point) const {
    if (point.mark.block.line == 0) return false;
    const auto& action = path_.motions[point.mark.block.line - 1].action;
    return line_ != line_before_ || !std::holds_alternative<motion::Line>(action);
  }

  void follow(const TipPoint& tip) {
    const auto joints = path_.machine->kinematics->inverse(tip, joints_[1]);
    if (!joints) return tell("no joints hold the tip");
    joints_[0] = *joints;
  }

  // The tip while the joints go in proportion from the last point to this one.
  void between(double most) {
    constexpr int kPlaces = 8;
    for (int i = 1; i < kPlaces; ++i) {
      JointPoint joints = joints_[1];
      for (std::size_t m = 0; m < base::kMaxAxes; ++m)
        joints.values[m] += (joints_[0].values[m] - joints_[1].values[m]) * i / kPlaces;
      const TipPoint tip =
          linkage_ ? path_.machine->kinematics->forward(joints) : TipPoint(joints.numbers());
      near_path(tip, most, "off the path between points");
    }
  }

  void near_path(const TipPoint& tip, double most, const char* what) {
    double off = 0;
    if (!programmed_.is_near(tip, line_, most, off)) tell(what, off, most);
  }

  void limits_of(std::size_t m) {
    const double t = path_.settings.period_s;
    const auto p = [&](std::size_t n) { return joints_[n].values[m]; };
    const auto hold = [&](const char* what, double value, double limit, double errors) {
      if (std::fabs(value) <= limit * (1 + kExcess)) return;
      if (std::fabs(value) > limit * (1 + kExcess) + errors * error_of(m))
        tell(what, value, limit, m);
    };
    hold("velocity", (p(0) - p(1)) / t, path_.limits.velocity.values[m], 2 / t);
    hold("acceleration", (p(0) - 2 * p(1) + p(2)) / (t * t), path_.limits.acceleration.values[m],
         4 / (t * t));
    hold("jerk", (p(0) - 3 * p(1) + 3 * p(2) - p(3)) / (t * t * t), path_.limits.jerk.values[m],
         8 / (t * t * t));
  }

  // What the last digit of a tip makes of a joint.
  [[nodiscard]] double error_of(std::size_t m) const {
    double error = kPointError_mm;
    for (std::size_t axis = 0; linkage_ && axis < 2; ++axis) {
      base::TipJet tip;
      tip.value = tip_;
      tip.first.values[axis] = 1;
      if (const auto jet = linkage_->along(tip, joints_[0]))
        error += kPointError_mm * std::fabs(jet->first.values[m]);
    }
    return error;
  }

  void tell(const char* what, double value = 0, double limit = 0, std::size_t axis = 9) {
    if (!problem_.empty()) return;
    char text[200];
    std::snprintf(text, sizeof text, "%s: %.9g, limit %.9g, axis %zu, motion %u, point %llu", what,
                  value, limit, axis, line_, static_cast<unsigned long long>(rows_));
    problem_ = text;
  }

  const RandomPath& path_;
  ProgrammedPath programmed_;
  std::unique_ptr<planner::Linkage> linkage_;
  TipPoint tip_;
  std::array<JointPoint, 4> joints_{};  // the newest first
  bool operator_;
  SeededRandom random_;
  std::uint64_t wishes_ = 0;
  bool was_reset_ = false;
  bool slower_ = false;
  bool off_path_ = false;
  TipPoint new_end_;
  std::uint64_t rows_ = 0;
  std::uint32_t line_ = 0;
  std::uint32_t line_before_ = 0;
  std::string problem_;
};

}  // namespace
}  // namespace kerf::test

int main(int count, char** words) {
  unsigned long paths = 3000;
  unsigned seed = kerf::test::kSeed;
  bool with_operator = false;
  auto kind = std::optional(kerf::kinematics::Kind::cartesian);
  for (int i = 1; i < count; ++i) {
    with_operator |= std::strcmp(words[i], "--operator") == 0;
    if (i + 1 == count) break;
    if (std::strcmp(words[i], "--paths") == 0) paths = std::strtoul(words[i + 1], nullptr, 10);
    if (std::strcmp(words[i], "--seed") == 0)
      seed = static_cast<unsigned>(std::strtoul(words[i + 1], nullptr, 10));
    if (std::strcmp(words[i], "--linkage") == 0) kind = kerf::kinematics::kind_named(words[i + 1]);
  }
  if (!kind) {
    std::fprintf(stderr, "there is no such linkage\n");
    return 2;
  }
  std::uint64_t setpoints = 0;
  std::uint64_t wishes = 0;
  unsigned long slower = 0;
  int failures = 0;
  for (unsigned long i = 0; i < paths && failures < 20; ++i) {
    const auto path = kerf::test::random_path(seed + static_cast<unsigned>(i), *kind);
    kerf::test::Checker checker(path, with_operator, seed + static_cast<unsigned>(i));
    const std::string problem = checker.run();
    setpoints += checker.setpoints();
    wishes += checker.wishes();
    if (checker.slower_than_with_stops()) ++slower;
    if (problem.empty()) continue;
    std::printf("seed %lu: %s\n", seed + i, problem.c_str());
    ++failures;
  }
  const unsigned long most_slower = 1 + paths / 100;
  if (slower > most_slower) ++failures;
  std::printf(
      "%lu paths from seed %u, %llu set-points, %llu wishes, %lu slower than with stops: %d "
      "failures\n",
      paths, seed, static_cast<unsigned long long>(setpoints),
      static_cast<unsigned long long>(wishes), slower, failures);
  return failures == 0 ? 0 : 1;
}
