#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "features/milling/stroke.hpp"
#include "features/milling/tool_reach.hpp"
#include "features/path/allowance.hpp"
#include "geometry/contour/region.hpp"

namespace kerf::features {

using contour::Region;

/// Runs of one operation at one z whose sweeps are connected.
struct Level {
  std::size_t operation = 0;
  std::uint32_t tool = 0;
  std::size_t setup = 0;
  double z = 0;
  double radius = 0;             ///< that the tool sweeps with at the top of its cut
  std::vector<LevelRun> runs{};  ///< in their order
  Region sweep{};                ///< of all runs
  std::uint32_t first_row = 0;

  /// All rows of the runs that go across, in their order.
  [[nodiscard]] std::vector<std::uint32_t> rows(const Recording& recording) const;
};

/// The path of a run, open.
[[nodiscard]] contour::Contour path_of(const Recording& recording, const LevelRun& run);

/// The levels that the runs of an operation are, in the order in which they begin. `top`: of the
/// material, which says how wide a cone cuts. Nothing: the allowance is over.
[[nodiscard]] std::optional<std::vector<Level>> levels_of(
    const Recording& recording, std::size_t operation, const Operation& rows,
    const ToolReach& reach, const std::vector<LevelRun>& runs, double top, Allowance& allowance);

}  // namespace kerf::features
