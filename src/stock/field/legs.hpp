#pragma once

#include <variant>
#include <vector>

#include "stock/field/ring_leg.hpp"
#include "stock/field/straight_leg.hpp"

namespace kerf::stock::field {

/// A way as parts whose lowest surface is known, in the order in which the tool goes. What is
/// neither straight nor a level arc (helices, spirals, arcs on edge) becomes chords that leave it
/// by no more than an error bound.
using Legs = std::variant<StraightLeg, RingLeg, std::vector<StraightLeg>>;

/// Farther than any machine goes.
inline constexpr double kFarthest_mm = 1e7;
/// More chords than this are refused.
inline constexpr double kMostChords = 262144;

/// Whether a way can become legs: its numbers are within kFarthest_mm, it is straight or an arc,
/// and has not more than kMostChords chords, none of them too long for a leg.
[[nodiscard]] bool can_be_legs(const Way& way, double error_mm);
/// Precondition: can_be_legs().
[[nodiscard]] Legs legs_of(const Way& way, double error_mm, StraightLeg::Begins begins);

/// Calls with each leg.
template <class Do>
void for_each_leg(const Legs& legs, const Do& act) {
  if (const auto* chords = std::get_if<std::vector<StraightLeg>>(&legs)) {
    for (const StraightLeg& leg : *chords) act(leg);
  } else if (const auto* straight = std::get_if<StraightLeg>(&legs)) {
    act(*straight);
  } else {
    act(std::get<RingLeg>(legs));
  }
}

}  // namespace kerf::stock::field
