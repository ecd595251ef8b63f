#include "stock/compare/line_rows.hpp"

#include <algorithm>
#include <cmath>

#include "stock/dexel/lattice.hpp"

namespace kerf::stock::compare {

using dexel::along_axis;
using dexel::on_axis;

LineRows::LineRows(const Bounds& box) : box_(box) {
  const Vec3 size = box.high - box.low;
  const double across = size.x * size.y + size.y * size.z + size.z * size.x;
  cell_mm_ = std::max(kFinest_mm, std::sqrt(across / kMostLines));
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = std::ceil(on_axis(size, axis) / cell_mm_);
    cells_[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(std::max(1.0, cells));
  }
}

// Of lines along an axis a row has those of one place on the axis after the next.
std::size_t LineRows::count() const { return cells_[0] + cells_[1] + cells_[2]; }

void LineRows::add(std::size_t number, const Solid& part, std::array<bool, 3> have_area,
                   Part::Row& row) const {
  int axis = 0;
  const auto across = [&](int on) { return cells_[static_cast<std::size_t>((axis + on) % 3)]; };
  for (; number >= across(2); ++axis) number -= across(2);
  const Vec3 size = box_.high - box_.low;
  const auto place = [&](int on, std::size_t cell) {
    const int of = (axis + on) % 3;
    const double share = (static_cast<double>(cell) + 0.5) / static_cast<double>(across(on));
    return on_axis(box_.low, of) + share * on_axis(size, of);
  };
  const double area = on_axis(size, (axis + 1) % 3) / static_cast<double>(across(1)) *
                      on_axis(size, (axis + 2) % 3) / static_cast<double>(across(2));
  const double of_point = have_area[static_cast<std::size_t>(axis)] ? area : 0;
  const double c = place(2, number);
  for (std::size_t i = 0; i < across(1); ++i) {
    const double b = place(1, i);
    const auto first = static_cast<std::uint32_t>(row.stretches.size());
    part.inside(axis, b, c, row.stretches);
    const auto end = static_cast<std::uint32_t>(row.stretches.size());
    for (std::uint32_t k = first; k < end; ++k) {
      Stretch& one = row.stretches[k];
      one.low_point = static_cast<std::uint32_t>(row.points.size());
      one.high_point = one.low_point + 1;
      row.points.push_back(
          {along_axis(axis, one.low, b, c), along_axis(axis, -1, 0, 0), of_point, 0});
      row.points.push_back(
          {along_axis(axis, one.high, b, c), along_axis(axis, 1, 0, 0), of_point, 0});
    }
    row.lines.push_back({axis, b, c, area, first, end});
  }
}

}  // namespace kerf::stock::compare
