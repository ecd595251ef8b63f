#include "stock/field/torus_slope.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::stock::field {
namespace {

/// Where an arc about (core, z) in the section of a tool is met along a way.
class ArcSlope {
 public:
  ArcSlope(const EnvelopePiece& piece, double slope, double across2)
      : piece_(piece), slope_(slope), across2_(across2) {}

  /// The surface rises along x here faster than the way does.
  [[nodiscard]] bool rises_at(double x) const {
    const double s = std::sqrt(across2_ + x * x);
    if (s < piece_.s0) return x > 0 && slope_ == 0;
    const double out = s - piece_.core;
    return out * x > slope_ * s * half_chord(piece_.radius * piece_.radius - out * out);
  }
  /// Between a step at which it does not and one at which it does, by halving the height above the
  /// centre, which near the steep end of the arc changes more than x does.
  [[nodiscard]] double lowest(double first, double last) const {
    double falls = depth_at(first);
    double rises = depth_at(last);
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (falls + rises) / 2;
      (rises_at(step_at(middle, first, last)) ? rises : falls) = middle;
    }
    return step_at((falls + rises) / 2, first, last);
  }

 private:
  static constexpr int kHalvings = 40;

  static double half_chord(double squared) { return std::sqrt(std::max(0.0, squared)); }

  [[nodiscard]] double depth_at(double x) const {
    const double s = std::max(piece_.s0, std::sqrt(across2_ + x * x));
    const double out = s - piece_.core;
    return half_chord(piece_.radius * piece_.radius - out * out);
  }
  [[nodiscard]] double step_at(double depth, double first, double last) const {
    const double s = piece_.core + half_chord(piece_.radius * piece_.radius - depth * depth);
    return std::clamp(half_chord(s * s - across2_), first, last);
  }

  const EnvelopePiece& piece_;
  double slope_;
  double across2_;
};

}  // namespace

float torus_slope_low(const EnvelopePiece& piece, const TorusColumn& at) {
  const auto across = static_cast<double>(at.across2);
  const ArcSlope arc(piece, static_cast<double>(at.slope), across);
  auto x = static_cast<double>(at.last);
  if (x > 0 && arc.rises_at(x)) {
    const double from = std::max(static_cast<double>(at.first), 0.0);
    x = arc.rises_at(from) ? from : arc.lowest(from, x);
  }
  const float tip = at.z + at.slope * (at.along - static_cast<float>(x));
  return tip + static_cast<float>(piece.at(std::sqrt(across + x * x)));
}

}  // namespace kerf::stock::field
