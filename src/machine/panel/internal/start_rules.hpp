#pragma once

#include <optional>

#include "base/refusal.hpp"
#include "machine/panel/internal/live_run.hpp"

namespace kerf::machine {

/// How a machine stands when somebody wants to set it off.
struct Standing {
  const LiveRun& run;
  Mode mode = Mode::automatic;
  bool has_alarm = false;
  bool has_program = false;
};

/// Whether cycle start begins the program, on a machine made anew.
[[nodiscard]] bool would_begin(const Standing& at);

// Why a key does nothing now; nothing: it does.

/// Cycle start, wherever the axes are.
[[nodiscard]] std::optional<base::Failure> keeps_from_start(const Standing& at);
/// A step, or run to line.
[[nodiscard]] std::optional<base::Failure> keeps_from_step(const Standing& at);
/// Start at a line.
[[nodiscard]] std::optional<base::Failure> keeps_from_start_at(const Standing& at);
/// An entry in MDI.
[[nodiscard]] std::optional<base::Failure> keeps_from_entry(const Standing& at);

}  // namespace kerf::machine
