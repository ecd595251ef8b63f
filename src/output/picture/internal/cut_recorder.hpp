#pragma once

#include <memory>

#include "motion/axis_setup.hpp"
#include "motion/setpoint.hpp"
#include "output/picture/internal/cut_measure.hpp"
#include "output/picture/internal/path_store.hpp"
#include "output/picture/tip_in_space.hpp"

namespace kerf::output::plot {

/// Takes set-points and keeps a value along the cuts: a path with what its measure says of each
/// period, the way of the tip in space by its time. Bounded memory, as PathStore has it.
class CutRecorder {
 public:
  CutRecorder(const motion::AxisSetup& axes, std::unique_ptr<CutMeasure> measure)
      : space_(axes), measure_(std::move(measure)) {}

  /// The tool stands there; what comes begins there.
  void start(const motion::Setpoint& at);
  /// With the power of a laser in the period that ends there. Precondition: start() was called.
  void take(const motion::Setpoint& point, float power_percent);

  /// What was kept so far; the tool is at rest behind it.
  [[nodiscard]] Path path() const;
  /// 0: every set-point was kept. See PathStore.
  [[nodiscard]] double tolerance() const { return store_.tolerance(); }
  [[nodiscard]] const CutMeasure& measure() const { return *measure_; }

 private:
  // The way to a set-point: complete when the value behind it is known.
  struct Period {
    Point3 to{};
    double value = 0;
    bool drawn = false;
  };

  void close(double value_behind);
  [[nodiscard]] Knot last_knot(double value_behind) const;

  TipInSpace space_;
  std::unique_ptr<CutMeasure> measure_;
  PathStore store_;
  Knot from_{};  // where the last period begins
  Period last_;
  double time_s_ = 0;
};

}  // namespace kerf::output::plot
