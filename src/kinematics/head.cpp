#include "kinematics/internal/head.hpp"

#include <cmath>
#include <utility>

#include "geometry/angle.hpp"
#include "geometry/vec3.hpp"
#include "kinematics/deviation.hpp"

namespace kerf::kinematics {
namespace {

using base::Axis;
using base::AxisVector;
using geometry::nearest_turn;
using geometry::radians;
using geometry::sine_cosine_deg;
using geometry::SineCosine;
using geometry::Vec3;

// Of tip and joints alike; X Y Z are the first three.
constexpr Axis kA{3};
constexpr Axis kC{4};

AxisVector raised(Vec3 v) { return {{v.x, v.y, v.z}}; }

/// Carriage minus focus, o(a, c), and its partial derivatives by radians.
struct Offset {
  Vec3 value, by_a, by_c, by_aa, by_ac, by_cc;
};

Offset offset_at(const HeadRadii& radii, double a_deg, double c_deg) {
  const auto [sa, ca] = sine_cosine_deg(a_deg);
  const auto [sc, cc] = sine_cosine_deg(c_deg);
  const double ra = radii.r_a_mm;
  const double rc = radii.r_c_mm;
  Offset o;
  o.value = {ra * sa * sc - rc * cc, -ra * sa * cc - rc * sc, ra * ca};
  o.by_a = {ra * ca * sc, -ra * ca * cc, -ra * sa};
  o.by_c = {ra * sa * cc + rc * sc, ra * sa * sc - rc * cc, 0};
  o.by_aa = {-ra * sa * sc, ra * sa * cc, -ra * ca};
  o.by_ac = {ra * ca * cc, ra * ca * sc, 0};
  o.by_cc = {-ra * sa * sc + rc * cc, ra * sa * cc + rc * sc, 0};
  return o;
}

/// Whether the joints hold the beam as the tip's own angles say, and not turned over.
bool as_programmed(const AxisVector& tip, const AxisVector& joints) {
  return sine_cosine_deg(joints[kC] - tip[kC]).cosine > 0;
}

}  // namespace

Head::Head(std::vector<Joint> joints, const HeadRadii& radii)
    : Kinematics(std::move(joints), Turns{0, 0, 0, 360, 360}), radii_(radii) {}

AxisVector Head::carriage_offset(double a_deg, double c_deg) const {
  return raised(offset_at(radii_, a_deg, c_deg).value);
}

AxisVector Head::forward(const AxisVector& joints) const {
  return joints - carriage_offset(joints[kA], joints[kC]);
}

Branch Head::branch_at(const AxisVector& joints) const {
  return sine_cosine_deg(joints[kA]).sine >= 0 ? Branch::plus : Branch::minus;
}

Result<AxisVector> Head::follow(const AxisVector& tip, const AxisVector& /*previous*/) const {
  return tip + carriage_offset(tip[kA], tip[kC]);
}

Result<AxisVector> Head::solve(const AxisVector& tip, const AxisVector& previous,
                               Branch branch) const {
  AxisVector joints = tip;
  if (branch_at(tip) != branch) {
    joints[kA] = 0 - tip[kA];
    joints[kC] = tip[kC] + 180;
  }
  joints[kA] = nearest_turn(joints[kA], previous[kA]);
  joints[kC] = nearest_turn(joints[kC], previous[kC]);
  return joints + carriage_offset(joints[kA], joints[kC]);
}

Result<Derivatives> Head::derivatives(const AxisVector& tip, const AxisVector& joints,
                                      const AxisVector& first, const AxisVector& second) const {
  Derivatives result{first, second};
  if (!as_programmed(tip, joints)) {
    result.first[kA] = 0 - first[kA];
    result.second[kA] = 0 - second[kA];
  }
  const double a = radians(result.first[kA]);
  const double c = radians(result.first[kC]);
  const double a2 = radians(result.second[kA]);
  const double c2 = radians(result.second[kC]);
  const Offset o = offset_at(radii_, joints[kA], joints[kC]);
  result.first = result.first + raised(a * o.by_a + c * o.by_c);
  result.second = result.second + raised(a2 * o.by_a + c2 * o.by_c + (a * a) * o.by_aa +
                                         (2 * a * c) * o.by_ac + (c * c) * o.by_cc);
  return result;
}

double Head::deviation_bound_mm(const AxisVector& from, const AxisVector& to) const {
  return head_deviation_mm(radii_, to[kA] - from[kA], to[kC] - from[kC]);
}

}  // namespace kerf::kinematics
