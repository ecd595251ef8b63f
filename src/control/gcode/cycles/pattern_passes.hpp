#pragma once

#include <cstddef>
#include <cstdint>

#include "control/gcode/cycles/turning_passes.hpp"
#include "control/gcode/cycles/turning_shape.hpp"
#include "geometry/vec2.hpp"

namespace kerf::control {

/// Words and parameters of G73. u along Z, v along X as a radius, mm, with their signs.
struct PatternSettings {
  geometry::Vec2 shift{};      ///< of the first pass beyond the last: Δk, Δi
  std::uint32_t passes = 1;    ///< d; 0 counts as 1
  geometry::Vec2 allowance{};  ///< of the last pass
};

/// The moves of G73 (docs/dialect/turning.md): the whole shape, `passes` times, the distance to the
/// last time shrinking evenly; each time from the start moved as far, as ns goes. Then back to the
/// start. One pass has no shift. The last pass consists of moves of the shape's blocks.
class PatternPasses final : public TurningPasses {
 public:
  PatternPasses(TurningShape shape, const PatternSettings& settings);

 private:
  bool advance() override;
  void begin_pass();
  [[nodiscard]] geometry::Vec2 shift() const;
  [[nodiscard]] std::uint32_t block(std::uint32_t of_shape) const;

  TurningShape shape_;
  PatternSettings settings_;
  std::uint32_t left_;  // passes behind this one
  bool begun_ = false;  // this pass
  bool over_ = false;
  std::size_t followed_ = 0;  // pieces in this pass
};

}  // namespace kerf::control
