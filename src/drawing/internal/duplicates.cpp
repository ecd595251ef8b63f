#include "drawing/internal/duplicates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace kerf::drawing {
namespace {

using contour::Contour;
using contour::Vertex;

/// Whether two vertices begin the same edge: a bulge is as near as it moves the arc's middle.
bool is_same(const Vertex& a, const Vertex& b, double bulge_a, double bulge_b, double chord,
             double same_mm) {
  return geometry::length(a.point - b.point) <= same_mm &&
         0.5 * chord * std::abs(bulge_a - bulge_b) <= same_mm;
}

/// `b` from its vertex `shift` on, forwards or backwards, against `a`.
bool runs_alike(const Contour& a, const Contour& b, std::size_t shift, bool backwards,
                double same_mm) {
  const std::size_t count = a.vertices.size();
  const std::size_t edges = edge_count(a);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = (backwards ? shift + count - i : shift + i) % count;
    const std::size_t edge = backwards ? (k + count - 1) % count : k;  // of b, that leads on
    const bool leads_on = i < edges;
    const double chord =
        leads_on ? geometry::length(a.vertices[(i + 1) % count].point - a.vertices[i].point) : 0;
    const double bulge = leads_on ? b.vertices[edge].bulge : 0;
    if (!is_same(a.vertices[i], b.vertices[k], leads_on ? a.vertices[i].bulge : 0,
                 backwards ? -bulge : bulge, chord, same_mm))
      return false;
  }
  return true;
}

bool is_same(const Contour& a, const Contour& b, double same_mm) {
  if (a.is_closed != b.is_closed || a.vertices.size() != b.vertices.size()) return false;
  const std::size_t count = a.vertices.size();
  if (!a.is_closed)
    return runs_alike(a, b, 0, false, same_mm) || runs_alike(a, b, count - 1, true, same_mm);
  for (std::size_t shift = 0; shift < count; ++shift) {
    if (geometry::length(a.vertices[0].point - b.vertices[shift].point) > same_mm) continue;
    if (runs_alike(a, b, shift, false, same_mm) || runs_alike(a, b, shift, true, same_mm))
      return true;
  }
  return false;
}

/// Cells in which the means of the vertices lie: the same ones are in one or in neighbours.
struct Cell {
  std::int64_t u;
  std::int64_t v;
  Group group;
  std::size_t count;

  friend bool operator==(const Cell&, const Cell&) = default;
};

struct HashOfCell {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t mixed = static_cast<std::uint64_t>(cell.u) * 0x9E3779B97F4A7C15U;
    mixed = (mixed ^ static_cast<std::uint64_t>(cell.v)) * 0xC2B2AE3D27D4EB4FU;
    mixed ^= cell.group * 0x165667B19E3779F9U + cell.count;
    return mixed ^ (mixed >> 29U);
  }
};

Vec2 mean(const Contour& path) {
  Vec2 sum{};
  for (const Vertex& vertex : path.vertices) sum = sum + vertex.point;
  return (1.0 / static_cast<double>(path.vertices.size())) * sum;
}

class Known {
 public:
  Known(const std::vector<Chain>& chains, double same_mm)
      : chains_(chains), same_mm_(same_mm), size_mm_(std::max(same_mm, 1e-6)) {}

  [[nodiscard]] bool has(const Chain& chain, Group group) const {
    const Cell cell = cell_of(chain, group);
    for (std::int64_t u = -1; u <= 1; ++u) {
      for (std::int64_t v = -1; v <= 1; ++v) {
        if (has_in({cell.u + u, cell.v + v, group, cell.count}, chain)) return true;
      }
    }
    return false;
  }
  void add(std::size_t index, Group group) {
    std::vector<std::size_t>& cell = cells_[cell_of(chains_[index], group)];
    if (cell.size() < kMostInACell) cell.push_back(index);
  }

 private:
  /// So many different paths with one middle are compared, whatever the drawing is.
  static constexpr std::size_t kMostInACell = 64;

  [[nodiscard]] Cell cell_of(const Chain& chain, Group group) const {
    const Vec2 middle = mean(chain.path);
    return {std::llround(middle.u / size_mm_), std::llround(middle.v / size_mm_), group,
            chain.path.vertices.size()};
  }
  [[nodiscard]] bool has_in(const Cell& cell, const Chain& chain) const {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return false;
    return std::any_of(found->second.begin(), found->second.end(), [&](std::size_t index) {
      return is_same(chains_[index].path, chain.path, same_mm_);
    });
  }

  const std::vector<Chain>& chains_;
  double same_mm_;
  double size_mm_;
  std::unordered_map<Cell, std::vector<std::size_t>, HashOfCell> cells_;
};

}  // namespace

std::vector<Chain> without_duplicates(std::vector<Chain> chains, const Drawing& drawing,
                                      double same_mm) {
  std::vector<Chain> kept;
  kept.reserve(chains.size());
  Known known(kept, same_mm);
  for (Chain& chain : chains) {
    const Group group = group_of(drawing.entities[chain.entity]);
    if (known.has(chain, group)) continue;
    kept.push_back(std::move(chain));
    known.add(kept.size() - 1, group);
  }
  return kept;
}

}  // namespace kerf::drawing
