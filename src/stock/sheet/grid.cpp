#include "stock/sheet/grid.hpp"

namespace kerf::stock::sheet {
namespace {

int cells_over(double length, double cell) {
  return static_cast<int>(std::max(1.0, std::ceil(length / cell - 1e-9)));
}

// Of a tile that nothing came to.
constexpr double kBytesOfPlace = sizeof(std::uint32_t);
constexpr double kMostBytesOfPlaces = 1 << 30;

}  // namespace

Grid grid_of(const Box& box, double cell_mm) {
  return {box, cells_over(box.high.u - box.low.u, cell_mm),
          cells_over(box.high.v - box.low.v, cell_mm)};
}

double fitting_cell(const Box& box, double cell_mm, std::size_t memory_bytes) {
  const Vec2 size = box.high - box.low;
  const double longest = std::max(size.u, size.v);
  const double room = std::min(static_cast<double>(memory_bytes) / 4, kMostBytesOfPlaces);
  double cell = std::max(cell_mm, longest / kMostCells * (1 + 1e-6));
  const auto bytes = [&] {
    return static_cast<double>(grid_of(box, cell).tiles()) * kBytesOfPlace;
  };
  while (bytes() > room && cell < longest) cell = std::min(cell * 1.1, longest);
  return cell;
}

}  // namespace kerf::stock::sheet
