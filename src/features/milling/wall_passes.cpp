#include "features/milling/wall_passes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "features/milling/layer_rows.hpp"
#include "geometry/contour/boolean.hpp"
#include "geometry/contour/sweep.hpp"

namespace kerf::features {
namespace {

using contour::Box;
using contour::BoxTree;
using contour::Contour;
using contour::Edge;
using contour::Region;
using geometry::Vec2;

constexpr double kSameEnd_mm = 1e-6;
constexpr double kSameWall_mm = 2 * kBeside_mm;
constexpr double kAsLong = 0.9;

bool ends_at(const std::optional<WallRow>& row, Vec2 point) {
  return row && (geometry::length(row->path.front().from - point) <= kSameEnd_mm ||
                 geometry::length(row->path.back().to - point) <= kSameEnd_mm);
}

/// How far a point is from the whole line or circle of an edge.
double from_curve(const Edge& edge, Vec2 point) {
  if (edge.bulge == 0)
    return std::fabs(geometry::cross(geometry::unit(edge.to - edge.from), point - edge.from));
  return std::fabs(geometry::length(point - contour::centre(edge)) - contour::radius(edge));
}

/// Beside the row, or hardly beyond its ends: where its round end still goes as its side does.
bool is_along(const WallRow& row, Vec2 point) {
  if (is_beside(row, point)) return true;
  const auto goes_on = [&](const Edge& edge, Vec2 end) {
    return std::fabs(geometry::length(point - end) - row.radius) <= kBeside_mm &&
           std::fabs(from_curve(edge, point) - row.radius) <= kBeside_mm;
  };
  return goes_on(row.path.front(), row.path.front().from) ||
         goes_on(row.path.back(), row.path.back().to);
}

bool is_along(const WallRow& row, const Edge& edge) {
  return is_along(row, edge.from) && is_along(row, edge.to) &&
         is_along(row, contour::point_at(edge, 0.5));
}

/// Beside the row, or where it begins or ends as far off.
bool touches(const std::optional<WallRow>& row, Vec2 point) {
  if (!row) return false;
  const auto is_round = [&](Vec2 end) {
    return std::fabs(geometry::length(point - end) - row->radius) <= kBeside_mm;
  };
  return is_beside(*row, point) || is_round(row->path.front().from) ||
         is_round(row->path.back().to);
}

std::vector<Edge> edges_of_wall(const Contour& wall) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < contour::edge_count(wall); ++i)
    edges.push_back(contour::edge_of(wall, i));
  return edges;
}

/// No point of a wall is far from another one.
bool lies_near(const Contour& wall, const Contour& other) {
  const std::vector<Edge> edges = edges_of_wall(other);
  std::vector<Box> boxes;
  for (const Edge& edge : edges) boxes.push_back(contour::extents(edge).grown(kSameWall_mm));
  const BoxTree tree(boxes);
  const auto is_near = [&](Vec2 point) {
    bool found = false;
    tree.search({point, point}, [&](std::uint32_t place) {
      found = found || contour::distance(edges[place], point) <= kSameWall_mm;
    });
    return found;
  };
  for (const Edge& edge : edges_of_wall(wall)) {
    for (const double share : {0.0, 0.25, 0.5, 0.75}) {
      if (!is_near(contour::point_at(edge, share))) return false;
    }
  }
  return true;
}

Contour turned_as(const Contour& loop, const Contour& wall) {
  const bool is_same = contour::is_counterclockwise(loop) == contour::is_counterclockwise(wall);
  return is_same ? loop : contour::reversed(loop);
}

}  // namespace

// The round end of a row; where the rows on both sides of it meet it is the corner of a wall.
bool WallPasses::is_end_of_pass(const Contour& wall, std::size_t edge) const {
  const Edge arc = contour::edge_of(wall, edge);
  if (arc.bulge == 0) return false;
  const auto row = wall_row(recording_, arc.owner);
  if (!row || is_side_of(*row, arc)) return false;
  const std::size_t count = wall.vertices.size();
  const Vec2 centre = contour::centre(arc);
  return !ends_at(wall_row(recording_, wall.vertices[(edge + count - 1) % count].owner), centre) ||
         !ends_at(wall_row(recording_, wall.vertices[(edge + 1) % count].owner), centre);
}

