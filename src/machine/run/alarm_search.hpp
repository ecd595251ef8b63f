#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostic.hpp"

namespace kerf::machine {

/// What a run finds that goes on behind its alarms (BatchRun::search_alarms()). Each code
/// counts once a line, in the order of the run. Value type.
class AlarmSearch {
 public:
  // Bounds. They are counted, not timed: the same program has the same findings.
  static constexpr std::size_t kMostFindings = 1000;
  static constexpr std::uint64_t kMostPassed = 100'000;    ///< alarms, those told before included
  static constexpr std::uint64_t kMostSteps = 10'000'000;  ///< behind the first alarm, about

  /// Where a control would have stopped.
  struct Stop {
    std::uint64_t motion = 0;  ///< the last one before it, from 1; 0: none
    double time_s = 0;         ///< when the axes rest behind that
  };

  /// False: this is one too many, nothing more is to be looked for.
  bool add(const base::Diagnostic& alarm);
  void stopped_at(const Stop& stop) { stop_ = stop; }

  [[nodiscard]] const std::vector<base::Diagnostic>& findings() const { return findings_; }
  [[nodiscard]] bool any() const { return !findings_.empty(); }
  /// Nothing: no alarm was met.
  [[nodiscard]] const std::optional<Stop>& stop() const { return stop_; }
  /// Behind the first alarm not everything was looked at.
  [[nodiscard]] bool is_cut_short() const { return is_cut_short_; }
  void cut_short() { is_cut_short_ = true; }

 private:
  std::vector<base::Diagnostic> findings_;
  std::optional<Stop> stop_;
  std::uint64_t passed_ = 0;
  bool is_cut_short_ = false;
};

}  // namespace kerf::machine
