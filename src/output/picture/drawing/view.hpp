#pragma once

#include <array>
#include <optional>
#include <utility>

#include "output/picture/drawing/display_list.hpp"
#include "output/picture/drawing/space.hpp"

namespace kerf::output::plot {

/// From where the path is seen: how far one millimetre along X, Y and Z goes to the right and up on
/// paper.
struct Projection {
  Point3 right, up;

  [[nodiscard]] double to_right(const Point3& p) const {
    return right[kX] * p[kX] + right[kY] * p[kY] + right[kZ] * p[kZ];
  }
  [[nodiscard]] double upward(const Point3& p) const {
    return up[kX] * p[kX] + up[kY] * p[kY] + up[kZ] * p[kZ];
  }
};

/// From above: X to the right, Y up.
inline constexpr Projection kFromAbove{{1, 0, 0}, {0, 1, 0}};
/// As a lathe is drawn: Z to the right, X up.
inline constexpr Projection kLathe{{0, 0, 1}, {1, 0, 0}};
/// Isometric from the front right: X to the lower right, Y to the upper right, Z up, all three in
/// the same scale.
inline constexpr double kCos30 = 0.8660254037844386;
inline constexpr Projection kIsometric{{kCos30, kCos30, 0}, {-0.5, 0.5, 1}};

/// A box as seen: its width and height on paper, in millimetres.
[[nodiscard]] Point seen_size(const Projection& projection, const Box3& box);

/// Puts space on the sheet: a projection, a scale, and the frame of the picture.
class View {
 public:
  /// Shows `box` as large as fits into `inside`, in its middle, with equal scale in all directions.
  View(const Projection& projection, const Box3& box, const Rect& frame, const Rect& inside);

  [[nodiscard]] Point map(const Point3& p) const {
    const Point3 from_middle = p - middle_;
    return {at_.x + scale_ * projection_.to_right(from_middle),
            at_.y - scale_ * projection_.upward(from_middle)};
  }
  [[nodiscard]] const Rect& frame() const { return frame_; }
  [[nodiscard]] double scale() const { return scale_; }  ///< pixels per mm

  /// The millimetres that a projection along two axes shows at the edges of the frame.
  [[nodiscard]] double left_mm() const { return horizontal_at(frame_.left); }
  [[nodiscard]] double right_mm() const { return horizontal_at(frame_.right()); }
  [[nodiscard]] double bottom_mm() const { return vertical_at(frame_.bottom()); }
  [[nodiscard]] double top_mm() const { return vertical_at(frame_.top); }
  /// Where such a projection shows a coordinate.
  [[nodiscard]] double x_of(double mm) const {
    return at_.x + scale_ * (mm - projection_.to_right(middle_));
  }
  [[nodiscard]] double y_of(double mm) const {
    return at_.y - scale_ * (mm - projection_.upward(middle_));
  }

 private:
  [[nodiscard]] double horizontal_at(double x) const {
    return projection_.to_right(middle_) + (x - at_.x) / scale_;
  }
  [[nodiscard]] double vertical_at(double y) const {
    return projection_.upward(middle_) - (y - at_.y) / scale_;
  }

  Projection projection_;
  Rect frame_;
  Point3 middle_{};  // of the box
  Point at_;         // where the middle is shown
  double scale_ = 1;
};

/// The part of a segment inside of a rectangle, if any.
[[nodiscard]] std::optional<std::pair<Point, Point>> clipped(Point from, Point to,
                                                             const Rect& rect);

}  // namespace kerf::output::plot
