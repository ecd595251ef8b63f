#pragma once

#include <optional>
#include <vector>

#include "machine/panel/internal/live_core.hpp"

namespace kerf::machine {

/// What a program restarted in its middle needs before its first move: the functions that were
/// switched up to there, and where the program has the tool.
struct LiveCore::Approach : motion::MotionSink {
  void take(const motion::Motion& motion) override {
    const auto keep = [&](std::optional<motion::Motion>& kept) { kept = motion; };
    if (std::holds_alternative<motion::ToolChange>(motion.action)) keep(tool);
    if (std::holds_alternative<motion::Spindle>(motion.action)) keep(spindle);
    if (std::holds_alternative<motion::Coolant>(motion.action)) keep(coolant);
    if (const base::TipPoint* const target = motion::target_of(motion)) to = *target;
  }

  std::optional<motion::Motion> tool;
  std::optional<motion::Motion> spindle;
  std::optional<motion::Motion> coolant;
  base::TipPoint to;
};

}  // namespace kerf::machine
