#include "kinematics/internal/x_theta_z.hpp"

#include <cmath>
#include <utility>

#include "geometry/angle.hpp"
#include "kinematics/deviation.hpp"
#include "kinematics/internal/axis_jet.hpp"
#include "kinematics/internal/polar.hpp"
#include "kinematics/internal/vocabulary.hpp"
#include "math/math.hpp"

namespace kerf::kinematics {
namespace {

constexpr Axis kTheta{1};  // of the joints, whose kX and kZ are those of the tip

constexpr double kNoRadius_mm = 1e-9;  // nearer to the axis θ is open

}  // namespace

XThetaZ::XThetaZ(std::vector<Joint> joints, const XThetaZOffsets& offsets)
    : Kinematics(std::move(joints), Turns{0, 360, 0}), offsets_(offsets) {}

TipPoint XThetaZ::forward(const JointPoint& joints) const {
  const double radius = joints[kX] + offsets_.x1_mm;
  const auto [sine, cosine] = geometry::sine_cosine_deg(joints[kTheta] + offsets_.theta0_deg);
  return TipPoint{{radius * cosine, radius * sine, joints[kZ] + offsets_.z0_mm}};
}

Result<JointPoint> XThetaZ::solve(const TipPoint& tip, const JointPoint& previous,
                                  Branch /*branch*/) const {
  const auto [radius, bearing_deg] = polar(tip[kX], tip[kY]);
  const double z = tip[kZ] - offsets_.z0_mm;
  if (radius < kNoRadius_mm) return JointPoint{{0 - offsets_.x1_mm, previous[kTheta], z}};
  const double theta_deg =
      geometry::nearest_turn(bearing_deg - offsets_.theta0_deg, previous[kTheta]);
  return JointPoint{{radius - offsets_.x1_mm, theta_deg, z}};
}

Result<JointJet> XThetaZ::along(const TipJet& tip, const JointPoint& joints) const {
  JointJet result{joints, tip.first, tip.second, tip.third};
  if (stands(tip, kX) && stands(tip, kY)) return result;  // also on the axis
  if (math::hypot(tip.value[kX], tip.value[kY]) < kNoRadius_mm) {
    return base::unexpected(
        Fault{Fault::Kind::singular,
              "the tip is on the axis of the work, where no angle of it is determined"});
  }
  const auto [radius, bearing_deg] = polar(jet_of(tip, kX), jet_of(tip, kY));
  set_jet(result, kX, radius);  // constant offsets change no derivative
  set_jet(result, kTheta, bearing_deg);
  result.value = joints;
  return result;
}

geometry::Vec3 XThetaZ::tip_rates(const JointPoint& joints, const AxisVector& rates) const {
  const auto [sine, cosine] = geometry::sine_cosine_deg(joints[kTheta] + offsets_.theta0_deg);
  const double across = (joints[kX] + offsets_.x1_mm) * geometry::radians(rates[kTheta]);
  return {rates[kX] * cosine - across * sine, rates[kX] * sine + across * cosine, rates[kZ]};
}

double XThetaZ::swing_bound_mm(const JointPoint& joints, const AxisVector& rates) const {
  return 8 * polar_deviation_mm(std::fabs(joints[kX] + offsets_.x1_mm), rates[kX], rates[kTheta]);
}

}  // namespace kerf::kinematics
