#pragma once

#include <vector>

#include "geometry/contour/internal/planar_map.hpp"

namespace kerf::contour {

/// How often each face of a map is gone round. It is a number of the face, not of its borders: the
/// borders between faces that are taken and faces that are not always close, even where rounding
/// has put half-edges in a wrong order.
struct FaceWindings {
  std::vector<Winding> of_face;
  /// Every piece has on its sides windings that differ by how often it is passed. False tells of
  /// such a wrong order, and that it matters.
  bool agree = true;
};

[[nodiscard]] FaceWindings face_windings(const PlanarMap& map);

}  // namespace kerf::contour
