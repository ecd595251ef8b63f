#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "geometry/mesh/solid_mesh.hpp"
#include "stock/dexel/lattice.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock::dexel {

/// Material along a dexel: from low to high, with the directions that its faces look to, unit.
struct Interval {
  double low = 0;
  double high = 0;
  Vec3 low_normal;
  Vec3 high_normal;
  std::uint32_t low_motion = 0;  ///< that left the face; 0: none did
  std::uint32_t high_motion = 0;
  /// Of a shape that is taken away: beyond this end there is none of the part.
  bool low_is_border = false;
  bool high_is_border = false;
};

/// Appends the intervals of a shape, in order and apart from each other, along the line through
/// (b, c): `axis` 0, 1, 2 is X, Y, Z, b the coordinate on the next axis, c on the one after that
/// (X: Y and Z, Y: Z and X, Z: X and Y). Called from several threads at once.
using Inside = std::function<void(int axis, double b, double c, std::vector<Interval>& out)>;

/// The same of the dexel in a column and a row of a lattice.
using InsideOf = std::function<void(int column, int row, std::vector<Interval>& out)>;

/// What a stock is before the first cut, or what is taken away from it, in its own frame, mm.
struct Shape {
  Bounds box;  ///< holds all of it; low < high
  Inside inside;
  double volume_mm3 = 0;  ///< exact; 0: as the dexels have it
  /// Instead of `inside`, of what is asked by whole lattices: once for each of the three, in the
  /// order X, Y, Z. `middle` is that of the box.
  std::function<InsideOf(const Lattice& lattice, Vec3 middle)> on_lattice{};
};

/// A shape as the dexels of one lattice see it; `middle` is that of the stock.
[[nodiscard]] InsideOf inside_of(const Shape& shape, const Lattice& lattice, Vec3 middle);

[[nodiscard]] Shape box_shape(const Bounds& box);
/// A cylinder along `axis`, or a tube where inner_mm > 0: centre (b, c) as Inside has them, radii.
struct Round {
  int axis = 2;
  double b = 0;
  double c = 0;
  double low = 0;
  double high = 0;
  double radius_mm = 0;
  double inner_mm = 0;
};
[[nodiscard]] Shape round_shape(const Round& round);

/// Not null.
[[nodiscard]] Shape mesh_shape(std::shared_ptr<const mesh::SolidMesh> solid);

}  // namespace kerf::stock::dexel
