#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/vec3.hpp"

namespace kerf::mesh {

/// Corners by number: equal ones have the same. Numbers rise by one from 0, in the order in which
/// corners are new. 0 and -0 are the same.
class CornerPool {
 public:
  /// Room for so many.
  void reserve(std::size_t count);
  /// Precondition: finite, and fewer than 2^31 corners so far.
  [[nodiscard]] std::uint32_t number_of(geometry::Vec3 corner);
  [[nodiscard]] std::vector<geometry::Vec3> take() && { return std::move(corners_); }

 private:
  void make_slots(std::size_t count);
  [[nodiscard]] std::size_t slot_of(geometry::Vec3 corner) const;

  std::vector<geometry::Vec3> corners_;
  std::vector<std::uint32_t> slots_;  // number + 1; 0: free
};

}  // namespace kerf::mesh
