#pragma once

#include <array>
#include <cstdint>

#include "base/path_jet.hpp"
#include "base/point.hpp"
#include "motion/axis_norms.hpp"
#include "motion/face_map.hpp"

namespace kerf::motion {

/// A circle in space that its parameter runs around, with everything else linear in it:
///
///   P(s) = origin + slope s + (radius + radius_slope s) (e1 cos φ + e2 sin φ),  φ = angle + rate s
///
/// mm and degrees; φ, `angle` in radians, `rate` in radians per mm. e1 and e2 are perpendicular
/// unit vectors of linear axes.
struct ArcShape {
  base::AxisVector origin, slope, e1, e2;
  double radius = 0;
  double radius_slope = 0;
  double angle_rad = 0;
  double rate = 0;
};

/// A smooth piece of the path by its parameter s in [0, length()]: the length that the feed counts,
/// in mm, or in degrees when only rotary axes move. Every point comes from the equation, and the
/// end is exactly the one that was given. Value type, no allocation.
class Curve {
 public:
  Curve() = default;

  /// From `from` to `to` in proportion to s. length > 0.
  static Curve line(const base::TipPoint& from, const base::TipPoint& to, double length,
                    std::size_t axes);
  /// The polynomial of degree 5 that leaves the first jet and arrives in the second with the same
  /// first and second derivatives; what they say of the third is not asked. length > 0.
  static Curve hermite(const base::TipJet& from, const base::TipJet& to, double length,
                       std::size_t axes);
  /// The polynomial of degree 3 that leaves the first jet and arrives in the second with the same
  /// first derivatives. Between lines, with the length of the lines that it replaces, a parabola.
  static Curve cubic(const base::TipJet& from, const base::TipJet& to, double length,
                     std::size_t axes);
  static Curve arc(const ArcShape& shape, const base::TipPoint& to, double length,
                   std::size_t axes);

  /// A line or arc in the plane of a face, on the machine: of `flat` the map's two axes count mm in
  /// that plane. `to` is its end on the machine.
  static Curve on_face(const Curve& flat, const FaceMap& map, const base::TipPoint& to);

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] const base::TipPoint& end() const { return end_; }
  [[nodiscard]] bool is_line() const { return kind_ == Kind::line && !on_face_; }
  [[nodiscard]] bool is_arc() const { return kind_ == Kind::arc && !on_face_; }
  [[nodiscard]] bool is_on_face() const { return on_face_; }
  [[nodiscard]] bool is_cubic() const { return kind_ == Kind::cubic; }
  /// Precondition: is_arc().
  [[nodiscard]] ArcShape arc_shape() const {
    return {c_[0], c_[1], c_[2], c_[3], radius_, radius_slope_, angle_rad_, rate_};
  }
  /// Largest of the numbers whose sum a point is, as far as the end does not show it: of an arc its
  /// radius, whose last digits are what a flat one of huge radius shows.
  [[nodiscard]] double magnitude() const { return length_ + radius_; }
  /// The angle of an arc times its first radius: its length, if the radius stays. length() of
  /// everything else.
  [[nodiscard]] double length_at_first_radius() const;

  /// Real-time safe. s outside of [0, length()] is the caller's bug but for rounding.
  [[nodiscard]] base::TipPoint at(double s) const;
  [[nodiscard]] base::TipJet jet(double s) const;
  /// The first derivative alone, the same bits.
  [[nodiscard]] base::AxisVector rate(double s) const;
  /// Of a cubic: its rate is everywhere a mean, by weights that add up to 1, of that at its begin,
  /// this vector, and that at its end.
  [[nodiscard]] base::AxisVector rate_between() const;
  /// Upper bounds over [from, to]; the third derivative of a line and the second one are 0.
  [[nodiscard]] CurveBounds bounds(double from, double to) const;
  /// Upper bound over [from, to] of the second derivative's length in the axes that count mm: the
  /// curvature, where the parameter is the length. `bounds` are those over [from, to].
  [[nodiscard]] double curvature_bound(double from, double to, const CurveBounds& bounds,
                                       const LinearAxes& linear) const;

 private:
  enum class Kind : std::uint8_t { line, cubic, quintic, arc };

  Curve(Kind kind, const base::TipPoint& end, double length, std::size_t axes);

  [[nodiscard]] base::TipPoint point(double s) const;
  [[nodiscard]] base::TipJet own_jet(double s) const;
  [[nodiscard]] FlatBounds flat_bounds(double from, double to) const;
  [[nodiscard]] CurveBounds own_bounds(double from, double to) const;
  template <std::size_t count>
  [[nodiscard]] std::array<double, count> coefficients(std::size_t axis) const;
  template <std::size_t count>
  [[nodiscard]] base::TipJet polynomial_jet(double s) const;
  [[nodiscard]] base::TipJet arc_jet(double s) const;
  template <std::size_t count>
  [[nodiscard]] CurveBounds polynomial_bounds(double from, double to) const;
  [[nodiscard]] CurveBounds arc_bounds(double from, double to) const;
  [[nodiscard]] double largest_radius(double from, double to) const;

  Kind kind_ = Kind::line;
  std::uint8_t axes_ = 0;
  bool on_face_ = false;
  double length_ = 0;
  double radius_ = 0;
  double radius_slope_ = 0;
  double angle_rad_ = 0;
  double rate_ = 0;
  base::TipPoint end_;
  FaceMap map_;  // on a face: everything else is of the curve in its plane
  // line: point and slope; cubic, quintic: coefficients; arc: origin, slope, e1, e2.
  std::array<base::AxisVector, 6> c_{};
};

}  // namespace kerf::motion
