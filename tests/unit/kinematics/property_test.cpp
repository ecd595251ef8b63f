// Properties of every kinematics over random tips and joints of its whole workspace.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "allocation_count.hpp"
#include "geometry/angle.hpp"
#include "kinematics/orientation.hpp"
#include "kinematics_machines.hpp"
#include "seeded_random.hpp"

namespace kerf::kinematics {
namespace {

using base::Axis;
using base::AxisVector;
using base::JointPoint;
using base::TipPoint;
using test::kSeed;
using test::SeededRandom;
using test::text;

constexpr int kCases = 100'000;
constexpr double kExact = 1e-9;  // mm, degrees

/// A machine, its random tips, and in what a tip must come back.
struct Subject {
  std::string name;
  Settings settings;
  std::function<TipPoint(SeededRandom&)> tip;
  double heading_turn_deg = 0;  ///< entry 3 of the tip counts modulo this, when not 0
};

/// A distance over the whole of [least, most], often very near to one of its ends.
double radius(SeededRandom& random, double least, double most) {
  switch (random.count(0, 3)) {
    case 0: return std::min(most, least + random.size(1e-12, most - least));
    case 1: return std::max(least, most - random.size(1e-12, most - least));
    default: return random.in(least, most);
  }
}

TipPoint tip_at(double radius_mm, double angle_rad, double z, double heading) {
  return {{radius_mm * std::cos(angle_rad), radius_mm * std::sin(angle_rad), z, heading}};
}

double any_angle_rad(SeededRandom& random) {
  return random.in(-std::numbers::pi, std::numbers::pi);
}

Subject arm(const std::string& name, double upper_mm, double forearm_mm, bool absolute) {
  Subject subject{name, test::arm_settings(), {}, 180};
  subject.settings.arm = {upper_mm, forearm_mm, absolute};
  subject.tip = [=](SeededRandom& random) {
    const double r = radius(random, std::fabs(upper_mm - forearm_mm), upper_mm + forearm_mm);
    return tip_at(r, any_angle_rad(random), random.in(-50, 50), random.in(-400, 400));
  };
  return subject;
}

Subject head(const std::string& name, const HeadRadii& radii) {
  Subject subject{name, test::head_settings(), {}};
  subject.settings.head = radii;
  subject.tip = [](SeededRandom& random) {
    const double a = random.coin() ? random.in(-180, 180) : 90.0 * random.count(-2, 2);
    return TipPoint{{random.in(-500, 500), random.in(-500, 500), random.in(-500, 500), a,
                     random.in(-1000, 1000)}};
  };
  return subject;
}

Subject x_theta_z(const std::string& name, const XThetaZOffsets& offsets) {
  Subject subject{name, test::x_theta_z_settings(), {}};
  subject.settings.x_theta_z = offsets;
  subject.tip = [](SeededRandom& random) {
    return tip_at(radius(random, 0, 500), any_angle_rad(random), random.in(-50, 50), 0);
  };
  return subject;
}

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all = {
      {"cartesian", test::cartesian_settings(),
       [](SeededRandom& random) {
         return TipPoint{{random.in(-500, 500), random.in(-500, 500), random.in(-500, 500),
                          random.in(-1000, 1000)}};
       }},
      x_theta_z("x_theta_z", {25, 10, 5}),
      x_theta_z("x_theta_z_other_signs", {-40, -75, -3}),
      head("head", {150, 80}),
      head("head_other_signs", {-110, 30}),
      arm("arm", 132, 132, false),
      arm("arm_absolute_forearm", 132, 132, true),
      arm("arm_long_upper", 200, 90, false),
      arm("arm_long_forearm", 90, 200.5, true),
  };
  return all;
}

class EveryKinematics : public testing::TestWithParam<std::size_t> {
 protected:
  const Subject& subject_ = subjects()[GetParam()];
  std::unique_ptr<const Kinematics> machine_ = test::make(subject_.settings);

  JointPoint random_joints(SeededRandom& random) const {
    JointPoint joints;
    for (std::size_t i = 0; i < machine_->size(); ++i) {
      const bool rotary = machine_->joints()[i].rotary;
      joints.values[i] = rotary ? random.in(-400, 400) : random.in(-300, 300);
    }
    return joints;
  }

