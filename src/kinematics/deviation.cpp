#include "kinematics/deviation.hpp"

#include <cmath>

#include "geometry/angle.hpp"

namespace kerf::kinematics {

using geometry::radians;

namespace {

// The second derivative of a tip that goes out by x and across by w is w √(w² + 4x²) / r, which is
// 2/√3 of (x² + w²) / r at most.
constexpr double kMostOfSquare = 1.1547005383792517;

}  // namespace

// Linear interpolation is off by at most an eighth of the largest second derivative over the step.

double head_deviation_mm(const HeadRadii& radii, double delta_a_deg, double delta_c_deg) {
  const double a = std::fabs(radians(delta_a_deg));
  const double c = std::fabs(radians(delta_c_deg));
  return (std::fabs(radii.r_a_mm) * (a + c) * (a + c) + std::fabs(radii.r_c_mm) * c * c) / 8;
}

double polar_deviation_mm(double radius_mm, double delta_x_mm, double delta_theta_deg) {
  const double across_mm = radius_mm * radians(delta_theta_deg);
  const double square = delta_x_mm * delta_x_mm + across_mm * across_mm;
  return square == 0 ? 0 : kMostOfSquare * square / (8 * radius_mm);
}

double arm_deviation_mm(const ArmLinks& links, double delta_upper_deg, double delta_forearm_deg) {
  const double upper = radians(delta_upper_deg);
  const double forearm = radians(delta_forearm_deg);
  return (links.upper_arm_mm * upper * upper + links.forearm_mm * forearm * forearm) / 8;
}

double arm_rounding_mm(const ArmLinks& links, double radius_mm, double off_deg) {
  return radians(off_deg) * (radius_mm + links.forearm_mm);
}

double sampling_deviation_mm(double step_mm, double radius_mm) {
  return step_mm * step_mm / (8 * radius_mm);
}

}  // namespace kerf::kinematics
