#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "base/result.hpp"
#include "machine/panel/internal/live_run.hpp"
#include "machine/panel/operation.hpp"

namespace kerf::machine {

/// What an operator enters into the memory of a run: variables, inputs and offsets.
class Entries {
 public:
  using Outcome = base::Outcome<void>;

  /// Whatever moves: before a block that the axes have not begun.
  [[nodiscard]] Outcome enter(const SetVariable& key, LiveRun& run);
  /// What was entered counts for the blocks before that, too: the panel shows it, and a reset keeps
  /// it.
  void show(const SetVariable& key, LiveRun& run) const;
  [[nodiscard]] static Outcome enter(const SetInput& key, LiveRun& run);
  [[nodiscard]] static Outcome enter(const SetOffset& key, LiveRun& run);
  [[nodiscard]] static Outcome enter(const MeasureOffset& key, LiveRun& run);

 private:
  std::map<std::string, std::uint64_t> entered_;  // the first motion that knows of the entry
};

/// The innermost of so many levels of calls, from 0.
[[nodiscard]] inline std::size_t innermost(std::size_t levels) {
  return levels == 0 ? 0 : levels - 1;
}

}  // namespace kerf::machine
