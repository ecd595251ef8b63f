#pragma once

#include <cstdint>

#include "drive/pattern/codec.hpp"

namespace kerf::machine {

/// How a program becomes the pattern of an engraving arm, and a pattern its pulses
/// (docs/pattern.md).
struct PatternSettings {
  /// Where the wheel points along a cut.
  enum class Heading : std::uint8_t { tangent, program };

  /// Motors that move together: those of the arms, or in records of a listing all four.
  enum class Link : std::uint8_t { two, four };

  drive::ByteOrder byte_order = drive::ByteOrder::big;
  double tolerance_mm = 0.02;    ///< of a cut, > 0
  double travel_z_mm = 2;        ///< machine coordinates: the wheel is clear of the work
  double tangent_jump_deg = 15;  ///< from here on a corner is turned in the air, 0 to 90
  Heading heading = Heading::tangent;
  Link link = Link::two;
  double cut_speed_mm_min = 0;  ///< of the tip in a replay; 0: the drive's half period
};

}  // namespace kerf::machine
