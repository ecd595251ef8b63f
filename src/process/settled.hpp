#pragma once

#include <string>

#include "process/keys.hpp"
#include "process/machine_facts.hpp"
#include "process/recipe.hpp"

namespace kerf::process {

/// What an operation comes to on a machine: each value said, or that of its process
/// (materials.hpp has filled in before what a material says).
struct Settled {
  double power_percent = 50;
  double feed = 0;          ///< mm/min
  double frequency_hz = 0;  ///< 0: the machine's
  Beam beam = Beam::follow;
  double overcut = 0;
  double kerf = 0;
  double spacing = 0.1;  ///< of hatch lines or tracks, mm
  double burn_s = 0;     ///< of a drilled hole
  bool feed_is_assumed = false;
  bool power_is_assumed = false;

  friend bool operator==(const Settled&, const Settled&) = default;
};

/// "engrave"
[[nodiscard]] inline std::string word_of(Process process) { return names_of(only(process)); }

[[nodiscard]] Settled settle(const Operation& operation, const MachineFacts& machine);

/// How far an axis group runs before it has the feed: v² / (2a) + 0.1 mm, of the axes that move
/// along `direction` (of length 1).
[[nodiscard]] double run_up_mm(const MachineFacts& machine, double feed, Vec2 direction);

}  // namespace kerf::process
