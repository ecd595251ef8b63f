#include "stock/surface/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace kerf::stock::surface {
namespace {

using geometry::Vec3;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Which points hang together by triangles.
class Shells {
 public:
  explicit Shells(const Surface& surface) : parent_(surface.mesh.points.size()) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    for (const mesh::Triangle& t : surface.mesh.triangles) {
      join(t[0], t[1]);
      join(t[0], t[2]);
    }
  }
  /// The first of its points.
  [[nodiscard]] std::uint32_t of(std::uint32_t point) {
    while (parent_[point] != point) point = parent_[point] = parent_[parent_[point]];
    return point;
  }

 private:
  void join(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax({of(a), of(b)});
    parent_[high] = low;
  }

  std::vector<std::uint32_t> parent_;
};

struct Shell {
  std::vector<std::uint32_t> triangles;
  double volume = 0;
  mesh::MeshBox box;
};

/// Twice the area of a triangle seen along Z.
double seen(Vec3 a, Vec3 b, Vec3 p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

class Sorter {
 public:
  explicit Sorter(const Surface& surface) : surface_(surface) { find_shells(); }

  std::vector<Surface> pieces() {
    std::vector<std::vector<std::size_t>> of_outer(shells_.size());
    for (std::size_t i = 0; i < shells_.size(); ++i) {
      if (shells_[i].volume > 0) of_outer[i].push_back(i);
    }
    for (std::size_t i = 0; i < shells_.size(); ++i) {
      if (shells_[i].volume > 0) continue;
      if (const auto outer = around(shells_[i])) of_outer[*outer].push_back(i);
    }
    std::erase_if(of_outer, [](const auto& piece) { return piece.empty(); });
    std::stable_sort(of_outer.begin(), of_outer.end(),
                     [&](const auto& a, const auto& b) { return volume(a) > volume(b); });
    std::vector<Surface> out;
    for (const auto& piece : of_outer) out.push_back(surface_of(piece));
    return out;
  }

 private:
  void find_shells() {
    Shells shells(surface_);
    std::vector<std::uint32_t> numbers(surface_.mesh.points.size(), kNone);
    for (std::uint32_t i = 0; i < surface_.mesh.triangles.size(); ++i) {
      std::uint32_t& number = numbers[shells.of(surface_.mesh.triangles[i][0])];
      if (number == kNone) {
        number = static_cast<std::uint32_t>(shells_.size());
        shells_.emplace_back();
      }
      shells_[number].triangles.push_back(i);
    }
    for (Shell& shell : shells_) measure(shell);
  }

  void measure(Shell& shell) const {
    const Vec3 from = corner(shell.triangles.front(), 0);
    shell.box = {from, from};
    for (const std::uint32_t t : shell.triangles) {
      shell.volume += dot(corner(t, 0) - from, cross(corner(t, 1) - from, corner(t, 2) - from)) / 6;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 p = corner(t, k);
        Vec3& low = shell.box.low;
        Vec3& high = shell.box.high;
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    }
  }

  [[nodiscard]] Vec3 corner(std::uint32_t triangle, std::size_t k) const {
    return surface_.mesh.points[surface_.mesh.triangles[triangle][k]];
  }

  [[nodiscard]] double volume(const std::vector<std::size_t>& piece) const {
    double sum = 0;
    for (const std::size_t shell : piece) sum += shells_[shell].volume;
    return sum;
  }

  /// The smallest outer shell around a cavity.
  [[nodiscard]] std::optional<std::size_t> around(const Shell& cavity) const {
    std::optional<std::size_t> best;
    // The middle of a triangle: hardly on an edge of another one.
    const std::uint32_t t = cavity.triangles.front();
    const Vec3 p = 0.31 * corner(t, 0) + (0.33 * corner(t, 1) + 0.36 * corner(t, 2));
    for (std::size_t i = 0; i < shells_.size(); ++i) {
      if (!(shells_[i].volume > 0) || (best && shells_[i].volume >= shells_[*best].volume))
        continue;
      if (holds(shells_[i], p)) best = i;
    }
    return best;
  }

  /// An upward line from inside passes it an odd number of times.
  [[nodiscard]] bool holds(const Shell& shell, Vec3 p) const {
    const Vec3 low = shell.box.low;
    const Vec3 high = shell.box.high;
    if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y || p.z > high.z) return false;
    bool inside = false;
    for (const std::uint32_t t : shell.triangles) {
      const Vec3 a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
      const double wa = seen(b, c, p), wb = seen(c, a, p), wc = seen(a, b, p);
      const bool is_over = (wa >= 0 && wb >= 0 && wc >= 0) || (wa <= 0 && wb <= 0 && wc <= 0);
      const double sum = wa + wb + wc;
      if (!is_over || sum == 0) continue;
      if ((wa * a.z + wb * b.z + wc * c.z) / sum > p.z) inside = !inside;
    }
    return inside;
  }

  [[nodiscard]] Surface surface_of(const std::vector<std::size_t>& piece) {
    Surface out;
    numbers_.assign(surface_.mesh.points.size(), kNone);
    for (const std::size_t shell : piece) {
      for (const std::uint32_t t : shells_[shell].triangles) {
        mesh::Triangle triangle{};
        for (std::size_t k = 0; k < 3; ++k) triangle[k] = taken(surface_.mesh.triangles[t][k], out);
        out.mesh.triangles.push_back(triangle);
        out.owners.push_back(surface_.owners[t]);
      }
    }
    return out;
  }

  std::uint32_t taken(std::uint32_t point, Surface& out) {
    std::uint32_t& number = numbers_[point];
    if (number == kNone) {
      number = static_cast<std::uint32_t>(out.mesh.points.size());
      out.mesh.points.push_back(surface_.mesh.points[point]);
      out.point_owners.push_back(surface_.point_owners[point]);
    }
    return number;
  }

  const Surface& surface_;
  std::vector<Shell> shells_;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace

std::vector<Surface> pieces_of(const Surface& surface) { return Sorter(surface).pieces(); }

}  // namespace kerf::stock::surface
