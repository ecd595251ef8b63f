#include "stock/field/grid.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::stock::field {
namespace {

int cells_over(double length, double cell) {
  return static_cast<int>(std::max(1.0, std::ceil(length / cell - 1e-9)));
}

}  // namespace

Grid grid_of(const Bounds& box, double cell_mm) {
  return {box, cells_over(box.high.x - box.low.x, cell_mm),
          cells_over(box.high.y - box.low.y, cell_mm)};
}

double sweep_error_mm(const Grid& grid) {
  return std::min(0.001, std::min(grid.cell_x(), grid.cell_y()) / 100);
}

}  // namespace kerf::stock::field
