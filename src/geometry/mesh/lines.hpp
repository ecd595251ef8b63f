#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.hpp"

namespace kerf::mesh {

/// Lines along axis 0, 1 or 2 (X, Y, Z), one through each place (b, c): b is the coordinate on the
/// next axis, c on the one after that (X: Y and Z, Y: Z and X, Z: X and Y). Both lists rise.
struct LineGrid {
  int axis = 2;
  std::vector<double> b;
  std::vector<double> c;
};

/// A piece of a line that lies in a solid: low < high, and the triangles that end it.
struct Stretch {
  double low = 0;
  double high = 0;
  std::uint32_t low_triangle = 0;
  std::uint32_t high_triangle = 0;
};

/// Where lines pass through a solid.
///
/// Whether a line passes through a triangle is decided without rounding: corners and lines are
/// taken at multiples of kQuantum_mm, and integers compared. A line counts as if it stood a little
/// further along c and, of that a little, along b (simulation of simplicity): so it meets no edge
/// and no corner, and enters as often as it leaves, wherever faces lie along it, coincide or touch.
/// Where on the line is the triangle's own height there, in doubles, never outside of the
/// triangle's corners.
///
/// Inside is what is wound round once or more: shells that touch or overlap are one, and those that
/// look inwards are cavities.
///
/// Memory: 12 bytes a crossing, 4 a line. Time: crossings, and for each triangle the rows that it
/// reaches over.
class Lines {
 public:
  /// Precondition: the mesh is that of a SolidMesh, with all that is in it within 10^6 mm of 0.
  Lines(const TriangleMesh& mesh, const LineGrid& grid);

  /// Appends the pieces of a line in order. Those that are apart by less than `least_mm` are one,
  /// shorter ones are left out. Several threads may ask at once.
  void inside(std::size_t column, std::size_t row, double least_mm,
              std::vector<Stretch>& out) const;

  /// What is wound round more than once, or less often than not at all, meets one of the lines: the
  /// volume of the mesh is not that of what is inside.
  [[nodiscard]] bool is_wound_otherwise() const;

  [[nodiscard]] std::size_t crossings() const { return at_.size(); }

  static constexpr double kQuantum_mm = 1.0 / (1 << 26);

 private:
  struct Crossing;

  /// In order along the line.
  [[nodiscard]] std::vector<Crossing> crossings_of(std::size_t line) const;
  [[nodiscard]] std::size_t line(std::size_t column, std::size_t row) const {
    return row * columns_ + column;
  }

  std::size_t columns_ = 0;
  std::vector<std::uint32_t> begins_;  // of each line, and the end
  std::vector<double> at_;
  std::vector<std::uint32_t> faces_;  // triangle, and 1 where the line leaves the solid
};

/// The area of all triangles as seen along X, along Y, along Z, mm²: divided by that of a cell
/// between lines, about the crossings that there will be.
[[nodiscard]] Vec3 seen_mm2(const TriangleMesh& mesh);

/// Unit, where a triangle looks to; that of Z where it has no area.
[[nodiscard]] Vec3 normal_of(const TriangleMesh& mesh, std::uint32_t triangle);

}  // namespace kerf::mesh
