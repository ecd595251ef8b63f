#include "geometry/mesh/internal/joining.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace kerf::mesh {
namespace {

using Cell = std::array<std::int64_t, 3>;
using Placed = std::pair<Cell, std::uint32_t>;

/// The smallest number of all that are joined.
class Joined {
 public:
  explicit Joined(std::size_t count) : root_(count) { std::iota(root_.begin(), root_.end(), 0U); }

  [[nodiscard]] std::uint32_t root(std::uint32_t i) {
    while (root_[i] != i) {
      root_[i] = root_[root_[i]];
      i = root_[i];
    }
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t roots[] = {root(a), root(b)};
    root_[std::max(roots[0], roots[1])] = std::min(roots[0], roots[1]);
  }

 private:
  std::vector<std::uint32_t> root_;
};

class Joining {
 public:
  Joining(const TriangleMesh& mesh, std::span<const std::uint32_t> corners, double distance_mm)
      : mesh_(mesh), distance_(distance_mm), joined_(mesh.points.size()) {
    for (const std::uint32_t corner : corners) placed_.emplace_back(cell_of(corner), corner);
    std::sort(placed_.begin(), placed_.end());
  }

  Joined& all() {
    for (const Placed& one : placed_) look_around(one);
    return joined_;
  }

 private:
  [[nodiscard]] Cell cell_of(std::uint32_t corner) const {
    const Vec3 p = (1 / distance_) * mesh_.points[corner];
    const auto whole = [](double v) { return static_cast<std::int64_t>(std::floor(v)); };
    return {whole(p.x), whole(p.y), whole(p.z)};
  }

  /// Cells side by side along Z stand in a row; what comes before was looked at from there.
  void look_around(const Placed& one) {
    for (std::int64_t x = 0; x <= 1; ++x) {
      for (std::int64_t y = -x; y <= 1; ++y) look_along(one, x, y);
    }
  }
  void look_along(const Placed& one, std::int64_t x, std::int64_t y) {
    const Cell low{one.first[0] + x, one.first[1] + y, one.first[2] - 1};
    const Cell high{low[0], low[1], one.first[2] + 1};
    auto at = std::lower_bound(placed_.begin(), placed_.end(), Placed{low, 0});
    for (; at != placed_.end() && at->first <= high; ++at) look_at(one.second, at->second);
  }
  void look_at(std::uint32_t a, std::uint32_t b) {
    if (joined_.root(a) == joined_.root(b)) return;
    if (length(mesh_.points[a] - mesh_.points[b]) <= distance_) joined_.join(a, b);
  }

  const TriangleMesh& mesh_;
  double distance_;
  Joined joined_;
  std::vector<Placed> placed_;
};

}  // namespace

std::uint64_t join_near(TriangleMesh& mesh, std::span<const std::uint32_t> corners,
                        double distance_mm) {
  Joining joining(mesh, corners, distance_mm);
  Joined& joined = joining.all();
  std::uint64_t count = 0;
  for (const std::uint32_t corner : corners) count += joined.root(corner) != corner ? 1U : 0U;
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) corner = joined.root(corner);
  }
  return count;
}

}  // namespace kerf::mesh
