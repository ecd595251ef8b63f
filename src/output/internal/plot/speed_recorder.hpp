#pragma once

#include "control/axis_setup.hpp"
#include "motion/setpoint.hpp"
#include "output/internal/plot/path_store.hpp"
#include "output/internal/plot/tip_in_space.hpp"

namespace kerf::output::plot {

/// Takes set-points and keeps how fast the tool went where it moved at feed: a path with speeds, in
/// mm/min. The speed at a set-point is the mean of those of the periods before and behind it, each
/// the way of the tip in space by its time. Bounded memory, as PathStore has it.
///
/// A beam that is off is known for travelling once it was on.
class SpeedRecorder {
 public:
  /// `x_scale`: lengths along X are the X words times this.
  SpeedRecorder(const control::AxisSetup& axes, double x_scale) : space_(axes, x_scale) {}

  /// The tool stands there; what comes begins there.
  void start(const motion::Setpoint& at);
  /// Precondition: start() was called.
  void take(const motion::Setpoint& point);

  /// What was kept so far; the tool is at rest behind it.
  [[nodiscard]] Path path() const;
  /// 0: every set-point was kept. See PathStore.
  [[nodiscard]] double tolerance() const { return store_.tolerance(); }
  /// Of the periods at feed, mm/min; 0 without any.
  [[nodiscard]] double fastest() const { return fastest_; }

 private:
  // The way to a set-point: complete when the speed behind it is known.
  struct Period {
    Point3 to{};
    double speed = 0;
    bool at_feed = false;
  };

  void close(double speed_behind);
  [[nodiscard]] bool is_at_feed(const motion::Mark& mark) const;

  TipInSpace space_;
  PathStore store_;
  Knot from_{};  // where the last period begins
  Period last_;
  double time_s_ = 0;
  double fastest_ = 0;
  bool beam_was_on_ = false;
};

}  // namespace kerf::output::plot
