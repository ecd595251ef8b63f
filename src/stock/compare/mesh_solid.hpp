#pragma once

#include <array>
#include <span>

#include "geometry/mesh/triangle_mesh.hpp"
#include "stock/compare/near_tree.hpp"
#include "stock/compare/solid.hpp"

namespace kerf::stock::compare {

/// A design: what a mesh encloses. Its triangles are found by a tree, n log n to make, log n to
/// ask.
///
/// Which side of the surface a place is on, the nearest point alone says: by the normal of a face,
/// the sum of the normals at an edge, the sum of the normals at a corner weighted by the angles
/// that the triangles have there. Only these three are right for every place and every solid. Where
/// they say next to nothing (folds thinner than the numbers of a file, triangles without area), and
/// where several bodies may touch or overlap, lines through the solid decide, how often they go in
/// and out. Of such bodies faces within each other are not among the points; they count where
/// distances are measured from within.
class MeshSolid final : public Solid {
 public:
  /// Precondition: closed, oriented outwards, at least one triangle, every corner a number below
  /// 2^31 of them.
  explicit MeshSolid(mesh::TriangleMesh mesh);

  [[nodiscard]] Near near(Vec3 place, Hint& hint) const override;
  [[nodiscard]] Bounds bounds() const override { return bounds_; }
  /// Corners, and points in the triangles.
  [[nodiscard]] std::size_t rows() const override;
  void points(std::size_t row, double spacing_mm, std::vector<SurfacePoint>& out) const override;
  void inside(int axis, double b, double c, std::vector<Stretch>& out) const override {
    Hint nowhere;
    inside_near(axis, b, c, nowhere, out);
  }
  void inside_near(int axis, double b, double c, Hint& hint,
                   std::vector<Stretch>& out) const override;

  /// Whether the solid is there. Of places on the surface either.
  [[nodiscard]] bool holds(Vec3 place) const;
  [[nodiscard]] const mesh::TriangleMesh& mesh() const { return mesh_; }
  /// What it takes, with the tree and the neighbours.
  [[nodiscard]] std::size_t bytes() const;

 private:
  static constexpr std::size_t kRowCorners = 4096;
  static constexpr std::size_t kRowTriangles = 256;
  struct Nearest;
  struct Crossing {
    double at;
    int into;  // 1: into the solid, -1: out of it
  };

  [[nodiscard]] Vec3 corner(std::uint32_t triangle, std::size_t which) const {
    return mesh_.points[mesh_.triangles[triangle][which]];
  }
  [[nodiscard]] std::span<const std::uint32_t> around(std::uint32_t point) const {
    return {triangles_at_.data() + first_at_[point], first_at_[point + 1] - first_at_[point]};
  }
  void find_neighbours();
  [[nodiscard]] bool has_bodies_that_meet() const;
  /// Whether there is material on one side of a place on the surface, and none on the other.
  [[nodiscard]] bool is_border(const SurfacePoint& point) const;
  /// Unit; zero: it has no area.
  [[nodiscard]] Vec3 normal_of(std::uint32_t triangle) const;
  /// As normals at corners and edges are weighted; zero: they say nothing.
  [[nodiscard]] Vec3 normal_at_corner(std::uint32_t point) const;
  [[nodiscard]] Vec3 normal_at_edge(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] bool is_outside(Vec3 place, const Nearest& nearest) const;
  [[nodiscard]] std::vector<Crossing> crossings(int axis, double b, double c,
                                                const NearTree::Start* start) const;
  /// That of a hint, for a line and those around; null: the root.
  [[nodiscard]] const NearTree::Start* start_for(int axis, double b, double c, Hint& hint) const;
  void add_points(std::size_t row, double spacing_mm, std::vector<SurfacePoint>& out) const;
  void add_points_of(std::uint32_t triangle, double spacing_mm,
                     std::vector<SurfacePoint>& out) const;

  mesh::TriangleMesh mesh_;
  Bounds bounds_;
  NearTree tree_;
  std::vector<std::uint32_t> first_at_;      // of each point in triangles_at_, and the end
  std::vector<std::uint32_t> triangles_at_;  // that have a point for a corner
  bool bodies_meet_ = false;                 // there are several, and their boxes meet
};

}  // namespace kerf::stock::compare
