#pragma once

#include <optional>

#include "base/diagnostic.hpp"
#include "machine/definition/drive_settings.hpp"
#include "motion/motion.hpp"

namespace kerf::machine {

/// Finds the first cut of a laser whose pulses would lie farther apart than the spot is wide at the
/// programmed feed: v/f > spot (docs/drives.md, The laser). At full power there are no pulses.
class DottedCut {
 public:
  explicit DottedCut(const LaserSettings& laser) : laser_(laser) {}

  void take(const motion::Motion& motion);
  /// DOTTED_CUT at the line of the motion, which is all that its place says.
  [[nodiscard]] const std::optional<base::Diagnostic>& warning() const { return warning_; }

 private:
  void look_at(const motion::Motion& motion, const motion::Feed& feed);

  LaserSettings laser_;
  double percent_ = 0;
  double frequency_hz_ = 0;  // once there was power
  std::optional<base::Diagnostic> warning_;
};

}  // namespace kerf::machine
