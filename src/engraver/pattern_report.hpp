#pragma once

#include <cstdint>
#include <string>

#include "drive/arm_axis.hpp"
#include "machine/definition/machine_definition.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::engraver {

/// What a pattern has become, and how near the wheel keeps to the program.
struct PatternReport {
  /// Largest deviation of a cut and where it is.
  struct Deviation {
    double mm = 0;
    std::uint32_t line = 0;  ///< source line, 0: there are no cuts
    double x = 0, y = 0;     ///< tip, machine coordinates
  };

  std::uint64_t fast = 0;  ///< records
  std::uint64_t triplets = 0;
  std::uint64_t splits = 0;    ///< steps beyond the limit of a triplet, made by several
  std::uint64_t lifts = 0;     ///< corners that were turned in the air
  std::uint64_t dwells = 0;    ///< of the program, left out: a record says no time
  Deviation bound;             ///< that no cut exceeds
  double bound_pulses_mm = 0;  ///< the part of it that whole pulses cost
  Deviation measured;          ///< after every pulse
  double heading_deg = 0;      ///< largest error of the wheel where a step begins, degrees
  double time_s = 0;           ///< of the pattern
  drive::ArmCounts counters;   ///< at its end
};

/// What a report says, for people: some lines of text, each indented.
[[nodiscard]] std::string pattern_text(const PatternReport& report,
                                       const machine::MachineDefinition& machine);

/// The same as one JSON object: "pattern" of a summary (docs/pattern.md).
[[nodiscard]] std::string pattern_json(const PatternReport& report,
                                       const machine::PatternSettings& settings);

/// How many records of each kind there are, and their bytes; to be gone on with.
[[nodiscard]] output::JsonObject records_json(std::uint64_t fast, std::uint64_t triplets);

/// Axis names and counts.
[[nodiscard]] std::string counters_json(const drive::ArmCounts& counters);

}  // namespace kerf::engraver