  /// Largest difference of two tips, mm or degrees.
  double difference(const TipPoint& tip, const AxisVector& other) const {
    AxisVector off = tip - other;
    if (const double turn = subject_.heading_turn_deg; turn != 0) {
      off.values[3] = geometry::nearest_turn(off.values[3], 0, turn);
    }
    double most = 0;
    for (const double value : off.values) most = std::max(most, std::fabs(value));
    return most;
  }
  /// Distance in space alone.
  static double distance(const TipPoint& tip, const AxisVector& other) {
    const AxisVector off = tip - other;
    return std::hypot(off.values[0], off.values[1], off.values[2]);
  }
  template <typename Frame>
  static base::Point<Frame> between(const base::Point<Frame>& from, const base::Point<Frame>& to,
                                    double share) {
    base::Point<Frame> result;
    for (std::size_t i = 0; i < base::kMaxAxes; ++i) {
      result.values[i] = from.values[i] + share * (to.values[i] - from.values[i]);
    }
    return result;
  }
  bool is_head() const { return subject_.settings.kind == Kind::head_ac; }
  static Branch other(Branch branch) {
    return branch == Branch::plus ? Branch::minus : Branch::plus;
  }
  /// Where differences still tell something of the joints.
  JointPoint pose_off_singular_places(SeededRandom& random) const {
    JointPoint joints = random_joints(random);
    if (subject_.settings.kind == Kind::arm) {
      joints.values[0] = (random.coin() ? 1 : -1) * random.in(20, 160);
      if (subject_.settings.arm.forearm_absolute) joints.values[0] += joints.values[1];
    } else if (subject_.settings.kind == Kind::x_theta_z) {
      joints.values[0] = random.in(20, 300) - subject_.settings.x_theta_z.x1_mm;
    }
    return joints;
  }
};

TEST_P(EveryKinematics, ForwardOfInverseIsTheTip) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const TipPoint tip = subject_.tip(random);
    const JointPoint previous = random_joints(random);
    const auto joints = machine_->inverse(tip, previous);
    ASSERT_TRUE(joints) << text(tip) << joints.error().message;
    ASSERT_LE(difference(machine_->forward(*joints), tip), kExact) << text(tip) << text(previous);
  }
}

TEST_P(EveryKinematics, EveryBranchHoldsTheTip) {
  if (!machine_->has_branches()) return;
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const TipPoint tip = subject_.tip(random);
    const JointPoint previous = random_joints(random);
    for (const Branch branch : {Branch::plus, Branch::minus}) {
      const auto joints = machine_->inverse(tip, previous, branch);
      ASSERT_TRUE(joints) << text(tip);
      const TipPoint back = machine_->forward(*joints);
      if (is_head()) {
        ASSERT_LE(distance(back, tip), kExact) << text(tip);
        const auto beam = beam_axis({back.values[3], back.values[4]});
        ASSERT_LE(length(beam - beam_axis({tip.values[3], tip.values[4]})), 1e-12) << text(tip);
      } else {
        ASSERT_LE(difference(back, tip), kExact) << text(tip);
      }
    }
  }
}

TEST_P(EveryKinematics, InverseFindsTheJointsAgain) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    JointPoint joints = random_joints(random);
    // Tips on the axis, and arms that stretch or fold, do not tell their joints to 1e-6.
    if (machine_->has_branches() && !is_head()) {
      joints.values[0] = (random.coin() ? 1 : -1) * random.in(1, 179);
      if (subject_.settings.arm.forearm_absolute) joints.values[0] += joints.values[1];
    }
    if (subject_.settings.kind == Kind::x_theta_z) {
      joints.values[0] = random.in(0.01, 300) - subject_.settings.x_theta_z.x1_mm;
    }
    const auto again = machine_->inverse(machine_->forward(joints), joints);
    ASSERT_TRUE(again) << text(joints);
    for (std::size_t k = 0; k < machine_->size(); ++k) {
      ASSERT_NEAR(again->values[k], joints.values[k], 1e-8) << text(joints) << text(*again);
    }
  }
}

TEST_P(EveryKinematics, AlongAPathNoJointJumps) {
  SeededRandom random(kSeed);
  for (int path = 0; path < 100; ++path) {
    // A circle round the middle, through both ends of the range of an arc tangent.
    const bool arm = subject_.settings.kind == Kind::arm;
    const double least =
        arm ? std::fabs(subject_.settings.arm.upper_arm_mm - subject_.settings.arm.forearm_mm) : 0;
    const double r = least + random.in(20, 150);
    const double begin = any_angle_rad(random);
    const double sense = random.coin() ? 1 : -1;
    JointPoint joints = random_joints(random);
    const Branch branch = machine_->has_branches() && random.coin() ? Branch::minus : Branch::plus;
    constexpr int kSteps = 1000;
    for (int i = 0; i <= 2 * kSteps; ++i) {
      const double turned = sense * 2 * std::numbers::pi * i / kSteps;
      TipPoint tip = tip_at(r, begin + turned, 0, 0);
      if (arm) tip.values[3] = geometry::nearest_turn(geometry::degrees(begin + turned), 0, 180);
      if (is_head()) tip.values[3] = 20, tip.values[4] = geometry::degrees(turned);
      const auto next =
          i == 0 && arm ? machine_->inverse(tip, joints, branch) : machine_->inverse(tip, joints);
      ASSERT_TRUE(next);
      if (i > 0) {
        for (std::size_t k = 0; k < machine_->size(); ++k) {
          ASSERT_LE(std::fabs(next->values[k] - joints.values[k]), 3) << subject_.name << i;
        }
        if (arm) {
          ASSERT_EQ(machine_->branch_at(*next), branch);
        }
      }
      joints = *next;
    }
  }
}

