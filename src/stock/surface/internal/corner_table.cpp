#include "stock/surface/internal/corner_table.hpp"

#include <algorithm>
#include <utility>

namespace kerf::stock::surface {
namespace {

/// An edge by its points, the smaller first, and the corner opposite to it.
struct EdgeOf {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t corner;
};

}  // namespace

CornerTable::CornerTable(std::vector<mesh::Triangle> triangles, std::size_t points)
    : triangles_(std::move(triangles)),
      opposite_(3 * triangles_.size()),
      corner_of_(points, 0),
      is_there_(triangles_.size(), true),
      is_whole_(points, true),
      seen_(points, 0),
      count_(triangles_.size()) {
  for (Corner c = 0; c < opposite_.size(); ++c) corner_of_[point(c)] = c;
  find_opposites();
  find_whole();
}

void CornerTable::find_opposites() {
  std::vector<EdgeOf> edges;
  edges.reserve(opposite_.size());
  for (Corner c = 0; c < opposite_.size(); ++c) {
    const auto [low, high] = std::minmax({point(next(c)), point(previous(c))});
    edges.push_back({low, high, c});
  }
  std::sort(edges.begin(), edges.end(), [](const EdgeOf& a, const EdgeOf& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high) ||
           (a.low == b.low && a.high == b.high && a.corner < b.corner);
  });
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2) link(edges[i].corner, edges[i + 1].corner);
}

void CornerTable::find_whole() {
  std::vector<std::uint32_t> all(corner_of_.size(), 0);
  for (Corner c = 0; c < opposite_.size(); ++c) ++all[point(c)];
  for (Point p = 0; p < corner_of_.size(); ++p) is_whole_[p] = all[p] > 0 && valence(p) == all[p];
}

std::size_t CornerTable::valence(Point p) const {
  std::size_t count = 0;
  around(p, [&](Corner) { ++count; });
  return count;
}

void CornerTable::link(Corner a, Corner b) {
  opposite_[a] = b;
  opposite_[b] = a;
}

bool CornerTable::can_collapse(Corner c) {
  const Point from = point(next(c));
  const Point to = point(previous(c));
  const Point left = point(c);
  const Point right = point(opposite(c));
  if (!is_whole_[from] || !is_whole_[to] || left == right) return false;
  if (valence(left) < 4 || valence(right) < 4) return false;
  ++question_;
  around(from, [&](Corner at) { seen_[point(next(at))] = question_; });
  std::size_t common = 0;
  around(to, [&](Corner at) { common += seen_[point(next(at))] == question_ ? 1U : 0U; });
  return common == 2;
}

//            left                     left
//          c /  \                       |
//     from -------- to      ->          from
//            \  / o                     |
//            right                    right
void CornerTable::collapse(Corner c) {
  const Corner o = opposite_[c];
  const Point from = point(next(c));
  const Point to = point(previous(c));
  const Point left = point(c);
  const Point right = point(o);
  std::vector<Corner> moved;
  around(to, [&](Corner at) { moved.push_back(at); });
  for (const Corner at : moved) triangles_[at / 3][at % 3] = from;
  for (const Corner each : {c, o}) {
    link(opposite_[next(each)], opposite_[previous(each)]);
    is_there_[each / 3] = false;
  }
  count_ -= 2;
  // Of the points around, those that had a corner of what is gone have another one.
  const Corner above = opposite_[next(c)];  // at no point of the edge between left and from
  corner_of_[left] = next(above);
  if (point(corner_of_[left]) != left) corner_of_[left] = previous(above);
  const Corner below = opposite_[next(o)];
  corner_of_[right] = next(below);
  if (point(corner_of_[right]) != right) corner_of_[right] = previous(below);
  corner_of_[from] = point(next(above)) == from ? next(above) : previous(above);
}

}  // namespace kerf::stock::surface
