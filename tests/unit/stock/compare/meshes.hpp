#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "geometry/mesh/triangle_mesh.hpp"

namespace kerf::stock::compare::test {

using geometry::Vec3;
using mesh::TriangleMesh;

/// Same corners, other places.
inline TriangleMesh moved(TriangleMesh mesh, const auto& to) {
  for (Vec3& point : mesh.points) point = to(point);
  return mesh;
}

/// Both, as they are.
inline TriangleMesh with(TriangleMesh mesh, const TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const mesh::Triangle& t : other.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return mesh;
}

/// Inside out: a cavity.
inline TriangleMesh turned(TriangleMesh mesh) {
  for (mesh::Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// A prism on a polygon that goes round counterclockwise and is seen whole from its first corner.
inline TriangleMesh prism(const std::vector<std::array<double, 2>>& outline, double low,
                          double high) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (const double z : {low, high}) {
    for (const auto& [x, y] : outline) mesh.points.push_back({x, y, z});
  }
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({n, n + i, n + i + 1});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back({i, next, n + next});
    mesh.triangles.push_back({i, n + next, n + i});
  }
  return mesh;
}

inline TriangleMesh box(Vec3 low, Vec3 high) {
  return prism({{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}}, low.z, high.z);
}

/// Cells of a grid that are filled, as one surface: corners where lines of the grid cross.
inline TriangleMesh filled_cells(const std::vector<double>& xs, const std::vector<double>& ys,
                                 const std::vector<double>& zs, const auto& is_filled) {
  TriangleMesh mesh;
  std::map<std::array<std::size_t, 3>, std::uint32_t> numbers;
  const std::array<std::size_t, 3> counts{xs.size() - 1, ys.size() - 1, zs.size() - 1};
  const auto is_in = [&](std::array<std::size_t, 3> cell) {
    return cell[0] < counts[0] && cell[1] < counts[1] && cell[2] < counts[2] &&
           is_filled(cell[0], cell[1], cell[2]);
  };
  const auto corner = [&](const std::array<std::size_t, 3>& at) {
    const auto [place, is_new] =
        numbers.try_emplace(at, static_cast<std::uint32_t>(mesh.points.size()));
    if (is_new) mesh.points.push_back({xs[at[0]], ys[at[1]], zs[at[2]]});
    return place->second;
  };
  std::array<std::size_t, 3> cell{};
  for (cell[2] = 0; cell[2] < counts[2]; ++cell[2]) {
    for (cell[1] = 0; cell[1] < counts[1]; ++cell[1]) {
      for (cell[0] = 0; cell[0] < counts[0]; ++cell[0]) {
        if (!is_in(cell)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          for (const std::size_t up : {0U, 1U}) {
            std::array<std::size_t, 3> beside = cell;
            beside[axis] = up == 1 ? cell[axis] + 1 : cell[axis] - 1;  // below 0: very large
            if (is_in(beside)) continue;
            std::array<std::uint32_t, 4> round{};
            for (std::size_t k = 0; k < 4; ++k) {
              std::array<std::size_t, 3> at = cell;
              at[axis] += up;
              at[(axis + 1) % 3] += k == 1 || k == 2 ? 1 : 0;
              at[(axis + 2) % 3] += k >= 2 ? 1 : 0;
              round[k] = corner(at);
            }
            if (up == 0) std::swap(round[1], round[3]);
            mesh.triangles.push_back({round[0], round[1], round[2]});
            mesh.triangles.push_back({round[0], round[2], round[3]});
          }
        }
      }
    }
  }
  return mesh;
}

/// A ball of 20·4^n triangles.
inline TriangleMesh ball(double radius, int times) {
  const double g = std::numbers::phi;
  TriangleMesh mesh;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-g, g}) {
      mesh.points.push_back({0, a, b});
      mesh.points.push_back({a, b, 0});
      mesh.points.push_back({b, 0, a});
    }
  }
  // Of the 220 triples those that are an edge apart.
  const auto near = [&](std::uint32_t i, std::uint32_t j) {
    const Vec3 d = mesh.points[i] - mesh.points[j];
    return dot(d, d) < 4.1;
  };
  for (std::uint32_t i = 0; i < 12; ++i) {
    for (std::uint32_t j = i + 1; j < 12; ++j) {
      for (std::uint32_t k = j + 1; k < 12; ++k) {
        if (!near(i, j) || !near(j, k) || !near(k, i)) continue;
        const Vec3 a = mesh.points[i];
        const Vec3 n = cross(mesh.points[j] - a, mesh.points[k] - a);
        mesh.triangles.push_back(dot(n, a) > 0 ? mesh::Triangle{i, j, k} : mesh::Triangle{i, k, j});
      }
    }
  }
  for (int time = 0; time < times; ++time) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t i, std::uint32_t j) {
      const auto [at, is_new] = middles.try_emplace({std::min(i, j), std::max(i, j)},
                                                    static_cast<std::uint32_t>(mesh.points.size()));
      if (is_new) mesh.points.push_back(0.5 * (mesh.points[i] + mesh.points[j]));
      return at->second;
    };
    std::vector<mesh::Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return moved(std::move(mesh), [&](Vec3 p) { return radius * unit(p); });
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  double in(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11U) * 0x1p-53;
  }
  Vec3 in(Vec3 low, Vec3 high) {
    const double x = in(low.x, high.x);
    const double y = in(low.y, high.y);
    return {x, y, in(low.z, high.z)};
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace kerf::stock::compare::test
