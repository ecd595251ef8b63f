#pragma once

#include <cstdint>

#include "control/gcode/cycles/roughing.hpp"
#include "control/gcode/cycles/turning_profile.hpp"

namespace kerf::control {

/// Roughing of a shape of type I: every level is cut from beside C to where the shape, followed
/// from its beginning, first passes above it; levels that it never passes end below its last point.
/// The last level is that of P0, however little is left for it.
///
///     C  R------------------\ .
///     |  |  cut              \ 45 degrees, e
///     |--+--------------------+====/  the shape
class LevelPasses final : public Roughing {
 public:
  LevelPasses(TurningShape shape, const RoughSettings& settings);

 private:
  bool cut() override;
  [[nodiscard]] double end_of(double level) const;

  TurningProfile profile_;
  std::uint64_t levels_;
  std::uint64_t made_ = 0;
};

}  // namespace kerf::control
