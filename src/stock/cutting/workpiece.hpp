#pragma once

#include <memory>
#include <variant>

#include "geometry/mesh/solid_mesh.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock {

// What lies on the table (stock.md §2.1), mm, frame of the stock.

struct BoxShape {
  Vec3 low;
  Vec3 high;  ///< > low
};

/// A round piece along an axis of the frame, or a tube of it.
struct CylinderShape {
  int along = 2;  ///< 0 X, 1 Y, 2 Z
  double u = 0;   ///< the other two coordinates of its middle, in alphabetical order
  double v = 0;
  double from = 0;
  double to = 0;        ///< > from
  double diameter = 0;  ///< > inner_diameter
  double inner_diameter = 0;
};

/// A solid of triangles. Shared, because it may be large; not null.
struct MeshShape {
  std::shared_ptr<const mesh::SolidMesh> solid;
  Bounds box;     ///< of it
  Vec3 seen_mm2;  ///< what its triangles show along X, Y and Z
};
/// Where shells of it overlap, its volume is measured, and its changes say so.
[[nodiscard]] MeshShape mesh_shape(mesh::SolidMesh solid);
/// The same of one whose volume is known.
[[nodiscard]] MeshShape mesh_shape(mesh::TriangleMesh mesh, double volume_mm3);

class SavedPart;
/// A part that was cut before. Not null.
struct SavedShape {
  std::shared_ptr<const SavedPart> part;
};

using Workpiece = std::variant<BoxShape, CylinderShape, MeshShape, SavedShape>;

/// Exact; of a mesh what its triangles enclose, of a part that was cut what was told of it.
[[nodiscard]] double volume(const Workpiece& piece);
[[nodiscard]] Bounds bounds(const Workpiece& piece);

}  // namespace kerf::stock
