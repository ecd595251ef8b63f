#include "planner/chord.hpp"

#include <cmath>
#include <limits>

#include "geometry/arc.hpp"
#include "math/math.hpp"

namespace kerf::planner {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

}  // namespace

// Without the difference of two large numbers: R - x = (R² - x²) / (R + x).
double chord_deviation_mm(double radius_mm, double chord_mm) {
  const double half = chord_mm / 2;
  const double to_chord = std::sqrt((radius_mm - half) * (radius_mm + half));
  return half * half / (radius_mm + to_chord);
}

double step_deviation_mm(double radius_mm, double step_mm) {
  const double s = math::sin(step_mm / (4 * radius_mm));
  return 2 * radius_mm * s * s;
}

double longest_chord_mm(double radius_mm, double deviation_mm) {
  if (radius_mm <= deviation_mm) return kNoLimit;
  return 2 * std::sqrt(deviation_mm * (2 * radius_mm - deviation_mm));
}

double longest_step_mm(double radius_mm, double deviation_mm) {
  if (radius_mm <= deviation_mm) return kNoLimit;
  return radius_mm * geometry::chord_angle_rad(radius_mm, deviation_mm);
}

double chord_feed_mm_s(double radius_mm, double deviation_mm, double period_s) {
  return longest_chord_mm(radius_mm, deviation_mm) / period_s;
}

double step_feed_mm_s(double radius_mm, double deviation_mm, double period_s) {
  return longest_step_mm(radius_mm, deviation_mm) / period_s;
}

}  // namespace kerf::planner
