#pragma once

#include <functional>
#include <vector>

#include "stock/sweep/way.hpp"

namespace kerf::stock {

/// Where a tool is in the frame of the stock.
struct ToolPose {
  Vec3 tip;
  Vec3 axis;  ///< unit, from the tip up
};

/// A turning way with the axis that it begins with.
struct TurningStep {
  Vec3 axis;
  TurningWay way;
};

/// Divides a way whose axis turns, so that between neighbouring steps every point of the tool up to
/// `lever_mm` from its tip goes straight within `tolerance_mm`, and no step turns by more than
/// sqrt(8 tolerance / lever) (stock.md §4.4). pose(t), t in [0, 1], is exact; so are the ends of
/// the steps. Ways are divided in halves, at least into 4 and at most into 2^16 steps.
/// Precondition: lever_mm >= 0, tolerance_mm > 0.
[[nodiscard]] std::vector<TurningStep> turning_steps(const std::function<ToolPose(double t)>& pose,
                                                     double lever_mm, double tolerance_mm);

}  // namespace kerf::stock
