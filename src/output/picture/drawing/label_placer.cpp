#include "output/picture/drawing/label_placer.hpp"

#include <algorithm>
#include <array>

namespace kerf::output::plot {
namespace {

bool overlap(const Rect& a, const Rect& b) {
  return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

// Directions from the point to the label's middle, the best first.
constexpr std::array<Point, 8> kDirections{
    {{1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}}};

}  // namespace

std::optional<Rect> LabelPlacer::place(Point point, double width, double height, double gap) {
  for (const double distance : {gap, 3 * gap, 6 * gap}) {
    for (const Point direction : kDirections) {
      const Rect rect{point.x + direction.x * (width / 2 + distance) - width / 2,
                      point.y + direction.y * (height / 2 + distance) - height / 2, width, height};
      if (claim(rect)) return rect;
    }
  }
  return std::nullopt;
}

bool LabelPlacer::claim(const Rect& rect) {
  if (!is_free(rect)) return false;
  reserve(rect);
  return true;
}

bool LabelPlacer::is_free(const Rect& rect) const {
  const bool inside = rect.left >= area_.left && rect.right() <= area_.right() &&
                      rect.top >= area_.top && rect.bottom() <= area_.bottom();
  return inside && std::ranges::none_of(taken_, [&](const Rect& t) { return overlap(rect, t); });
}

}  // namespace kerf::output::plot
