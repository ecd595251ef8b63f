#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "features/path/recording.hpp"
#include "geometry/contour/contour.hpp"

namespace kerf::features {

inline constexpr double kBeside_mm = 4e-3;  // what words of inches are rounded to, twice

/// The way of a row that has cut a wall.
struct WallRow {
  std::uint32_t number = 0;
  std::vector<contour::Edge> path{};
  double radius = 0;  ///< of its tool
  double length = 0;
};

/// Nothing: the row does not cut, or how wide its tool cuts depends on the height.
[[nodiscard]] std::optional<WallRow> wall_row(const Recording& recording, std::uint32_t row);

/// Beside the row, as far as its tool reaches, and not beyond its ends.
[[nodiscard]] bool is_beside(const WallRow& row, geometry::Vec2 point);
[[nodiscard]] bool is_beside(const WallRow& row, const contour::Edge& edge);

/// What a row leaves beside it goes as it goes: a line, or about the same centre. Its round ends do
/// not.
[[nodiscard]] bool is_side_of(const WallRow& row, const contour::Edge& edge);

}  // namespace kerf::features
