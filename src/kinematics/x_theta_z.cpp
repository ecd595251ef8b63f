#include "kinematics/internal/x_theta_z.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/angle.hpp"
#include "geometry/vec2.hpp"
#include "kinematics/deviation.hpp"

namespace kerf::kinematics {
namespace {

using base::Axis;
using base::AxisVector;
using geometry::degrees;
using geometry::Vec2;

constexpr Axis kX{0};      // of tip and joints
constexpr Axis kY{1};      // of the tip
constexpr Axis kTheta{1};  // of the joints
constexpr Axis kZ{2};      // of both

constexpr double kNoRadius_mm = 1e-9;  // nearer to the axis θ is open

Vec2 plan(const AxisVector& tip) { return {tip[kX], tip[kY]}; }

}  // namespace

XThetaZ::XThetaZ(std::vector<Joint> joints, const XThetaZOffsets& offsets)
    : Kinematics(std::move(joints), Turns{0, 360, 0}), offsets_(offsets) {}

AxisVector XThetaZ::forward(const AxisVector& joints) const {
  const double radius = joints[kX] + offsets_.x1_mm;
  const auto [sine, cosine] = geometry::sine_cosine_deg(joints[kTheta] + offsets_.theta0_deg);
  return {{radius * cosine, radius * sine, joints[kZ] + offsets_.z0_mm}};
}

Result<AxisVector> XThetaZ::solve(const AxisVector& tip, const AxisVector& previous,
                                  Branch /*branch*/) const {
  const double r = length(plan(tip));
  const bool on_axis = r < kNoRadius_mm;
  const double theta_deg =
      on_axis ? previous[kTheta]
              : geometry::nearest_turn(degrees(std::atan2(tip[kY], tip[kX])) - offsets_.theta0_deg,
                                       previous[kTheta]);
  const double radius = on_axis ? 0 : r;
  return AxisVector{{radius - offsets_.x1_mm, theta_deg, tip[kZ] - offsets_.z0_mm}};
}

Result<Derivatives> XThetaZ::derivatives(const AxisVector& tip, const AxisVector& /*joints*/,
                                         const AxisVector& first, const AxisVector& second) const {
  const Vec2 p = plan(tip);
  const double radius = length(p);
  if (radius < kNoRadius_mm) {
    return base::unexpected(
        Fault{Fault::Kind::singular,
              "the tip is on the axis of the work, where no angle of it is determined"});
  }
  // In the frame that turns with p: along it the radius grows, across it the angle.
  const Vec2 along = (1 / radius) * p;
  const double radial = dot(along, plan(first));
  const double turn = cross(along, plan(first)) / radius;
  const double radial2 = dot(along, plan(second)) + radius * turn * turn;
  const double turn2 = (cross(along, plan(second)) - 2 * radial * turn) / radius;
  return Derivatives{{{radial, degrees(turn), first[kZ]}}, {{radial2, degrees(turn2), second[kZ]}}};
}

double XThetaZ::deviation_bound_mm(const AxisVector& from, const AxisVector& to) const {
  const double radius =
      std::max(std::fabs(from[kX] + offsets_.x1_mm), std::fabs(to[kX] + offsets_.x1_mm));
  return polar_deviation_mm(radius, to[kX] - from[kX], to[kTheta] - from[kTheta]);
}

}  // namespace kerf::kinematics
