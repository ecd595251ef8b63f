#pragma once

#include "control/motion.hpp"
#include "drive/arm_axis.hpp"
#include "machine/pattern_replay.hpp"
#include "output/path_plot.hpp"

namespace kerf::output {

/// The motions of a replay for a picture: as PatternReplay has them, but a fast record is
/// the way that the tip really takes, on an arm around a joint.
class ReplayPlot : public control::MotionSink {
 public:
  /// Adds itself to the replay. Both must outlive this.
  ReplayPlot(machine::PatternReplay& replay, PathPlot& into);
  void take(const control::Motion& motion) override;

 private:
  void follow();

  static constexpr int kPieces = 64;  // of a fast record

  const machine::PatternReplay& replay_;
  PathPlot& into_;
  drive::ArmCounts at_;
};

}  // namespace kerf::output
