#include "geometry/contour/box_tree.hpp"

#include <algorithm>

namespace kerf::contour {
namespace {

constexpr std::uint32_t kCells = 1U << 16U;

// How far along the Hilbert curve of kCells × kCells cells this one lies.
std::uint32_t hilbert(std::uint32_t x, std::uint32_t y) {
  std::uint32_t result = 0;
  for (std::uint32_t s = kCells / 2; s > 0; s /= 2) {
    const bool right = (x & s) != 0;
    const bool upper = (y & s) != 0;
    result += s * s * ((right ? 3U : 0U) ^ (upper ? 1U : 0U));
    if (!upper) {
      if (right) {
        x = kCells - 1 - x;
        y = kCells - 1 - y;
      }
      std::swap(x, y);
    }
  }
  return result;
}

std::uint32_t cell_of(double value, double low, double size) {
  if (!(size > 0)) return 0;
  const double share = std::clamp((value - low) / size, 0.0, 1.0);
  return static_cast<std::uint32_t>(share * (kCells - 1));
}

// Place on the curve and number of each box in one word, to be sorted. One that holds nothing has
// no middle, and is met by none.
std::vector<std::uint64_t> keys_of(std::span<const Box> boxes, const Box& all) {
  std::vector<std::uint64_t> keys(boxes.size());
  const Vec2 size = all.high - all.low;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec2 middle = boxes[i].is_empty() ? all.low : boxes[i].middle();
    const std::uint64_t place =
        hilbert(cell_of(middle.u, all.low.u, size.u), cell_of(middle.v, all.low.v, size.v));
    keys[i] = place << 32U | i;
  }
  return keys;
}

std::vector<Box> level_above(const std::vector<Box>& level) {
  std::vector<Box> above((level.size() + BoxTree::kFan - 1) / BoxTree::kFan);
  for (std::size_t i = 0; i < level.size(); ++i) above[i / BoxTree::kFan].take(level[i]);
  return above;
}

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes) {
  Box all;
  for (const Box& box : boxes) all.take(box);
  std::vector<std::uint64_t> keys = keys_of(boxes, all);
  std::sort(keys.begin(), keys.end());
  std::vector<Box> sorted;
  for (const std::uint64_t key : keys) {
    order_.push_back(static_cast<std::uint32_t>(key));
    sorted.push_back(boxes[order_.back()]);
  }
  levels_.push_back(std::move(sorted));
  while (levels_.back().size() > kFan) levels_.push_back(level_above(levels_.back()));
}

}  // namespace kerf::contour
