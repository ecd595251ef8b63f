#pragma once

#include <functional>
#include <vector>

#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "motion/move_curves.hpp"
#include "stock/cutting/sweep_maker.hpp"
#include "stock/sheet/trace.hpp"

namespace kerf::stock::sheet {

/// Tells where the beam goes while it is on: a sink for the motions of a machine with a laser,
/// which say by Power when that is. A move of any kind with power is a cut, and a dwell with power
/// that does not follow the speed burns a place.
class BeamTracer final : public motion::MotionSink {
 public:
  using Take = std::function<void(const Trace&, const motion::Motion&)>;

  /// All must outlive the tracer. No trace is farther than `tolerance_mm` from the way of the beam.
  BeamTracer(const motion::AxisSetup& axes, const WorkFrame& frame, double tolerance_mm, Take take);

  void take(const motion::Motion& motion) override;

  /// Of the ways with power, mm.
  [[nodiscard]] double cut_mm() const { return cut_mm_; }
  /// There was power on a way or in a dwell.
  [[nodiscard]] bool has_cut() const { return has_cut_; }
  /// The head stood tilted where it cut: A or B was not 0.
  [[nodiscard]] bool is_tilted() const { return is_tilted_; }

 private:
  void move(const motion::Motion& motion);
  void rest(const motion::Motion& motion);
  void tell(const motion::Motion& motion);
  [[nodiscard]] bool tilts(const base::TipPoint& tip) const;

  const WorkFrame& frame_;
  double tolerance_mm_;
  Take take_;
  motion::MoveCurves curves_;
  SweepMaker maker_;
  std::vector<base::Axis> tilting_;
  base::TipPoint at_;
  motion::Power power_;
  double cut_mm_ = 0;
  bool has_cut_ = false;
  bool is_tilted_ = false;
  std::vector<Sweep> sweeps_;
  std::vector<Trace> traces_;
};

}  // namespace kerf::stock::sheet
