#include "geometry/contour/region.hpp"

#include <cmath>

#include "geometry/contour/box_tree.hpp"
#include "geometry/contour/internal/arrangement.hpp"
#include "geometry/contour/tolerance.hpp"

namespace kerf::contour {
namespace {

// The middle of the longest edge: no other loop comes near it, as loops have no edge in common.
Vec2 probe_of(const Contour& loop) {
  Edge longest = edge_of(loop, 0);
  for (std::size_t i = 1; i < edge_count(loop); ++i) {
    const Edge edge = edge_of(loop, i);
    if (length(edge) > length(longest)) longest = edge;
  }
  return point_at(longest, 0.5);
}

class Nesting {
 public:
  explicit Nesting(const Region& region) : region_(region), areas_(region.loops.size()) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < areas_.size(); ++i) {
      areas_[i] = std::fabs(area(region.loops[i]));
      boxes.push_back(extents(region.loops[i]).grown(kSame_mm));
    }
    tree_.emplace(boxes);
  }

  // Of the loops that hold the middle of an edge of this one, the smallest.
  std::optional<std::size_t> parent_of(std::size_t index) const {
    const Vec2 point = probe_of(region_.loops[index]);
    Box box;
    box.take(point);
    std::optional<std::size_t> parent;
    tree_->search(box, [&](std::uint32_t other) {
      if (areas_[other] <= areas_[index] || other == index) return;
      if (parent && areas_[*parent] <= areas_[other]) return;
      if (winding(region_.loops[other], point) != 0) parent = other;
    });
    return parent;
  }

 private:
  const Region& region_;
  std::vector<double> areas_;
  std::optional<BoxTree> tree_;
};

template <typename Measure>
double sum_of(const Region& region, Measure&& measure) {
  double sum = 0;
  for (const Contour& loop : region.loops) sum += measure(loop);
  return sum;
}

}  // namespace

Region region_of(const std::vector<Contour>& contours) {
  Region result;
  for (const Contour& contour : contours) {
    Region one = region_of(contour);
    result.loops.insert(result.loops.end(), std::make_move_iterator(one.loops.begin()),
                        std::make_move_iterator(one.loops.end()));
  }
  if (contours.size() < 2) return result;
  std::vector<Strand> strands;
  add_strands(strands, result.loops, Operand::first);
  return {Arrangement(std::move(strands)).loops([](Winding w) { return w.first > 0; })};
}

Region region_of(const Contour& contour) {
  std::vector<Strand> strands;
  add_strands(strands, {contour}, Operand::first);
  return {Arrangement(std::move(strands)).loops([](Winding w) { return w.first != 0; })};
}

Region disc(Vec2 centre, double radius, std::uint32_t owner) {
  if (!(radius > kSame_mm)) return {};
  return {{{{{centre - Vec2{radius, 0}, 1, owner}, {centre + Vec2{radius, 0}, 1, owner}}, true}}};
}

double area(const Region& region) {
  return sum_of(region, [](const Contour& loop) { return area(loop); });
}

double length(const Region& region) {
  return sum_of(region, [](const Contour& loop) { return length(loop); });
}

Box extents(const Region& region) {
  Box box;
  for (const Contour& loop : region.loops) box.take(extents(loop));
  return box;
}

std::size_t vertex_count(const Region& region) {
  std::size_t count = 0;
  for (const Contour& loop : region.loops) count += loop.vertices.size();
  return count;
}

double distance_to_border(const Region& region, Vec2 point) {
  double least = std::numeric_limits<double>::infinity();
  for (const Contour& loop : region.loops) least = std::min(least, distance(loop, point));
  return least;
}

Side side_of(const Region& region, Vec2 point, double tolerance) {
  if (distance_to_border(region, point) <= tolerance) return Side::border;
  int sum = 0;
  for (const Contour& loop : region.loops) sum += winding(loop, point);
  return sum > 0 ? Side::inside : Side::outside;
}

std::vector<std::optional<std::size_t>> parents(const Region& region) {
  const Nesting nesting(region);
  std::vector<std::optional<std::size_t>> result;
  for (std::size_t i = 0; i < region.loops.size(); ++i) result.push_back(nesting.parent_of(i));
  return result;
}

}  // namespace kerf::contour
