#include "stock/dexel/shape_work.hpp"

#include <algorithm>

namespace kerf::stock::dexel {
namespace {

/// Two places that ought to be one differ by less, of parts up to ten metres: places are float32.
constexpr double kBorder_mm = 1e-3;

CellRange of_tile(CellRange all, int first, int count) {
  return {std::max(all.first - first, 0), std::min(all.last - first, count - 1)};
}

double length_of(const std::vector<Interval>& intervals) {
  double sum = 0;
  for (const Interval& each : intervals) sum += each.high - each.low;
  return sum;
}

double subtract(Tile& tile, std::size_t dexel, const Interval& of, double middle) {
  const double low = of.low - (of.low_is_border ? kBorder_mm : 0) - middle;
  const double high = of.high + (of.high_is_border ? kBorder_mm : 0) - middle;
  const auto end = [](Vec3 normal, std::uint32_t motion) {
    return [normal, motion](float at) {
      return DexelEnd{at, octahedral(-1.0 * normal), 0, motion};
    };
  };
  return tile.subtract(dexel, static_cast<float>(low), static_cast<float>(high),
                       end(of.low_normal, of.low_motion), end(of.high_normal, of.high_motion));
}

void add(CommonLengths& sum, double shape_mm, double part_mm) {
  sum.shape_mm += shape_mm;
  sum.part_mm += part_mm;
  sum.longest_mm = std::max(sum.longest_mm, part_mm);
}

}  // namespace

ShapeWork::ShapeWork(const Lattice& lattice, const Bounds& box, int first_column, int first_row)
    : lattice_(lattice), box_(box), first_column_(first_column), first_row_(first_row) {}

/// act(column, row, intervals) for each dexel that the shape meets.
template <class Act>
void ShapeWork::each(const Tile& tile, const InsideOf& inside, Act&& act) const {
  const int b = (lattice_.axis + 1) % 3;
  const int c = (lattice_.axis + 2) % 3;
  const CellRange columns =
      of_tile(lattice_.columns_in(on_axis(box_.low, b), on_axis(box_.high, b)), first_column_,
              tile.columns());
  const CellRange rows = of_tile(lattice_.rows_in(on_axis(box_.low, c), on_axis(box_.high, c)),
                                 first_row_, tile.rows());
  std::vector<Interval> intervals;
  for (int row = rows.first; row <= rows.last; ++row) {
    for (int column = columns.first; column <= columns.last; ++column) {
      intervals.clear();
      inside(first_column_ + column, first_row_ + row, intervals);
      if (!intervals.empty()) act(column, row, intervals);
    }
  }
}

CommonLengths ShapeWork::measure(const Tile& tile, const InsideOf& inside, Vec3 middle) const {
  const double zero = on_axis(middle, lattice_.axis);
  CommonLengths sum;
  each(tile, inside, [&](int column, int row, const std::vector<Interval>& intervals) {
    double part = 0;
    for (const Interval& one : intervals) {
      part += tile.overlap(tile.index(column, row), static_cast<float>(one.low - zero),
                           static_cast<float>(one.high - zero));
    }
    add(sum, length_of(intervals), part);
  });
  return sum;
}

CommonLengths ShapeWork::take(Tile& tile, const InsideOf& inside, Vec3 middle) const {
  const double zero = on_axis(middle, lattice_.axis);
  CommonLengths sum;
  each(tile, inside, [&](int column, int row, const std::vector<Interval>& intervals) {
    double part = 0;
    for (const Interval& one : intervals)
      part += subtract(tile, tile.index(column, row), one, zero);
    if (part > 0) tile.note_cut(column, row);
    add(sum, length_of(intervals), part);
  });
  return sum;
}

}  // namespace kerf::stock::dexel
