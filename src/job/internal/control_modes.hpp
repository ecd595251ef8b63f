#pragma once

#include "control/core/control.hpp"
#include "features/path/modes.hpp"
#include "machine/definition/stock_words.hpp"
#include "machine/run/batch_run.hpp"

namespace kerf::control {
class GcodeControl;
}

namespace kerf::job {

/// What the control of a run has in force, for a recording.
class ControlModes final : public features::ModeSource {
 public:
  /// The run must outlive this.
  explicit ControlModes(const machine::BatchRun& run);

  [[nodiscard]] const features::Modes& modes() override;

 private:
  void look_at_zero();

  const machine::BatchRun& run_;
  const control::GcodeControl* gcode_;  // null: of a language without frames
  features::Modes modes_;
  machine::StockZero zero_;  // that modes_ has; automatic: none yet
  std::uint64_t revision_ = 0;
};

}  // namespace kerf::job
