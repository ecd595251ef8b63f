#pragma once

namespace kerf::planner {

/// What the operator makes of the programmed feeds, 0 < value <= 2.
struct Overrides {
  double feed = 1;
  double rapid = 1;
  friend bool operator==(const Overrides&, const Overrides&) = default;
};

}  // namespace kerf::planner
