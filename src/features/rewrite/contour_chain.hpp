#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "features/path/recording.hpp"

namespace kerf::features {

/// Whether two edges lie on one line or circle, run in one sense, and have a part of that in
/// common.
[[nodiscard]] bool lie_along(const contour::Edge& a, const contour::Edge& b);

/// Rows that go along a contour one behind the other, as they are programmed: they may begin before
/// an element and end behind one, on its line.
struct ContourChain {
  Span rows{};
  contour::Contour contour{};  ///< in the sense of the rows
  bool is_reversed = false;    ///< it was told in the other one
  std::size_t first = 0;       ///< element that they begin along
  std::size_t steps = 0;       ///< from it to the last one
  contour::Vec2 begin{};
  contour::Vec2 end{};
  double height = 0;  ///< of a mill, all along

  [[nodiscard]] std::size_t last() const { return (first + steps) % contour::edge_count(contour); }
};

/// The rows among some that go along a contour. Nothing: they leave it on their way, miss an
/// element of it, change their height, or there are none.
[[nodiscard]] std::optional<ContourChain> chain_along(const Recording& recording, Span rows,
                                                      const contour::Contour& contour);

}  // namespace kerf::features
