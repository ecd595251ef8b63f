#include "geometry/mesh/lines.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/mesh/internal/rising_edge.hpp"

namespace kerf::mesh {
namespace {

double on_axis(Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

SeenCorner seen(Vec3 p, int axis) {
  return {quanta(on_axis(p, (axis + 1) % 3)), quanta(on_axis(p, (axis + 2) % 3)), on_axis(p, axis)};
}

/// What a triangle passes of the grid. A row meets none of its edges, or one that rises and one
/// that falls; the lines between them pass through it. Where the rising one is the further one,
/// the triangle looks along the lines: they leave there.
class SeenTriangle {
 public:
  SeenTriangle(const TriangleMesh& mesh, const Triangle& t, int axis)
      : corners_{seen(mesh.points[t[0]], axis), seen(mesh.points[t[1]], axis),
                 seen(mesh.points[t[2]], axis)} {
    for (std::size_t i = 0; i < 3; ++i) {
      const SeenCorner& from = corners_[i];
      const SeenCorner& to = corners_[(i + 1) % 3];
      if (from.c < to.c) rising_[risings_++].emplace(from, to);
      if (to.c < from.c) falling_[fallings_++].emplace(to, from);
    }
  }

  /// act(column, row, s, leaves)
  template <class Act>
  void each_line(const Places& columns, const Places& rows, const Act& act) const {
    const auto [low, high] = std::minmax({corners_[0].c, corners_[1].c, corners_[2].c});
    for (std::size_t row = rows.from(low); row < rows.count() && rows[row] < high; ++row) {
      const RisingEdge& up = met(rising_, rows[row]);
      const RisingEdge& down = met(falling_, rows[row]);
      const std::size_t up_beyond = up.first_beyond(columns, rows[row]);
      const std::size_t down_beyond = down.first_beyond(columns, rows[row]);
      const bool leaves = up_beyond > down_beyond;
      const std::size_t last = std::max(up_beyond, down_beyond);
      for (std::size_t i = std::min(up_beyond, down_beyond); i < last; ++i)
        act(i, row, height(up, down, columns[i], rows[row]), leaves);
    }
  }

 private:
  using Edges = std::array<std::optional<RisingEdge>, 2>;

  [[nodiscard]] static const RisingEdge& met(const Edges& edges, std::int64_t c) {
    return edges[0]->meets(c) ? *edges[0] : *edges[1];
  }
  [[nodiscard]] static double height(const RisingEdge& up, const RisingEdge& down, std::int64_t b,
                                     std::int64_t c) {
    const double from = down.b_at(c);
    const double width = up.b_at(c) - from;
    const double share = width == 0 ? 0 : (static_cast<double>(b) - from) / width;
    const double low = down.s_at(c);
    return low + std::clamp(share, 0.0, 1.0) * (up.s_at(c) - low);
  }

  std::array<SeenCorner, 3> corners_;
  Edges rising_;
  Edges falling_;
  std::size_t risings_ = 0;
  std::size_t fallings_ = 0;
};

/// act(line, s, face) for all that pass.
template <class Act>
void each_crossing(const TriangleMesh& mesh, const LineGrid& grid, const Act& act) {
  const Places columns(grid.b);
  const Places rows(grid.c);
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const SeenTriangle triangle(mesh, mesh.triangles[i], grid.axis);
    triangle.each_line(columns, rows, [&](std::size_t b, std::size_t c, double s, bool leaves) {
      act(c * columns.count() + b, s, i << 1U | (leaves ? 1U : 0U));
    });
  }
}

}  // namespace

struct Lines::Crossing {
  double at;
  std::uint32_t face;

  [[nodiscard]] bool leaves() const { return (face & 1U) != 0; }
  /// What enters first comes first, so that solids that touch are one.
  friend bool operator<(const Crossing& a, const Crossing& b) {
    if (a.at != b.at) return a.at < b.at;
    return a.leaves() != b.leaves() ? b.leaves() : a.face < b.face;
  }
};

Lines::Lines(const TriangleMesh& mesh, const LineGrid& grid)
    : columns_(grid.b.size()), begins_(grid.b.size() * grid.c.size() + 1) {
  each_crossing(mesh, grid, [this](std::size_t line, double, std::uint32_t) { ++begins_[line]; });
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : begins_) {
    sum += begin;
    begin = sum;
  }
  at_.resize(sum);
  faces_.resize(sum);
  each_crossing(mesh, grid, [this](std::size_t line, double at, std::uint32_t face) {
    const std::uint32_t place = --begins_[line];
    at_[place] = at;
    faces_[place] = face;
  });
}

std::vector<Lines::Crossing> Lines::crossings_of(std::size_t line) const {
  std::vector<Crossing> crossings;
  for (std::uint32_t i = begins_[line]; i < begins_[line + 1]; ++i)
    crossings.push_back({at_[i], faces_[i]});
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

void Lines::inside(std::size_t column, std::size_t row, double least_mm,
                   std::vector<Stretch>& out) const {
  const std::size_t first = out.size();
  int winding = 0;
  for (const Crossing& crossing : crossings_of(line(column, row))) {
    const int before = winding;
    winding += crossing.leaves() ? -1 : 1;
    const std::uint32_t triangle = crossing.face >> 1U;
    if (before <= 0 && winding > 0) {
      const bool goes_on = out.size() > first && crossing.at - out.back().high < least_mm;
      if (!goes_on) out.push_back({crossing.at, crossing.at, triangle, triangle});
    } else if (before > 0 && winding <= 0) {
      out.back().high = crossing.at;
      out.back().high_triangle = triangle;
    }
  }
  out.erase(std::remove_if(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
                           [&](const Stretch& s) { return s.high - s.low < least_mm; }),
            out.end());
}

bool Lines::is_wound_otherwise() const {
  for (std::size_t line = 0; line + 1 < begins_.size(); ++line) {
    int winding = 0;
    for (const Crossing& crossing : crossings_of(line)) {
      winding += crossing.leaves() ? -1 : 1;
      if (winding < 0 || winding > 1) return true;
    }
  }
  return false;
}

Vec3 seen_mm2(const TriangleMesh& mesh) {
  Vec3 twice{0, 0, 0};
  for (const Triangle& t : mesh.triangles) {
    const Vec3 from = mesh.points[t[0]];
    const Vec3 one = cross(mesh.points[t[1]] - from, mesh.points[t[2]] - from);
    twice = twice + Vec3{std::fabs(one.x), std::fabs(one.y), std::fabs(one.z)};
  }
  return 0.5 * twice;
}

Vec3 normal_of(const TriangleMesh& mesh, std::uint32_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  const Vec3 from = mesh.points[t[0]];
  const Vec3 twice = cross(mesh.points[t[1]] - from, mesh.points[t[2]] - from);
  const double size = length(twice);
  return size > 0 ? (1 / size) * twice : Vec3{0, 0, 1};
}

}  // namespace kerf::mesh
