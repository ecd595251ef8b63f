#pragma once

#include <cstdint>

namespace kerf::planner {

/// How the tool moves along the path at one moment: speed and acceleration, mm (or degrees) and
/// seconds, and the place, an offset from the begin of a cell.
struct PathState {
  std::uint64_t cell = 0;
  double offset = 0;
  double speed = 0;
  double acceleration = 0;
};

}  // namespace kerf::planner