TEST_P(EveryKinematics, NearestIsNoFartherThanAnyBranch) {
  SeededRandom random(kSeed);
  const auto turned = [&](const JointPoint& from, const JointPoint& to) {
    double sum = 0;
    for (std::size_t i = 0; i < machine_->size(); ++i) {
      if (machine_->joints()[i].rotary) sum += std::fabs(to.values[i] - from.values[i]);
    }
    return sum;
  };
  for (int i = 0; i < kCases; ++i) {
    const TipPoint tip = subject_.tip(random);
    const JointPoint previous = random_joints(random);
    const JointPoint nearest = *machine_->nearest(tip, previous);
    for (const Branch branch : {Branch::plus, Branch::minus}) {
      if (branch == Branch::minus && !machine_->has_branches()) continue;
      const JointPoint other = *machine_->inverse(tip, previous, branch);
      ASSERT_LE(turned(previous, nearest), turned(previous, other) + 1e-8) << text(tip);
    }
  }
}

TEST_P(EveryKinematics, NearestIsWithinTheLimitsOrSaysWhyNot) {
  Settings settings = subject_.settings;
  for (Joint& joint : settings.joints) {
    if (joint.rotary) joint.low = -170, joint.high = 150;
  }
  const auto limited = test::make(settings);
  SeededRandom random(kSeed);
  int found = 0;
  for (int i = 0; i < kCases; ++i) {
    const TipPoint tip = subject_.tip(random);
    const auto joints = limited->nearest(tip, random_joints(random));
    if (joints) {
      ++found;
      ASSERT_FALSE(limited->beyond_limits(*joints)) << text(tip);
      ASSERT_LE(distance(limited->forward(*joints), tip), kExact) << text(tip);
    } else {
      ASSERT_EQ(joints.error().kind, Fault::Kind::limit);
      const auto which = index(joints.error().joint);
      ASSERT_LT(which, settings.joints.size());
      ASSERT_TRUE(joints.error().value < settings.joints[which].low ||
                  joints.error().value > settings.joints[which].high);
    }
  }
  EXPECT_GT(found, kCases / 20);
}

/// A cubic path of all axes of the tip.
struct Cubic {
  base::TipJet at0;

  [[nodiscard]] base::TipJet at(double s) const {
    base::TipJet jet;
    for (std::size_t k = 0; k < base::kMaxAxes; ++k) {
      const auto& [value, first, second, third] = at0;
      const double v2 = second.values[k];
      const double v3 = third.values[k];
      jet.value.values[k] = value.values[k] + s * (first.values[k] + s * (v2 / 2 + s * v3 / 6));
      jet.first.values[k] = first.values[k] + s * (v2 + s * v3 / 2);
      jet.second.values[k] = v2 + s * v3;
      jet.third.values[k] = v3;
    }
    return jet;
  }
};

Cubic random_cubic(SeededRandom& random, const TipPoint& tip, std::size_t axes) {
  Cubic path{{tip, {}, {}, {}}};
  for (std::size_t k = 0; k < axes; ++k) {
    path.at0.first.values[k] = random.in(-1, 1);
    path.at0.second.values[k] = random.in(-0.1, 0.1);
    path.at0.third.values[k] = random.in(-0.01, 0.01);
  }
  return path;
}

/// Derivative of a vector by central differences of fourth order.
template <typename Function>
AxisVector slope(const Function& f) {
  constexpr double h = 2e-3;
  const AxisVector near = f(h) - f(-h);
  const AxisVector far = f(2 * h) - f(-2 * h);
  AxisVector result;
  for (std::size_t k = 0; k < base::kMaxAxes; ++k) {
    result.values[k] = (8 * near.values[k] - far.values[k]) / (12 * h);
  }
  return result;
}

void expect_derivative(const AxisVector& analytic, const AxisVector& differences,
                       const JointPoint& joints) {
  for (std::size_t k = 0; k < base::kMaxAxes; ++k) {
    ASSERT_NEAR(analytic.values[k], differences.values[k],
                1e-7 * (1 + std::fabs(differences.values[k])))
        << k << ": " << text(joints);
  }
}

