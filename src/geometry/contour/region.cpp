#include "geometry/contour/region.hpp"

#include <cmath>

#include "geometry/contour/box_tree.hpp"
#include "geometry/contour/internal/arrangement.hpp"
#include "geometry/contour/tolerance.hpp"

namespace kerf::contour {
namespace {

Edge longest_edge(const Contour& loop) {
  Edge longest = edge_of(loop, 0);
  for (std::size_t i = 1; i < edge_count(loop); ++i) {
    const Edge edge = edge_of(loop, i);
    if (length(edge) > length(longest)) longest = edge;
  }
  return longest;
}

// Whether a loop goes round an edge of another one. They may touch in points, also here: of several
// points one is none of those.
bool goes_round(const Contour& loop, const Edge& edge) {
  for (const double share : {0.5, 0.382, 0.7236, 0.146, 0.91}) {
    const Vec2 point = point_at(edge, share);
    if (distance(loop, point) > 2 * kSame_mm) return winding(loop, point) != 0;
  }
  return false;
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

  // Of the loops round an edge of this one the smallest.
  std::optional<std::size_t> parent_of(std::size_t index) const {
    const Edge edge = longest_edge(region_.loops[index]);
    Box box;
    box.take(point_at(edge, 0.5));
    std::optional<std::size_t> parent;
    tree_->search(box, [&](std::uint32_t other) {
      if (areas_[other] <= areas_[index] || other == index) return;
      if (parent && areas_[*parent] <= areas_[other]) return;
      if (goes_round(region_.loops[other], edge)) parent = other;
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
  add_strands(strands, std::span(&contour, 1), Operand::first);
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
