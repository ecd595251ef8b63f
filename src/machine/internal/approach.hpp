#pragma once

#include <optional>
#include <vector>

#include "machine/internal/live_core.hpp"

namespace kerf::machine {

/// What a program restarted in its middle needs before its first move: the functions that were
/// switched up to there, and where the program has the tool.
struct LiveCore::Approach : control::MotionSink {
  void take(const control::Motion& motion) override {
    const auto keep = [&](std::optional<control::Motion>& kept) { kept = motion; };
    if (std::holds_alternative<control::ToolChange>(motion.action)) keep(tool);
    if (std::holds_alternative<control::Spindle>(motion.action)) keep(spindle);
    if (std::holds_alternative<control::Coolant>(motion.action)) keep(coolant);
    if (const base::AxisVector* const target = control::target_of(motion)) to = *target;
  }

  std::optional<control::Motion> tool;
  std::optional<control::Motion> spindle;
  std::optional<control::Motion> coolant;
  base::AxisVector to;
};

}  // namespace kerf::machine
