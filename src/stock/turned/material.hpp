#pragma once

#include <vector>

#include "geometry/contour/passage.hpp"

namespace kerf::stock::turned {

/// A region that is cut away piece by piece. Loops that a tool cannot meet are left alone.
class Material {
 public:
  explicit Material(contour::Region region) { become(std::move(region)); }

  [[nodiscard]] const contour::Region& region() const { return region_; }
  /// Whether anything of it may lie in the box.
  [[nodiscard]] bool may_meet(const contour::Box& box) const;
  /// What of it closed contours go round that lie in the box and wind >= 0 everywhere, and what
  /// would be left.
  [[nodiscard]] contour::Division divide(const std::vector<contour::Contour>& by,
                                         const contour::Box& box) const;
  void become(contour::Region region);

 private:
  [[nodiscard]] contour::Division divide_all(const std::vector<contour::Contour>& by,
                                             const contour::Box& box) const;

  contour::Region region_;
  std::vector<contour::Box> boxes_;  ///< of the loops
};

}  // namespace kerf::stock::turned
