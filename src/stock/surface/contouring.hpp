#pragma once

#include <cstdint>
#include <vector>

#include "stock/surface/samples.hpp"
#include "stock/surface/surface.hpp"

namespace kerf::stock::surface {

/// A piece of a surface, of one block of cells. Where blocks meet both have the same points, to the
/// last bit, so that they fit together without a seam.
struct Patch {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;  ///< of points: mean of the faces that meet there, unit
  std::vector<std::uint32_t> point_owners;
  std::vector<mesh::Triangle> triangles;
  std::vector<std::uint32_t> owners;  ///< of triangles: motions
  /// Of points: which cell of the lattice and which line through it has made it. Rising.
  std::vector<std::uint64_t> keys;
};

/// Dual contouring: each cell that the surface passes gets a point, or one for each sheet of it,
/// where the planes of its crossings meet, so that edges and corners stay sharp; each line between
/// neighbouring points of the lattice that leaves the material gets the two triangles between the
/// four cells around it. Points lie in their cells, so no farther from the ends of the model's
/// lines than half a cell along each axis, or half a millionth of the part's size.
///
/// Closed and oriented whatever the samples are, for what is inside and what is not is said by
/// points of the lattice alone; doubtful cells are told in internal/cell_cycles.hpp. The same
/// samples make the same bits, in whatever order and by however many threads blocks are made.
class Contouring {
 public:
  static constexpr int kBlock = 32;  ///< cells along each axis

  /// The samples outlive it.
  explicit Contouring(const Samples& samples);

  /// How many blocks there are along each axis.
  [[nodiscard]] Place blocks() const { return blocks_; }
  /// Of one block. Any thread. Empty where no surface passes.
  [[nodiscard]] Patch patch(Place block) const;
  /// What of the stock patch() looks at: where nothing has changed in it, the patch is the same.
  [[nodiscard]] Bounds seen(Place block) const;

  /// All of it, by `jobs` threads; 0: one a processor.
  [[nodiscard]] Surface surface(unsigned jobs) const;

 private:
  const Samples& samples_;
  Place blocks_;
};

}  // namespace kerf::stock::surface
