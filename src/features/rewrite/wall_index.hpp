#pragma once

#include <vector>

#include "geometry/contour/box_tree.hpp"
#include "geometry/contour/contour.hpp"

namespace kerf::features {

/// A contour of which is often asked how far points are from it: each question costs log n. The
/// contour must outlive it.
class WallIndex {
 public:
  explicit WallIndex(const contour::Contour& wall);

  /// The distance of a point from it, or `most`, whichever is less.
  [[nodiscard]] double distance(contour::Vec2 point, double most) const;
  /// Calls visit(distance) for every vertex that is no farther than `reach` from a point.
  template <typename Visit>
  void vertices_near(contour::Vec2 point, double reach, Visit&& visit) const {
    edges_.search(box_round(point, reach), [&](std::uint32_t i) {
      const double off = geometry::length(wall_.vertices[i].point - point);
      if (off <= reach) visit(off);
    });
  }

 private:
  [[nodiscard]] static contour::Box box_round(contour::Vec2 point, double reach);
  [[nodiscard]] static std::vector<contour::Box> boxes_of(const contour::Contour& wall);

  const contour::Contour& wall_;
  contour::BoxTree edges_;
};

}  // namespace kerf::features
