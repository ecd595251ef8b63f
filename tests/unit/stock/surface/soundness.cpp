#include "soundness.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace kerf::stock::surface::test {
namespace {

using geometry::Vec3;
using Corner = std::array<float, 3>;

Corner corner(Vec3 p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

double area(const Corner& a, const Corner& b, const Corner& c) {
  const auto vec = [](const Corner& p) { return Vec3{double{p[0]}, double{p[1]}, double{p[2]}}; };
  return geometry::length(cross(vec(b) - vec(a), vec(c) - vec(a))) / 2;
}

std::size_t root(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

Soundness soundness(const Surface& surface) {
  Soundness found;
  std::vector<Corner> corners;
  for (const Vec3& p : surface.mesh.points) corners.push_back(corner(p));
  std::vector<Corner> sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  std::vector<std::uint64_t> number_of;
  for (const Corner& each : corners) {
    const auto at = std::lower_bound(sorted.begin(), sorted.end(), each) - sorted.begin();
    number_of.push_back(static_cast<std::uint64_t>(at));
  }
  found.points = sorted.size();
  found.merged = corners.size() - sorted.size();
  found.triangles = surface.mesh.triangles.size();
  struct Side {
    std::uint64_t low, high;
    bool is_up;
    std::size_t triangle;
  };
  std::vector<Side> sides;
  std::vector<std::array<std::uint64_t, 3>> triangles;
  for (std::size_t i = 0; i < surface.mesh.triangles.size(); ++i) {
    std::array<std::uint64_t, 3> t{};
    for (std::size_t k = 0; k < 3; ++k) t[k] = number_of[surface.mesh.triangles[i][k]];
    if (area(sorted[t[0]], sorted[t[1]], sorted[t[2]]) <= 0) ++found.flat;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t a = t[k];
      const std::uint64_t b = t[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), a < b, i});
    }
    std::sort(t.begin(), t.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  for (std::size_t i = 1; i < triangles.size(); ++i)
    found.repeated += triangles[i] == triangles[i - 1] ? 1U : 0U;
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  std::vector<std::size_t> parent(found.triangles);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  long edges = 0;
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j, ++edges) {
    int up = 0;
    for (; j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high;
         ++j) {
      up += sides[j].is_up ? 1 : 0;
      parent[root(parent, sides[j].triangle)] = root(parent, sides[i].triangle);
    }
    if (j - i > 2) {
      ++found.crowded;
    } else if (j - i != 2 || up != 1) {
      ++found.open;
    }
  }
  for (std::size_t i = 0; i < parent.size(); ++i) found.shells += root(parent, i) == i ? 1U : 0U;
  found.euler = static_cast<long>(found.points) - edges + static_cast<long>(found.triangles);
  found.volume_mm3 = mesh::volume_mm3(surface.mesh);
  return found;
}

std::string Soundness::text() const {
  std::string out;
  for (const auto& [name, value] : {std::pair{"points", points},
                                    {"triangles", triangles},
                                    {"shells", shells},
                                    {"open", open},
                                    {"crowded", crowded},
                                    {"flat", flat},
                                    {"repeated", repeated},
                                    {"merged", merged}}) {
    out += std::string(name) + " " + std::to_string(value) + ", ";
  }
  return out + "euler " + std::to_string(euler) + ", volume " + std::to_string(volume_mm3);
}

}  // namespace kerf::stock::surface::test