bool WallPasses::has_ends_of_passes(const Contour& wall) const {
  for (std::size_t i = 0; i < contour::edge_count(wall); ++i) {
    if (is_end_of_pass(wall, i)) return true;
  }
  return false;
}

void WallPasses::index_rows() {
  if (tree_) return;
  std::vector<Box> boxes;
  for (const std::uint32_t number : rows_across(recording_, layer_)) {
    const auto row = wall_row(recording_, number);
    if (!row) continue;
    Box box;
    for (const Edge& edge : row->path) box.take(contour::extents(edge));
    boxes.push_back(box.grown(row->radius + kBeside_mm));
    rows_.push_back(number);
  }
  tree_ = std::make_unique<BoxTree>(boxes);
}

// Of rows about as long the last one has left the wall as it is.
std::optional<WallRow> WallPasses::longest_beside(const Edge& edge) const {
  std::vector<WallRow> along;
  double longest = 0;
  const Vec2 middle = contour::point_at(edge, 0.5);
  tree_->search({middle, middle}, [&](std::uint32_t place) {
    auto row = wall_row(recording_, rows_[place]);
    if (row->length < kAsLong * longest || !is_along(*row, edge)) return;
    longest = std::max(longest, row->length);
    along.push_back(std::move(*row));
  });
  std::optional<WallRow> last;
  for (WallRow& row : along) {
    const bool is_later = !last || row.number > last->number;
    if (is_later && row.length >= kAsLong * longest) last = std::move(row);
  }
  return last;
}

// Corners are those of the rows beside them, and else of the row that has cut them.
std::set<std::uint32_t> WallPasses::rows_along(const Contour& wall) const {
  std::vector<std::optional<WallRow>> beside;
  for (const Edge& edge : edges_of_wall(wall)) beside.push_back(longest_beside(edge));
  std::set<std::uint32_t> rows;
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < beside.size(); ++i) {
    if (beside[i]) rows.insert(beside[i]->number);
    if (!beside[i]) corners.push_back(i);
  }
  const auto next_row = [&](std::size_t from, std::size_t step) -> const std::optional<WallRow>& {
    std::size_t at = (from + step) % beside.size();
    while (!beside[at] && at != from) at = (at + step) % beside.size();
    return beside[at];
  };
  for (const std::size_t corner : corners) {
    const Edge edge = contour::edge_of(wall, corner);
    const std::array<Vec2, 3> points{edge.from, contour::point_at(edge, 0.5), edge.to};
    const bool is_known = std::all_of(points.begin(), points.end(), [&](Vec2 point) {
      return touches(next_row(corner, 1), point) ||
             touches(next_row(corner, beside.size() - 1), point);
    });
    if (!is_known) rows.insert(edge.owner);
  }
  return rows;
}

// Rows that follow each other are one path.
std::vector<Region> WallPasses::swept(const std::set<std::uint32_t>& rows) const {
  std::vector<Region> regions;
  Contour path{{}, false};
  std::optional<WallRow> last;
  const auto end_path = [&] {
    if (!last) return;
    path.vertices.push_back({last->path.back().to, 0, last->number});
    regions.push_back(contour::sweep_of_disc(path, last->radius));
    path.vertices.clear();
  };
  for (const std::uint32_t number : rows) {
    auto row = wall_row(recording_, number);
    if (!row) continue;
    const bool goes_on =
        last && last->number + 1 == number && last->radius == row->radius &&
        geometry::length(last->path.back().to - row->path.front().from) <= kSameEnd_mm;
    if (!goes_on) end_path();
    for (const Edge& edge : row->path) path.vertices.push_back({edge.from, edge.bulge, edge.owner});
    last = std::move(row);
  }
  end_path();
  return regions;
}

std::optional<Contour> WallPasses::cleaned(const Contour& wall) {
  if (!wall.is_closed || !has_ends_of_passes(wall)) return std::nullopt;
  index_rows();
  for (const Contour& loop : contour::unite(swept(rows_along(wall))).loops) {
    if (loop.vertices.size() >= wall.vertices.size()) continue;
    if (lies_near(loop, wall) && lies_near(wall, loop)) return turned_as(loop, wall);
  }
  return std::nullopt;
}

}  // namespace kerf::features
