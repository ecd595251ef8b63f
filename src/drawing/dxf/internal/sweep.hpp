#pragma once

namespace kerf::drawing::dxf {

/// What differs by no more is at the same height, in the drawing's unit.
inline constexpr double kSameHeight = 1e-9;

/// Which part of an ellipse is drawn.
struct Sweep {
  double from_rad = 0;  ///< within a turn of 0
  double by_rad = 0;    ///< above 0, at most a turn
  [[nodiscard]] bool is_whole() const;
};

/// Counterclockwise from one angle to another. As in DXF, all of it when they are the same; within
/// 1e-6 a whole turn is one.
[[nodiscard]] Sweep sweep_of(double from_rad, double to_rad);
[[nodiscard]] Sweep sweep_of_degrees(double from_deg, double to_deg);

}  // namespace kerf::drawing::dxf
