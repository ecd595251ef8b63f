#pragma once

#include <optional>

#include "geometry/contour/contour.hpp"

namespace kerf::features {

/// Where a contour comes to lie, and with it what ends beside it. Both must outlive this.
class CornerShift {
 public:
  CornerShift(const contour::Contour& before, const contour::Contour& now)
      : before_(before), now_(now) {}

  /// As many elements, and each arc of the angle that it had.
  [[nodiscard]] bool keeps_elements() const;
  /// Of the vertex that is no farther than `reach` from a point, the nearest one. Of contours that
  /// keep their elements.
  [[nodiscard]] std::optional<contour::Vec2> at(contour::Vec2 point, double reach) const;
  /// Of a pass along the axis that ends at a radius, or, where it does not run `along_z`, one
  /// across it that ends at a place: how much farther it goes.
  [[nodiscard]] std::optional<double> farther(contour::Vec2 end, bool along_z) const;
  /// Where the old contour is beside the end of such a pass.
  [[nodiscard]] std::optional<double> place(contour::Vec2 end, bool along_z) const;
  /// Of the point where a row begins that runs along an element from before it: it stays on that
  /// element's line, as far from its end as it can.
  [[nodiscard]] std::optional<contour::Vec2> before_element(contour::Vec2 from,
                                                            contour::Vec2 to) const;

 private:
  const contour::Contour& before_;
  const contour::Contour& now_;
};

}  // namespace kerf::features
