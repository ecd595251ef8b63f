#include "features/rewrite/tool_fit.hpp"

#include <algorithm>
#include <optional>

#include "base/decimal.hpp"
#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using contour::Contour;

// Of the arcs that the tool would have to go round on their inside the smallest, if it cannot.
std::optional<double> smallest_corner(const Clearing& clearing) {
  std::optional<double> least;
  for (const Contour& wall : clearing.region.loops) {
    for (std::size_t i = 0; i < contour::edge_count(wall); ++i) {
      const contour::Edge edge = contour::edge_of(wall, i);
      if (edge.bulge == 0 || (edge.bulge > 0) == clearing.is_outside) continue;
      const double radius = contour::radius(edge);
      if (radius < clearing.tool_radius - 3 * kSamePoint_mm)
        least = std::min(least.value_or(radius), radius);
    }
  }
  return least;
}

tl::expected<void, CannotCut> check_arcs(const Clearing& clearing) {
  const auto radius = smallest_corner(clearing);
  if (!radius) return {};
  return tl::unexpected(
      CannotCut{base::Code::edit_tool_too_big,
                "CORNER RADIUS " + base::rounded_text(*radius, 3) + " IS SMALLER THAN THE TOOL'S " +
                    base::rounded_text(clearing.tool_radius, 3) + ": LEAVE IT SHARP"});
}

}  // namespace

tl::expected<void, CannotCut> check_corners(const Clearing& clearing) {
  if (clearing.is_outside) return {};
  return check_arcs(clearing);
}

tl::expected<void, CannotCut> check_hollows(const Clearing& clearing) {
  if (!clearing.is_outside) return {};
  return check_arcs(clearing);
}

double radius_of_tool(const Recording& recording, const NewLayer& wanted, Span visit) {
  const std::uint32_t tool = recording.state_of(recording.moves[visit.first + 1]).tool;
  const bool is_alone = wanted.feature->cuts.front().role == Cut::Role::only;
  return recording.diameter_of(is_alone ? wanted.feature->tool : tool) / 2;
}

tl::unexpected<CannotCut> unknown_tool() {
  return tl::unexpected(
      CannotCut{base::Code::edit_tool_unknown, "NOBODY SAYS HOW WIDE THE TOOL IS"});
}

}  // namespace kerf::features
