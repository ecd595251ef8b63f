#pragma once

#include <array>
#include <cstddef>

#include "stock/compare/part.hpp"

namespace kerf::stock::compare {

/// The lines of a grid over a box, along all three axes, for a part that has no grid of its own.
class LineRows {
 public:
  static constexpr double kFinest_mm = 0.1;

  LineRows() = default;
  /// Cells of kFinest_mm, or as much larger as it takes to have no more than kMostLines.
  explicit LineRows(const Bounds& box);

  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] double cell_mm() const { return cell_mm_; }
  /// Appends what of the part is on the lines of a row, with points where it ends. Those on lines
  /// along the axes that `have_area` stand for that of a cell, others for none.
  void add(std::size_t number, const Solid& part, std::array<bool, 3> have_area,
           Part::Row& row) const;

 private:
  static constexpr double kMostLines = 5e5;

  Bounds box_;
  std::array<std::size_t, 3> cells_{};  // along each axis
  double cell_mm_ = kFinest_mm;
};

}  // namespace kerf::stock::compare
