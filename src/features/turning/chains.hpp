#pragma once

#include <vector>

#include "features/path/operation.hpp"
#include "features/path/recording.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::features {

/// Rows at feed between two rapids.
struct Chain {
  enum class Kind : std::uint8_t {
    along,   ///< moves along Z somewhere: turning, boring
    across,  ///< along X alone: facing, also behind an infeed, or a pass from the face
    groove,  ///< by a tool with a width
    thread,  ///< in step with the spindle
    axial,   ///< on the axis of the spindle
    other    ///< beside the plane, by a turned spindle, a probe
  };
  Kind kind = Kind::other;
  Span rows{};
  Span visit{};  ///< with the rapids that lead there, and the retract
};

/// The chains of an operation in their order.
[[nodiscard]] std::vector<Chain> chains_of(const Recording& recording, const Operation& operation,
                                           const stock::Tool& tool);

/// The edges of the rows in (z, radius). What is cut beyond the axis alone lies on this side of it.
[[nodiscard]] std::vector<contour::Edge> edges_of(const Recording& recording, Span rows);

}  // namespace kerf::features
