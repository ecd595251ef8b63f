#include "kinematics/internal/arm.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/angle.hpp"
#include "geometry/vec2.hpp"
#include "kinematics/deviation.hpp"
#include "kinematics/internal/shown.hpp"

namespace kerf::kinematics {
namespace {

using base::Axis;
using base::AxisVector;
using geometry::degrees;
using geometry::nearest_turn;
using geometry::Vec2;

// Of the tip.
constexpr Axis kX{0};
constexpr Axis kY{1};
constexpr Axis kZ{2};
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

Vec2 plan(const AxisVector& tip) { return {tip[kX], tip[kY]}; }

Vec2 direction_deg(double angle_deg) {
  const auto [sine, cosine] = geometry::sine_cosine_deg(angle_deg);
  return {cosine, sine};
}

}  // namespace

Arm::Arm(std::vector<Joint> joints, const ArmLinks& links)
    : Kinematics(std::move(joints), Turns{360, 360, kHalfTurn_deg, 0}), links_(links) {}

Arm::Pose Arm::pose_at(const AxisVector& joints) const {
  const double forearm = joints[kForearm];
  const double upper = joints[kUpper];
  return links_.forearm_absolute ? Pose{upper, forearm, forearm - upper}
                                 : Pose{upper, upper + forearm, forearm};
}

AxisVector Arm::forward(const AxisVector& joints) const {
  const Pose pose = pose_at(joints);
  const Vec2 tip = links_.upper_arm_mm * direction_deg(pose.upper_deg) +
                   links_.forearm_mm * direction_deg(pose.forearm_deg);
  return {{tip.u, tip.v, joints[kLift], pose.forearm_deg + joints[kWheel]}};
}

Branch Arm::branch_at(const AxisVector& joints) const {
  const double sine = geometry::sine_cosine_deg(pose_at(joints).elbow_deg).sine;
  return sine >= 0 ? Branch::plus : Branch::minus;
}

std::optional<Fault> Arm::out_of_reach(const AxisVector& tip, double radius_mm) const {
  const double most = links_.upper_arm_mm + links_.forearm_mm;
  const double least = std::fabs(links_.upper_arm_mm - links_.forearm_mm);
  if (radius_mm <= most + kReachTolerance_mm && radius_mm >= least - kReachTolerance_mm) return {};
  return Fault{Fault::Kind::out_of_reach, "the tip X" + shown(tip[kX]) + " Y" + shown(tip[kY]) +
                                              " is " + shown(radius_mm) +
                                              " mm from the shoulder; the arm reaches from " +
                                              shown(least) + " to " + shown(most) + " mm"};
}

// With r the distance from the shoulder and d = L2 - L1, s = L2 + L1 the least and the most of it,
// the half angle of the elbow has the tangent √(s²-r²)/√(r²-d²): written in factors this is as
// exact where the arm is stretched or folded as elsewhere, which an arc cosine is not.
Result<AxisVector> Arm::solve(const AxisVector& tip, const AxisVector& previous,
                              Branch branch) const {
  const double distance = length(plan(tip));
  if (auto fault = out_of_reach(tip, distance)) return base::unexpected(*std::move(fault));
  const bool folded = distance < kFolded_mm;
  const double r = folded ? 0 : distance;
  const double s = links_.upper_arm_mm + links_.forearm_mm;
  const double d = links_.upper_arm_mm - links_.forearm_mm;
  const double stretch = std::sqrt(std::max(0.0, (r - d) * (r + d)));
  const double fold = std::sqrt(std::max(0.0, (s - r) * (s + r)));
  const double side = branch == Branch::plus ? 1 : -1;
  const double elbow_deg = side * degrees(2 * std::atan2(fold, stretch));
  // From the upper arm to the line between shoulder and tip.
  const double inner_deg = side * degrees(std::atan2(fold * stretch, r * r + d * s));

  const double upper_deg =
      folded ? previous[kUpper]
             : nearest_turn(degrees(std::atan2(tip[kY], tip[kX])) - inner_deg, previous[kUpper]);
  const double from_deg = links_.forearm_absolute ? upper_deg : 0;
  const double forearm_deg = nearest_turn(from_deg + elbow_deg, previous[kForearm]);
  const double heading_deg = links_.forearm_absolute ? forearm_deg : upper_deg + forearm_deg;
  const double wheel_deg =
      nearest_turn(tip[kHeading] - heading_deg, previous[kWheel], kHalfTurn_deg);
  return AxisVector{{forearm_deg, upper_deg, wheel_deg, tip[kZ]}};
}

Result<Derivatives> Arm::derivatives(const AxisVector& /*tip*/, const AxisVector& joints,
                                     const AxisVector& first, const AxisVector& second) const {
  const Pose pose = pose_at(joints);
  const double sine = geometry::sine_cosine_deg(pose.elbow_deg).sine;
  if (std::fabs(sine) < kSingularSine) {
    return base::unexpected(Fault{Fault::Kind::singular, in_words(pose)});
  }
  const Vec2 upper = direction_deg(pose.upper_deg);
  const Vec2 forearm = direction_deg(pose.forearm_deg);
  // A link turns across itself, so along the one link only the other one moves the tip.
  const auto rates = [&](Vec2 tip) {
    return Vec2{dot(tip, forearm) / (links_.upper_arm_mm * sine),
                -dot(tip, upper) / (links_.forearm_mm * sine)};
  };
  const Vec2 turn = rates(plan(first));  // rad per mm: upper arm, forearm, both from +X
  const Vec2 turn2 = rates(plan(second) + (links_.upper_arm_mm * turn.u * turn.u) * upper +
                           (links_.forearm_mm * turn.v * turn.v) * forearm);
  const auto joint_rates = [&](Vec2 links, const AxisVector& tip) {
    const double upper_deg = degrees(links.u);
    const double forearm_deg = degrees(links.v);
    return AxisVector{{links_.forearm_absolute ? forearm_deg : forearm_deg - upper_deg, upper_deg,
                       tip[kHeading] - forearm_deg, tip[kZ]}};
  };
  return Derivatives{joint_rates(turn, first), joint_rates(turn2, second)};
}

double Arm::deviation_bound_mm(const AxisVector& from, const AxisVector& to) const {
  const Pose begin = pose_at(from);
  const Pose end = pose_at(to);
  return arm_deviation_mm(links_, end.upper_deg - begin.upper_deg,
                          end.forearm_deg - begin.forearm_deg);
}

std::optional<std::string> Arm::caution(const AxisVector& joints) const {
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
