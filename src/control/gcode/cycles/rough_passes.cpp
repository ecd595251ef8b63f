#include "control/gcode/cycles/rough_passes.hpp"

#include <utility>

#include "control/gcode/cycles/level_passes.hpp"
#include "control/gcode/cycles/pocket_passes.hpp"
#include "control/gcode/cycles/shape_check.hpp"

namespace kerf::control {

std::unique_ptr<TurningPasses> rough_passes(TurningShape shape, const RoughSettings& settings) {
  if (may_have_pockets(shape, settings.travel))
    return std::make_unique<PocketPasses>(std::move(shape), settings);
  return std::make_unique<LevelPasses>(std::move(shape), settings);
}

}  // namespace kerf::control
