#include "stock/compare/internal/skin.hpp"

#include <algorithm>

#include "stock/compare/internal/beyond.hpp"

namespace kerf::stock::compare {

void HeightRange::take(HeightRange other) {
  if (other.is_none()) return;
  if (is_none()) {
    *this = other;
  } else {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
}

Skin::Skin(const std::vector<double>& x, const std::vector<double>& y, const RangeOf& range_of)
    : x_(&x), y_(&y) {
  std::size_t columns = x.size() - 1;
  std::size_t rows = y.size() - 1;
  do {
    Level level;
    level.columns = (columns + kFan - 1) / kFan;
    level.rows = (rows + kFan - 1) / kFan;
    level.ranges.resize(level.columns * level.rows);
    for (std::size_t j = 0; j < rows; ++j) {
      for (std::size_t i = 0; i < columns; ++i) {
        level.ranges[j / kFan * level.columns + i / kFan].take(
            levels_.empty() ? range_of({i, j}) : levels_.back().ranges[j * columns + i]);
      }
    }
    columns = level.columns;
    rows = level.rows;
    levels_.push_back(std::move(level));
  } while (columns * rows > 1);
}

// A block of level n has 4^n cells along a side.
double Skin::square(Vec3 place, std::size_t level, std::size_t i, std::size_t j,
                    HeightRange range) const {
  const std::size_t side = std::size_t{1} << (2 * level);
  const auto end = [&](const std::vector<double>& of, std::size_t k) {
    return of[std::min(of.size() - 1, (k + 1) * side)];
  };
  const double x = beyond(place.x, (*x_)[i * side], end(*x_, i));
  const double y = beyond(place.y, (*y_)[j * side], end(*y_, j));
  const double z = beyond(place.z, double{range.low}, double{range.high});
  return x * x + y * y + z * z;
}

}  // namespace kerf::stock::compare
