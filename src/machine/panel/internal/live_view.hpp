#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "machine/panel/internal/console.hpp"
#include "machine/panel/internal/live_run.hpp"
#include "machine/panel/snapshot.hpp"

namespace kerf::machine {

/// What a machine says of itself.
[[nodiscard]] Status status_of(const LiveRun& run, const Console& console);

/// What is to be seen of a live machine.
class LiveView {
 public:
  /// What it is seen in.
  struct Seen {
    LiveRun& run;
    const PanelSettings& panel;
    const Console& console;
    const Stepper& stepper;
    bool has_program = false;
  };
  [[nodiscard]] Snapshot snapshot(const Seen& seen) const;

  [[nodiscard]] VariableListing variables(LiveRun& run, std::optional<std::size_t> level) const;
  [[nodiscard]] VariableListing variables_named(LiveRun& run, const std::vector<std::string>& names,
                                                std::optional<std::size_t> level) const;

  /// A variable counts as changed when it has another value than at the stop before the last one.
  void note_start(LiveRun& run);
  void note_stop(LiveRun& run);

  /// Variables may have other values though no block has run.
  void note_change() { ++changes_; }
  /// Likewise, in the place of another view.
  void note_change(const LiveView& other) { changes_ = other.changes_ + 1; }

 private:
  using Values = std::map<std::pair<std::string, std::size_t>, double>;

  [[nodiscard]] static Values values(LiveRun& run);
  [[nodiscard]] std::uint64_t variables_revision(LiveRun& run) const;
  [[nodiscard]] VariableListing list(LiveRun& run, std::optional<std::size_t> level) const;
  [[nodiscard]] VariableListing list_named(LiveRun& run, const std::vector<std::string>& names,
                                           std::optional<std::size_t> level) const;

  std::uint64_t changes_ = 0;
  Values before_;  // at the last stop but one
  Values at_stop_;
};

}  // namespace kerf::machine
