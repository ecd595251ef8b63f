#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "features/path/recording.hpp"

namespace kerf::features {

/// What one tool did in a hole.
struct HoleStep {
  enum class How : std::uint8_t { spot, drill, ream, bore, tap, mill, helix, countersink };
  How how = How::drill;
  std::uint32_t tool = 0;
  std::size_t operation = 0;
  double diameter = 0;  ///< of a cone at its top
  double top = 0;
  double bottom = 0;
  std::uint16_t cycle = 0;               ///< 81; 0: none
  std::optional<double> peck{};          ///< mm a peck
  std::optional<double> thread_pitch{};  ///< of a thread that it cuts
  std::vector<Span> rows{};              ///< at feed
  std::vector<Span> visits{};
};

/// Adds a step to those of one hole; it goes on with the one before where it is the same tool's in
/// the same operation: a peck.
void add_step(std::vector<HoleStep>& steps, HoleStep step);

/// What a tool does in a hole under a canned cycle, 0: none.
[[nodiscard]] HoleStep::How drilling_of(const stock::Tool& tool, std::uint16_t cycle);
/// The lead of a tap, mm: what it says of itself, else how far it is fed in a turn.
[[nodiscard]] double tap_pitch(const stock::Tool& tool, const State& state);

}  // namespace kerf::features
