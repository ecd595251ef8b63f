#include "output/picture/drawing/display_list.hpp"

namespace kerf::output::plot {

void Outline::rectangle(const Rect& rect) {
  move_to({rect.left, rect.top});
  line_to({rect.right(), rect.top});
  line_to({rect.right(), rect.bottom()});
  line_to({rect.left, rect.bottom()});
  close();
}

void Outline::circle(Point center, double radius) {
  const double handle = 0.5522847498 * radius;
  const auto [x, y] = center;
  move_to({x + radius, y});
  curve_to({x + radius, y + handle}, {x + handle, y + radius}, {x, y + radius});
  curve_to({x - handle, y + radius}, {x - radius, y + handle}, {x - radius, y});
  curve_to({x - radius, y - handle}, {x - handle, y - radius}, {x, y - radius});
  curve_to({x + handle, y - radius}, {x + radius, y - handle}, {x + radius, y});
  close();
}

}  // namespace kerf::output::plot
