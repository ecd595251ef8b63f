#pragma once

#include <cstdint>

#include "stock/sweep/way.hpp"

namespace kerf::stock {

/// A tool that one or several moves have as theirs: its number in the model that they go to.
using BodyId = std::uint32_t;

/// What a move may do to material.
enum class SweepKind : std::uint8_t {
  cut,    ///< its edges cut, nothing else may meet material
  rapid,  ///< nothing may meet material
};

/// A tool moves over the stock. Plain value; one motion of the program is one sweep or several in
/// a row.
struct Sweep {
  Way way{};
  Vec3 axis{0, 0, 1};  ///< unit: from the tip up along the tool; of a TurningWay at its beginning
  BodyId body = 0;
  SweepKind kind = SweepKind::cut;
  /// Number of the motion in the run, from 1: what a cut face remembers.
  std::uint32_t motion = 0;
  /// The work turns about Z while the tool goes: what it goes over is a body of revolution. Only on
  /// stock of a lathe, and in the plane of Z and X.
  bool is_turned = false;
  /// Of a cut that is synchronised with the work's spindle: mm a turn, and the spindle's angle at
  /// its mark. 0: it is none. Only stock of a lathe keeps threads.
  double lead_mm = 0;
  double start_deg = 0;
};

}  // namespace kerf::stock
