#include "kinematics/internal/head.hpp"

#include <cmath>
#include <utility>

#include "geometry/angle.hpp"
#include "geometry/jet.hpp"
#include "kinematics/deviation.hpp"
#include "kinematics/internal/axis_jet.hpp"
#include "kinematics/internal/vocabulary.hpp"

namespace kerf::kinematics {
namespace {

using geometry::Jet;
using geometry::nearest_turn;
using geometry::sine_cosine_deg;

// Of tip and joints alike, as kX, kY and kZ are.
constexpr Axis kA{3};
constexpr Axis kC{4};

/// Carriage minus focus. Number is double or Jet.
template <typename Number>
struct Offset {
  Number x, y, z;
};

template <typename Number>
Offset<Number> offset_at(const HeadRadii& radii, const Number& a_deg, const Number& c_deg) {
  const auto [sine_a, cosine_a] = sine_cosine_deg(a_deg);
  const auto [sine_c, cosine_c] = sine_cosine_deg(c_deg);
  const Number level = radii.r_a_mm * sine_a;
  return {level * sine_c - radii.r_c_mm * cosine_c, -(level * cosine_c) - radii.r_c_mm * sine_c,
          radii.r_a_mm * cosine_a};
}

/// Whether the joints hold the beam as the tip's own angles say, and not turned over.
bool as_programmed(const TipPoint& tip, const JointPoint& joints) {
  return std::fabs(nearest_turn(joints[kC] - tip[kC], 0)) < 90;
}

}  // namespace

Head::Head(std::vector<Joint> joints, const HeadRadii& radii)
    : Kinematics(std::move(joints), Turns{0, 0, 0, 360, 360}), radii_(radii) {}

AxisVector Head::carriage_offset(double a_deg, double c_deg) const {
  const auto [x, y, z] = offset_at(radii_, a_deg, c_deg);
  return {{x, y, z}};
}

TipPoint Head::forward(const JointPoint& joints) const {
  return TipPoint(joints.numbers() - carriage_offset(joints[kA], joints[kC]));
}

Branch Head::branch_at(const JointPoint& joints) const {
  return sine_cosine_deg(joints[kA]).sine >= 0 ? Branch::plus : Branch::minus;
}

Result<JointPoint> Head::follow(const TipPoint& tip, const JointPoint& /*previous*/) const {
  return JointPoint(tip.numbers() + carriage_offset(tip[kA], tip[kC]));
}

Result<JointPoint> Head::solve(const TipPoint& tip, const JointPoint& previous,
                               Branch branch) const {
  JointPoint joints(tip.numbers());  // the angles that the program says
  if (branch_at(joints) != branch) {
    joints[kA] = 0 - tip[kA];
    joints[kC] = tip[kC] + 180;
  }
  joints[kA] = nearest_turn(joints[kA], previous[kA]);
  joints[kC] = nearest_turn(joints[kC], previous[kC]);
  return joints + carriage_offset(joints[kA], joints[kC]);
}

Result<JointJet> Head::along(const TipJet& tip, const JointPoint& joints) const {
  Jet a_deg = jet_of(tip, kA);
  Jet c_deg = jet_of(tip, kC);
  if (!as_programmed(tip.value, joints)) a_deg = -a_deg;
  a_deg.value = joints[kA];
  c_deg.value = joints[kC];
  const auto [x, y, z] = offset_at(radii_, a_deg, c_deg);
  JointJet result{joints, tip.first, tip.second, tip.third};
  set_jet(result, kX, jet_of(tip, kX) + x);
  set_jet(result, kY, jet_of(tip, kY) + y);
  set_jet(result, kZ, jet_of(tip, kZ) + z);
  set_jet(result, kA, a_deg);
  result.value = joints;
  return result;
}

// The focus is the carriage without its offset.
geometry::Vec3 Head::tip_rates(const JointPoint& joints, const AxisVector& rates) const {
  const auto [sine_a, cosine_a] = sine_cosine_deg(joints[kA]);
  const auto [sine_c, cosine_c] = sine_cosine_deg(joints[kC]);
  const double tilt = radii_.r_a_mm * geometry::radians(rates[kA]);
  const double turn = geometry::radians(rates[kC]);
  const double level = radii_.r_a_mm * sine_a;
  return {
      rates[kX] - tilt * cosine_a * sine_c - turn * (level * cosine_c + radii_.r_c_mm * sine_c),
      rates[kY] + tilt * cosine_a * cosine_c - turn * (level * sine_c - radii_.r_c_mm * cosine_c),
      rates[kZ] + tilt * sine_a};
}

double Head::swing_bound_mm(const JointPoint& /*joints*/, const AxisVector& rates) const {
  return 8 * head_deviation_mm(radii_, rates[kA], rates[kC]);
}

}  // namespace kerf::kinematics