TEST_P(EveryKinematics, DerivativesAreThoseOfCentralDifferences) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 20'000; ++i) {
    const JointPoint pose = pose_off_singular_places(random);
    const Branch branch = machine_->branch_at(pose);
    const TipPoint tip = machine_->forward(pose);
    if (is_head() && std::fabs(std::sin(geometry::radians(tip.values[3]))) < 0.01) continue;
    const Cubic path = random_cubic(random, tip, machine_->size());
    // The head turned over, too: its branch is not that which the program's angles name.
    const Branch held = is_head() && random.coin() ? other(branch) : branch;
    const JointPoint joints = *machine_->inverse(tip, pose, held);
    const auto joints_at = [&](double s) {
      return *machine_->inverse(path.at(s).value, joints, held);
    };
    const auto jet_at = [&](double s) { return *machine_->along(path.at(s), joints_at(s)); };
    const base::JointJet jet = jet_at(0);
    ASSERT_EQ(jet.value, joints);
    expect_derivative(jet.first, slope(joints_at), pose);
    expect_derivative(jet.second, slope([&](double s) { return jet_at(s).first; }), pose);
    expect_derivative(jet.third, slope([&](double s) { return jet_at(s).second; }), pose);
    if (HasFatalFailure()) return;
  }
}

TEST_P(EveryKinematics, JointsAlongAPathAllocateNothing) {
  SeededRandom random(kSeed);
  const JointPoint pose = pose_off_singular_places(random);
  const base::TipJet tip = random_cubic(random, machine_->forward(pose), machine_->size()).at0;
  const auto before = test::allocations_so_far();
  for (int i = 0; i < 1000; ++i) {
    const auto joints = machine_->inverse(tip.value, pose);
    ASSERT_TRUE(joints && machine_->along(tip, *joints));
  }
  EXPECT_EQ(test::allocations_so_far(), before);
}

TEST_P(EveryKinematics, TheTipNeverLeavesTheLineByMoreThanTheBound) {
  SeededRandom random(kSeed);
  double tightest = 0;
  for (int i = 0; i < kCases; ++i) {
    const JointPoint from = random_joints(random);
    JointPoint to = from;
    const double size = random.size(0.01, 30);
    for (std::size_t k = 0; k < machine_->size(); ++k) to.values[k] += random.in(-size, size);
    const double bound = machine_->deviation_bound_mm(from, to);
    const TipPoint begin = machine_->forward(from);
    const TipPoint end = machine_->forward(to);
    for (const double share : {0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9}) {
      const TipPoint tip = machine_->forward(between(from, to, share));
      const double off = distance(tip, between(begin, end, share));
      ASSERT_LE(off, bound + 1e-12 * 500) << text(from) << text(to);
      if (bound > 1e-6) tightest = std::max(tightest, off / bound);
    }
  }
  if (subject_.settings.kind != Kind::cartesian) {
    EXPECT_GT(tightest, 0.9) << "the bound is loose";
  }
}

TEST_P(EveryKinematics, TipRatesAreTheDerivativeOfForward) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 20'000; ++i) {
    const JointPoint joints = random_joints(random);
    AxisVector rates;
    for (std::size_t k = 0; k < machine_->size(); ++k) rates.values[k] = random.in(-1, 1);
    const double step = 1e-3;
    const TipPoint behind = machine_->forward(between(joints, joints + rates, step));
    const TipPoint before = machine_->forward(between(joints, joints + rates, -step));
    const geometry::Vec3 way = machine_->tip_rates(joints, rates);
    ASSERT_NEAR(way.x, (behind.values[0] - before.values[0]) / (2 * step), 1e-7) << text(joints);
    ASSERT_NEAR(way.y, (behind.values[1] - before.values[1]) / (2 * step), 1e-7) << text(joints);
    if (subject_.settings.kind == Kind::cartesian) continue;
    ASSERT_NEAR(way.z, (behind.values[2] - before.values[2]) / (2 * step), 1e-7) << text(joints);
  }
}

TEST_P(EveryKinematics, TheRootOfTheSwingIsANorm) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const JointPoint joints = random_joints(random);
    AxisVector a;
    AxisVector b;
    for (std::size_t k = 0; k < machine_->size(); ++k) {
      a.values[k] = random.in(-1, 1);
      b.values[k] = random.size(1e-3, 1e3) * (random.coin() ? 1 : -1);
    }
    const double swing_a = machine_->swing_bound_mm(joints, a);
    const double swing_b = machine_->swing_bound_mm(joints, b);
    const double both = machine_->swing_bound_mm(joints, a + b);
    ASSERT_LE(std::sqrt(both), (std::sqrt(swing_a) + std::sqrt(swing_b)) * (1 + 1e-12));
    ASSERT_NEAR(machine_->swing_bound_mm(joints, a + a), 4 * swing_a, 1e-12 * swing_a);
    ASSERT_EQ(machine_->swing_bound_mm(joints, {}), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinematics, EveryKinematics,
                         testing::Range(std::size_t{0}, subjects().size()),
                         [](const auto& parameter) { return subjects()[parameter.param].name; });

}  // namespace
}  // namespace kerf::kinematics
