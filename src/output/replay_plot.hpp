#pragma once

#include "control/motion.hpp"
#include "drive/pulse_sink.hpp"
#include "machine/pattern_replay.hpp"

namespace kerf::output {

/// The motions of a replay for a picture: as PatternReplay has them, but a fast record is
/// the way that the tip really takes, on an arm around a joint, in short rapids.
class ReplayPlot : public control::MotionSink {
 public:
  /// Adds itself to the replay. Both must outlive this.
  ReplayPlot(machine::PatternReplay& replay, control::MotionSink& into);
  void take(const control::Motion& motion) override;

 private:
  void follow(const control::Motion& motion);

  static constexpr int kPieces = 64;  // of a fast record

  const machine::PatternReplay& replay_;
  control::MotionSink& into_;
  drive::ArmCounts at_;
};

}  // namespace kerf::output
