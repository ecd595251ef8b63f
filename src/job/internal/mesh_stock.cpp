#include "job/internal/mesh_stock.hpp"

#include <cmath>
#include <vector>

#include "stock/dexel/tile.hpp"

namespace kerf::job {
namespace {

using stock::field::Column;
using stock::field::Grid;

// A column that has less than this of a gap has none.
constexpr double kLeast_mm = stock::dexel::Tile::kLeast_mm;
constexpr double kBytesOfCrossing = 12;

std::shared_ptr<const mesh::Lines> lines_of(const stock::MeshShape& shape, const Grid& grid) {
  mesh::LineGrid lines{2, {}, {}};
  for (int i = 0; i < grid.nx; ++i) lines.b.push_back(grid.x(i));
  for (int j = 0; j < grid.ny; ++j) lines.c.push_back(grid.y(j));
  return std::make_shared<const mesh::Lines>(shape.solid->mesh, lines);
}

/// Number of the cell whose middle this is.
std::size_t cell_at(double place, double low, double cell) {
  return static_cast<std::size_t>(std::floor((place - low) / cell));
}

}  // namespace

MeshColumns::MeshColumns(const stock::MeshShape& shape, const Grid& grid)
    : lines_(lines_of(shape, grid)), grid_(grid) {}

bool MeshColumns::is_height_field() const {
  std::vector<mesh::Stretch> found;
  for (std::size_t j = 0; j < static_cast<std::size_t>(grid_.ny); ++j) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(grid_.nx); ++i) {
      found.clear();
      lines_->inside(i, j, kLeast_mm, found);
      if (found.size() > 1) return false;
    }
  }
  return true;
}

stock::field::ColumnAt MeshColumns::columns() const {
  return [lines = lines_, grid = grid_](double x, double y) -> Column {
    std::vector<mesh::Stretch> found;
    lines->inside(cell_at(x, grid.box.low.x, grid.cell_x()),
                  cell_at(y, grid.box.low.y, grid.cell_y()), kLeast_mm, found);
    return found.empty() ? Column{} : Column{found.front().low, found.back().high};
  };
}

double bytes_of_lines(const stock::MeshShape& shape, int axis, double cell_mm) {
  const stock::Vec3 size = shape.box.high - shape.box.low;
  const double across = axis == 0 ? size.y * size.z : axis == 1 ? size.z * size.x : size.x * size.y;
  const double seen = axis == 0   ? shape.seen_mm2.x
                      : axis == 1 ? shape.seen_mm2.y
                                  : shape.seen_mm2.z;
  return (kBytesOfCrossing * seen + sizeof(std::uint32_t) * across) / (cell_mm * cell_mm);
}

}  // namespace kerf::job
