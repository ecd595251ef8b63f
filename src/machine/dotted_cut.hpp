#pragma once

#include <optional>

#include "base/diagnostic.hpp"
#include "control/motion.hpp"
#include "machine/drive_settings.hpp"

namespace kerf::machine {

/// Finds the first cut of a laser whose pulses would lie farther apart than the spot is wide at the
/// programmed feed: v/f > spot (docs/drives.md, The laser). At full power there are no pulses.
class DottedCut {
 public:
  explicit DottedCut(const LaserSettings& laser) : laser_(laser) {}

  void take(const control::Motion& motion);
  /// DOTTED_CUT at the line of the motion, which is all that its place says.
  [[nodiscard]] const std::optional<base::Diagnostic>& warning() const { return warning_; }

 private:
  void look_at(const control::Motion& motion, const control::Feed& feed);

  LaserSettings laser_;
  double percent_ = 0;
  std::optional<base::Diagnostic> warning_;
};

}  // namespace kerf::machine
