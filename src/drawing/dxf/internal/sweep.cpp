#include "drawing/dxf/internal/sweep.hpp"

#include <cmath>
#include <numbers>

namespace kerf::drawing::dxf {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kSameAngle = 1e-6;

/// As fmod, but within [0, turn), and next to a turn all of it.
double part_of_turn(double angle, double turn, double same) {
  double part = std::fmod(angle, turn);
  if (part < 0) part += turn;
  return part <= same || part >= turn - same ? turn : part;
}

}  // namespace

bool Sweep::is_whole() const { return by_rad >= kTurn; }

Sweep sweep_of(double from_rad, double to_rad) {
  return {std::fmod(from_rad, kTurn), part_of_turn(to_rad - from_rad, kTurn, kSameAngle)};
}

// Reduced in degrees, where right angles are what they are.
Sweep sweep_of_degrees(double from_deg, double to_deg) {
  constexpr double kRadian = std::numbers::pi / 180;
  const double by = part_of_turn(to_deg - from_deg, 360, kSameAngle / kRadian);
  return {kRadian * std::fmod(from_deg, 360), by == 360 ? kTurn : kRadian * by};
}

}  // namespace kerf::drawing::dxf
