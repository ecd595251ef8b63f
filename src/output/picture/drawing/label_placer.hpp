#pragma once

#include <optional>
#include <vector>

#include "output/picture/drawing/display_list.hpp"

namespace kerf::output::plot {

/// Finds room for small labels beside the points they name, so that none covers another.
class LabelPlacer {
 public:
  explicit LabelPlacer(const Rect& area) : area_(area) {}

  /// Keeps labels away from here.
  void reserve(const Rect& rect) { taken_.push_back(rect); }

  /// Reserves a rectangle in the area; false when something is there already.
  [[nodiscard]] bool claim(const Rect& rect);

  /// Room of the given size near `point`, at least `gap` away from it; reserved from now on.
  /// Nothing when all places nearby are taken.
  [[nodiscard]] std::optional<Rect> place(Point point, double width, double height, double gap);

 private:
  [[nodiscard]] bool is_free(const Rect& rect) const;

  Rect area_;
  std::vector<Rect> taken_;
};

}  // namespace kerf::output::plot
