#include "stock/field/first_touch.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::stock::field {
namespace {

/// Cells of one axis that have anything between two places.
struct Cells {
  int first;
  int last;
};

Cells cells_between(double low, double high, double begin, double cell, int count) {
  const double first = std::floor((low - begin) / cell - 1e-6);
  const double last = std::floor((high - begin) / cell + 1e-6);
  return {static_cast<int>(std::clamp(first, 0.0, 1.0 * count)),
          static_cast<int>(std::clamp(last, -1.0, count - 1.0))};
}

/// How far `ball` may still go; what is met later is of no interest.
BallWay up_to(const BallWay& ball, double t) { return {part(ball.way, 0, t), ball.radius_mm}; }

}  // namespace

std::optional<double> first_touch(const Columns& columns, const BallWay& ball) {
  const Grid& grid = columns.grid();
  const Bounds way = bounds(ball);
  const Cells across = cells_between(way.low.x, way.high.x, grid.box.low.x, grid.cell_x(), grid.nx);
  const Cells along = cells_between(way.low.y, way.high.y, grid.box.low.y, grid.cell_y(), grid.ny);
  const Vec3 half{grid.cell_x() / 2, grid.cell_y() / 2, 0};
  std::optional<double> first;
  for (int j = along.first; j <= along.last; ++j) {
    for (int i = across.first; i <= across.last; ++i) {
      const double top = grid.box.low.z + double{columns.height(i, j)};
      const double bottom = grid.box.low.z + double{columns.bottom(i, j)};
      if (bottom >= top || top < way.low.z || bottom > way.high.z) continue;
      const Vec3 middle{grid.x(i), grid.y(j), 0};
      const Bounds column{middle - half + Vec3{0, 0, bottom}, middle + half + Vec3{0, 0, top}};
      const double limit = first.value_or(1);
      if (const auto t = first_touch(up_to(ball, limit), column)) first = limit * *t;
    }
  }
  return first;
}

}  // namespace kerf::stock::field
