#include "stock/compare/near_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/each_by_threads.hpp"

namespace kerf::stock::compare {
namespace {

using Point = std::array<float, 3>;

constexpr std::size_t kWorthAThread = 1 << 14;
/// Halves of less than such a share of all are made by the thread that has them.
constexpr std::size_t kParts = 8;
constexpr float kFar = std::numeric_limits<float>::infinity();

float below(double value) {
  const auto rounded = static_cast<float>(value);
  return double{rounded} > value ? std::nextafter(rounded, -kFar) : rounded;
}
float above(double value) { return -below(-value); }

void take(NearTree::Box& box, const NearTree::Box& other) {
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = std::min(box.low[i], other.low[i]);
    box.high[i] = std::max(box.high[i], other.high[i]);
  }
}

constexpr NearTree::Box kNothing{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};

NearTree::Box around(const Bounds& bounds) {
  return {{below(bounds.low.x), below(bounds.low.y), below(bounds.low.z)},
          {above(bounds.high.x), above(bounds.high.y), above(bounds.high.z)}};
}

std::size_t longest(const NearTree::Box& box) {
  const auto side = [&](std::size_t i) { return box.high[i] - box.low[i]; };
  const std::size_t longer = side(1) > side(0) ? 1 : 0;
  return side(2) > side(longer) ? 2 : longer;
}

}  // namespace

struct NearTree::Middles {
  std::vector<Point> points;

  [[nodiscard]] Box box(const std::uint32_t* begin, const std::uint32_t* end) const {
    Box box = kNothing;
    for (; begin != end; ++begin) take(box, {points[*begin], points[*begin]});
    return box;
  }
};

NearTree::NearTree(std::size_t count, const std::function<Bounds(std::size_t)>& box_of)
    : order_(count), boxes_(count == 0 ? 0 : 2 * ((count + kLeaf - 1) / kLeaf) - 1) {
  if (count == 0) return;
  std::iota(order_.begin(), order_.end(), 0U);
  Middles middles;
  middles.points.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Bounds box = box_of(i);
    const Vec3 middle = 0.5 * (box.low + box.high);
    middles.points[i] = {static_cast<float>(middle.x), static_cast<float>(middle.y),
                         static_cast<float>(middle.z)};
  }
  build(whole(), middles, box_of);
}

void NearTree::begin(const Bounds& box, double reach_mm, Start& start) const {
  constexpr double kRounding = 1 + 1e-9;
  const double square = reach_mm * reach_mm;
  start.box_ = box;
  start.count_ = 0;
  start.square_ = square;
  std::array<Part, kDeepest> waiting;
  std::size_t count = order_.empty() ? 0 : 1;
  waiting[0] = whole();
  while (count > 0) {
    const Part part = waiting[--count];
    if (boxes_[part.node].square_from(box) > square * kRounding) continue;
    if (!part.is_leaf()) {
      waiting[count++] = part.second();
      waiting[count++] = part.first();
    } else if (start.count_ < Start::kMost) {
      start.parts_[start.count_++] = part;
    } else {  // too many
      start.parts_[0] = whole();
      start.count_ = 1;
      start.square_ = std::numeric_limits<double>::infinity();
      return;
    }
  }
}

void NearTree::build(const Part& part, const Middles& middles,
                     const std::function<Bounds(std::size_t)>& box_of) {
  Box& box = boxes_[part.node];
  box = kNothing;
  std::uint32_t* const begin = order_.data() + part.begin;
  std::uint32_t* const end = begin + part.count;
  if (part.is_leaf()) {
    std::sort(begin, end);
    for (const std::uint32_t* each = begin; each != end; ++each) take(box, around(box_of(*each)));
    return;
  }
  const std::size_t axis = longest(middles.box(begin, end));
  const Part first = part.first();
  const Part second = part.second();
  // Of equal middles the number decides, so that there is one order only.
  std::nth_element(begin, begin + first.count, end, [&](std::uint32_t a, std::uint32_t b) {
    const float at_a = middles.points[a][axis];
    const float at_b = middles.points[b][axis];
    return at_a < at_b || (at_a == at_b && a < b);
  });
  const bool is_worth = part.count > kWorthAThread && part.count > order_.size() / kParts;
  base::each_by_threads(2, is_worth ? 2 : 1,
                        [&](std::size_t i) { build(i == 0 ? first : second, middles, box_of); });
  take(box, boxes_[first.node]);
  take(box, boxes_[second.node]);
}

}  // namespace kerf::stock::compare
