#include "kinematics/internal/arm.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/angle.hpp"
#include "geometry/vec2.hpp"
#include "kinematics/deviation.hpp"
#include "kinematics/internal/axis_jet.hpp"
#include "kinematics/internal/polar.hpp"
#include "kinematics/internal/shown.hpp"
#include "kinematics/internal/vocabulary.hpp"
#include "math/math.hpp"

namespace kerf::kinematics {
namespace {

using geometry::nearest_turn;
using geometry::Vec2;

// Of the tip, besides kX, kY and kZ.
constexpr Axis kHeading{3};
// Of the joints.
constexpr Axis kForearm{0};
constexpr Axis kUpper{1};
constexpr Axis kWheel{2};
constexpr Axis kLift{3};

constexpr double kReachTolerance_mm = 1e-9;
constexpr double kFolded_mm = 1e-9;     // nearer to the shoulder the upper arm's angle is open
constexpr double kSingularSine = 1e-6;  // of the elbow: rates of the joints are not determined
constexpr double kCautionSine = 0.05;   // of the elbow: rates are large
constexpr double kHalfTurn_deg = 180;   // after which the wheel is the same

Vec2 direction_deg(double angle_deg) {
  const auto [sine, cosine] = geometry::sine_cosine_deg(angle_deg);
  return {cosine, sine};
}

/// The turning joints, degrees, each on any turn. Number is double or Jet.
template <typename Number>
struct Angles {
  Number forearm, upper, wheel;
};

/// The joints that hold the tip at `at`, the elbow on the side of `sign`, ±1. Precondition: `at` is
/// within reach; for jets the arm is neither stretched nor folded.
///
/// With r the distance from the shoulder and d = L2 - L1, s = L2 + L1 the least and the most of it,
/// the half angle of the elbow has the tangent √(s²-r²)/√(r²-d²): written in factors this is as
/// exact where the arm is stretched or folded as elsewhere, which an arc cosine is not.
template <typename Number>
Angles<Number> angles_at(const ArmLinks& links, const Polar<Number>& at, const Number& heading_deg,
                         double sign) {
  using geometry::degrees;
  using math::atan2;
  using std::sqrt;
  const double s = links.upper_arm_mm + links.forearm_mm;
  const double d = links.upper_arm_mm - links.forearm_mm;
  const Number& r = at.radius;
  const Number stretch = sqrt((r - d) * (r + d));
  const Number fold = sqrt((s - r) * (r + s));
  const Number elbow_deg = sign * degrees(2 * atan2(fold, stretch));
  // From the upper arm to the line between shoulder and tip.
  const Number inner_deg = sign * degrees(atan2(fold * stretch, r * r + d * s));
  const Number upper_deg = at.bearing_deg - inner_deg;
  const Number forearm_deg = upper_deg + elbow_deg;
  return {links.forearm_absolute ? forearm_deg : elbow_deg, upper_deg, heading_deg - forearm_deg};
}

double sign_of(Branch branch) { return branch == Branch::plus ? 1 : -1; }

}  // namespace

Arm::Arm(std::vector<Joint> joints, const ArmLinks& links)
    : Kinematics(std::move(joints), Turns{360, 360, kHalfTurn_deg, 0}), links_(links) {}

Arm::Pose Arm::pose_at(const AxisVector& joints) const {
  const double forearm = joints[kForearm];
  const double upper = joints[kUpper];
  return links_.forearm_absolute ? Pose{upper, forearm, forearm - upper}
                                 : Pose{upper, upper + forearm, forearm};
}

TipPoint Arm::forward(const JointPoint& joints) const {
  const Pose pose = pose_at(joints);
  const Vec2 tip = links_.upper_arm_mm * direction_deg(pose.upper_deg) +
                   links_.forearm_mm * direction_deg(pose.forearm_deg);
  return TipPoint{{tip.u, tip.v, joints[kLift], pose.forearm_deg + joints[kWheel]}};
}

Branch Arm::branch_at(const JointPoint& joints) const {
  const double sine = geometry::sine_cosine_deg(pose_at(joints).elbow_deg).sine;
  const bool minus = sine < 0 || (sine == 0 && links_.elbow_minus);
  return minus ? Branch::minus : Branch::plus;
}

std::optional<Fault> Arm::out_of_reach(const TipPoint& tip, double radius_mm) const {
  const double most = links_.upper_arm_mm + links_.forearm_mm;
  const double least = std::fabs(links_.upper_arm_mm - links_.forearm_mm);
  if (radius_mm <= most + kReachTolerance_mm && radius_mm >= least - kReachTolerance_mm) return {};
  return Fault{Fault::Kind::out_of_reach, "the tip X" + shown(tip[kX]) + " Y" + shown(tip[kY]) +
                                              " is " + shown(radius_mm) +
                                              " mm from the shoulder; the arm reaches from " +
                                              shown(least) + " to " + shown(most) + " mm"};
}

Result<JointPoint> Arm::solve(const TipPoint& tip, const JointPoint& previous,
                              Branch branch) const {
  Polar<double> at = polar(tip[kX], tip[kY]);
  if (auto fault = out_of_reach(tip, at.radius)) return base::unexpected(*std::move(fault));
  if (at.radius < kFolded_mm) at = {0, previous[kUpper]};
  at.radius = std::clamp(at.radius, std::fabs(links_.upper_arm_mm - links_.forearm_mm),
                         links_.upper_arm_mm + links_.forearm_mm);
  const auto [forearm, upper, wheel] = angles_at(links_, at, tip[kHeading], sign_of(branch));
  return JointPoint{{nearest_turn(forearm, previous[kForearm]),
                     nearest_turn(upper, previous[kUpper]),
                     nearest_turn(wheel, previous[kWheel], kHalfTurn_deg), tip[kZ]}};
}

Result<JointJet> Arm::along(const TipJet& tip, const JointPoint& joints) const {
  if (stands(tip, kX) && stands(tip, kY)) return lifting(tip, joints);
  const Pose pose = pose_at(joints);
  const double sine = geometry::sine_cosine_deg(pose.elbow_deg).sine;
  if (std::fabs(sine) < kSingularSine) {
    return base::unexpected(Fault{Fault::Kind::singular, in_words(pose)});
  }
  const auto [forearm, upper, wheel] = angles_at(links_, polar(jet_of(tip, kX), jet_of(tip, kY)),
                                                 jet_of(tip, kHeading), sine >= 0 ? 1 : -1);
  JointJet result;
  set_jet(result, kForearm, forearm);
  set_jet(result, kUpper, upper);
  set_jet(result, kWheel, wheel);
  set_jet(result, kLift, jet_of(tip, kZ));
  result.value = joints;
  return result;
}

// The links stand, also where no rates are determined for other moves.
JointJet Arm::lifting(const TipJet& tip, const JointPoint& joints) {
  JointJet result;
  set_jet(result, kWheel, jet_of(tip, kHeading));
  set_jet(result, kLift, jet_of(tip, kZ));
  result.value = joints;
  return result;
}

// The angles of the links are linear in those of the joints.
geometry::Vec3 Arm::tip_rates(const JointPoint& joints, const AxisVector& rates) const {
  const Pose pose = pose_at(joints);
  const Pose turn = pose_at(rates);
  const Vec2 upper =
      (links_.upper_arm_mm * geometry::radians(turn.upper_deg)) * direction_deg(pose.upper_deg);
  const Vec2 forearm =
      (links_.forearm_mm * geometry::radians(turn.forearm_deg)) * direction_deg(pose.forearm_deg);
  const Vec2 both = upper + forearm;  // turned by a right angle it is the way of the tip
  return {-both.v, both.u, rates[kLift]};
}

double Arm::swing_bound_mm(const JointPoint& /*joints*/, const AxisVector& rates) const {
  const Pose turn = pose_at(rates);
  return 8 * arm_deviation_mm(links_, turn.upper_deg, turn.forearm_deg);
}

std::optional<std::string> Arm::caution(const JointPoint& joints) const {
  const Pose pose = pose_at(joints);
  if (std::fabs(geometry::sine_cosine_deg(pose.elbow_deg).sine) >= kCautionSine) return {};
  return in_words(pose);
}

std::string Arm::in_words(const Pose& pose) const {
  const bool stretched = geometry::sine_cosine_deg(pose.elbow_deg).cosine > 0;
  return std::string(stretched ? "the arm is stretched out" : "the arm is folded onto itself") +
         " (elbow at " + shown(pose.elbow_deg) +
         " degrees): the joints turn far for small moves of the tip";
}

}  // namespace kerf::kinematics
