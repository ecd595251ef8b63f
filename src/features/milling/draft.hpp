#pragma once

#include <vector>

#include "features/milling/shaped_level.hpp"
#include "features/tree/hole.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// What one operation has in a feature.
struct Share {
  std::size_t operation = 0;
  std::vector<Span> visits{};
  std::size_t pieces = 0;  ///< that it cut apart from each other
  double beside_mm = 0;    ///< how long its cut lies beside what was cut before
  double wall_mm = 0;      ///< how long the wall was there
  double area = 0;
  double radius = 0;
};

/// A feature of a mill while its levels come in.
struct Draft {
  Feature feature{};
  std::vector<Share> shares{};
  ShapedLevel first{};          ///< of the first layer, its sweep apart
  geometry::Vec2 middle{};      ///< of its box
  std::size_t cuts_before = 0;  ///< Material::cuts() when the last layer was done
  std::uint32_t first_row = 0;
  bool is_gone = false;  ///< it has become a step of a hole
};

}  // namespace kerf::features
