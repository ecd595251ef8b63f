#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/vec2.hpp"

namespace kerf::drawing {

using geometry::Vec2;
struct Ellipse;
struct Weighted;

/// A line or an arc on from where the one before ended; the bulge is that of contour::Edge.
struct Step {
  Vec2 to;
  double bulge = 0;
};

/// Curves become lines and arcs, with their ends and tangents. A curve is parted where its
/// curvature is 0 or has an extreme, in theory's proven places (internal/bernstein.hpp). Between
/// them its curvature is monotone, and it lies between the two arcs through its ends that touch it
/// at one end each (Vogt's theorem; A. Kurnosenko, "Biarcs and bilens", Comput. Aided Geom. Des.
/// 30, 2013), and so does its biarc: how far these arcs are apart bounds the error everywhere.
/// Parted in halves until that is no more than `tolerance`, mm.
struct Fit {
  std::vector<Step>& steps;  ///< to which is appended
  double tolerance = 0.01;
  double error = 0;  ///< the largest bound that was used
};

/// A curve about zero whose distance from there is a cubic of the angle: these are its coefficients
/// as of a Bezier curve, mm.
struct Polar {
  std::array<double, 4> radii{};
  double from_rad = 0;
  double to_rad = 0;  ///< another one

  [[nodiscard]] Vec2 end() const {
    return {radii[3] * math::cos(to_rad), radii[3] * math::sin(to_rad)};
  }
};

/// What is no farther from its chord is a line, mm.
inline constexpr double kStraight_mm = 1e-6;

void fit_cubic(const std::array<Vec2, 4>& points, Fit& fit);
/// Degree points.size() - 1 from 1 to 10; weights > 0.
void fit_rational(std::span<const Weighted> points, Fit& fit);
void fit_polar(const Polar& curve, Fit& fit);
/// As Pen::ellipse().
void fit_ellipse(const Ellipse& ellipse, double from_rad, double sweep_rad, Fit& fit);

}  // namespace kerf::drawing
