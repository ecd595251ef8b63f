#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <utility>

#include "base/decimal.hpp"
#include "geometry/mesh/triangle_mesh.hpp"

namespace kerf::mesh::test {

/// Twelve triangles, looking outwards.
inline TriangleMesh block(Vec3 low, Vec3 high) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 8; ++i) {
    mesh.points.push_back({(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y,
                           (i & 4U) != 0 ? high.z : low.z});
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Both side by side as one mesh.
inline TriangleMesh both(TriangleMesh a, const TriangleMesh& b) {
  const auto shift = static_cast<std::uint32_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const Triangle& t : b.triangles)
    a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

inline TriangleMesh turned(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Little endian.
inline void put_word(std::string& out, std::uint32_t word) {
  for (unsigned i = 0; i < 4; ++i) out += static_cast<char>(word >> (8 * i) & 0xFFU);
}
inline void put_float(std::string& out, double value) {
  put_word(out, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

/// An STL whose normals are all 0, as many programs write it.
inline std::string binary_stl(const TriangleMesh& mesh, std::string header = "made by hand") {
  header.resize(80);
  put_word(header, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    header.append(12, '\0');
    for (const std::uint32_t corner : t) {
      put_float(header, mesh.points[corner].x);
      put_float(header, mesh.points[corner].y);
      put_float(header, mesh.points[corner].z);
    }
    header.append(2, '\0');
  }
  return header;
}

inline std::string text_stl(const TriangleMesh& mesh, const std::string& name = "part") {
  std::string text = "solid " + name + "\n";
  for (const Triangle& t : mesh.triangles) {
    text += "  facet normal nan 0 0\n    outer loop\n";
    for (const std::uint32_t corner : t) {
      const Vec3 p = mesh.points[corner];
      text += "      vertex " + base::number_text(p.x) + " " + base::number_text(p.y) + " " +
              base::number_text(p.z) + "\n";
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid " + name + "\n";
}

}  // namespace kerf::mesh::test
