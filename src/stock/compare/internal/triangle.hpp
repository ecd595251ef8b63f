#pragma once

#include <cstdint>

#include "geometry/vec3.hpp"

namespace kerf::stock::compare {

using geometry::Vec3;

/// What of a triangle is nearest to a place: a corner, the edge from a corner to the next one, or
/// its face.
enum class Feature : std::uint8_t { corner0, corner1, corner2, edge0, edge1, edge2, face };

struct OnTriangle {
  Vec3 point;
  Feature feature = Feature::face;
};

/// The point of a triangle nearest to `place`. One without area is its edges.
[[nodiscard]] OnTriangle nearest_on(Vec3 a, Vec3 b, Vec3 c, Vec3 place);

}  // namespace kerf::stock::compare
