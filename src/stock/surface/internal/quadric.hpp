#pragma once

#include <array>
#include <optional>

#include "geometry/vec3.hpp"

namespace kerf::stock::surface {

/// The sum of the squares of a point's distances from planes, each by its weight.
class Quadric {
 public:
  Quadric() = default;
  /// `normal` unit.
  Quadric(geometry::Vec3 normal, geometry::Vec3 place, double weight);

  Quadric& operator+=(const Quadric& other);
  [[nodiscard]] double at(geometry::Vec3 p) const;
  /// Where it is least; nothing: planes that do not meet in a point, or hardly so.
  [[nodiscard]] std::optional<geometry::Vec3> least() const;

 private:
  // xx xy xz x yy yz y zz z 1
  std::array<double, 10> a_{};
};

}  // namespace kerf::stock::surface
