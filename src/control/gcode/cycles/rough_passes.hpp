#pragma once

#include <memory>

#include "control/gcode/cycles/turning_frame.hpp"
#include "control/gcode/cycles/turning_passes.hpp"
#include "control/gcode/cycles/turning_shape.hpp"
#include "geometry/vec2.hpp"

namespace kerf::control {

/// Words and parameters of G71 and G72.
struct RoughSettings {
  Travel travel = Travel::along_z;  ///< G71; along_x: G72
  double depth_mm = 1;         ///< between levels, a radius in G71; below 1e-6 it counts as that
  double retreat_mm = 0.5;     ///< e >= 0, a radius in X
  geometry::Vec2 allowance{};  ///< added to the shape as it is: u along Z, v along X as a radius
};

/// The moves of G71 and G72 (docs/dialect/turning.md): from the start to its point with the
/// allowances, C; level after level; once along the shape with the allowances; straight back to the
/// start. A shape of type II is cleared pocket by pocket (PocketPasses), any other by levels that
/// all begin beside C (LevelPasses); G72 knows only these.
///
/// The moves end whatever the shape; that none leads into it holds for shapes without a fault
/// (check_shape), but for the way home.
/// A pass takes O(log n + its moves) of a shape with n pieces.
[[nodiscard]] std::unique_ptr<TurningPasses> rough_passes(TurningShape shape,
                                                          const RoughSettings& settings);

}  // namespace kerf::control
