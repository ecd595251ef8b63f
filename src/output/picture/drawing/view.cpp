#include "output/picture/drawing/view.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::output::plot {

Point seen_size(const Projection& projection, const Box3& box) {
  Point size;
  for (std::size_t i = 0; i < 3; ++i) {
    size.x += std::abs(projection.right[i]) * box.size()[i];
    size.y += std::abs(projection.up[i]) * box.size()[i];
  }
  return size;
}

View::View(const Projection& projection, const Box3& box, const Rect& frame, const Rect& inside)
    : projection_(projection), frame_(frame), at_(inside.center()) {
  for (std::size_t i = 0; i < 3; ++i) middle_[i] = box.low()[i] + box.size()[i] / 2;
  const Point size = seen_size(projection, box);
  constexpr double kNothing = 1e-12;
  scale_ = std::min(inside.width / std::max(size.x, kNothing),
                    inside.height / std::max(size.y, kNothing));
}

// Liang and Barsky: each side of the rectangle shortens the part of the segment that may be seen.
std::optional<std::pair<Point, Point>> clipped(Point from, Point to, const Rect& rect) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  double begin = 0, end = 1;
  const auto keep = [&](double speed, double room) {  // the part where speed * t <= room
    if (speed == 0) return room >= 0;
    const double t = room / speed;
    if (speed > 0) {
      end = std::min(end, t);
    } else {
      begin = std::max(begin, t);
    }
    return begin <= end;
  };
  const bool seen = keep(-dx, from.x - rect.left) && keep(dx, rect.right() - from.x) &&
                    keep(-dy, from.y - rect.top) && keep(dy, rect.bottom() - from.y);
  if (!seen) return std::nullopt;
  const auto at = [&](double t) { return Point{from.x + dx * t, from.y + dy * t}; };
  return std::pair(begin == 0 ? from : at(begin), end == 1 ? to : at(end));
}

}  // namespace kerf::output::plot
