#pragma once

#include "drive/arm_axis.hpp"
#include "engraver/pattern_replay.hpp"
#include "motion/motion.hpp"
#include "output/picture/path_plot.hpp"

namespace kerf::engraver {

/// The motions of a replay for a picture: as PatternReplay has them, but a fast record is
/// the way that the tip really takes, on an arm around a joint.
class ReplayPlot : public motion::MotionSink {
 public:
  /// Adds itself to the replay. Both must outlive this.
  ReplayPlot(PatternReplay& replay, output::PathPlot& into);
  void take(const motion::Motion& motion) override;

 private:
  void follow();

  static constexpr int kPieces = 64;  // of a fast record

  const PatternReplay& replay_;
  output::PathPlot& into_;
  drive::ArmCounts at_;
};

}  // namespace kerf::engraver
