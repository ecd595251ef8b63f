#include "control/gcode/cycles/turning_passes.hpp"

namespace kerf::control {

bool TurningPasses::next(TurningMove& move) {
  while (taken_ == ahead_.size()) {
    ahead_.clear();
    taken_ = 0;
    if (!advance()) return false;
  }
  move = ahead_[taken_++];
  return true;
}

}  // namespace kerf::control
