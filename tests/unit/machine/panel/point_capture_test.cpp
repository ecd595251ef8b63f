#include "machine/panel/point_capture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kinematics/orientation.hpp"
#include "taught_text.hpp"

namespace kerf::test {
namespace {

using base::AxisVector;
using base::JointPoint;
using geometry::Vec3;
using machine::Capture;
using teach::Pose;

machine::MachineDefinition laser5() { return *machine::find_machine("laser5"); }

// Focus, A, C, and where the carriage stands with r_a 150, r_c 80: worked by hand.
struct Worked {
  Pose pose;
  std::array<double, 3> carriage;
};
const Worked kWorked[] = {
    {{0, 0, 0, 0, 0}, {-80, 0, 150}},
    {{100, 50, 25, 30, 90}, {175, -30, 154.903811}},
    {{10, 20, 30, -45, 10}, {-87.202791, 110.562782, 136.066017}},
    {{10, 20, 30, 45, 190}, {70.366450, 138.346490, 136.066017}},
    {{-12.5, 7.25, 3, 90, 0}, {-92.5, -142.75, 3}},
    {{0, 0, 0, 15, -120}, {6.378420, 88.693461, 144.888874}},
    {{200, -80, 60, 62.5, 233.1}, {141.634275, 63.861659, 129.262292}},
};

JointPoint joints_of(const Worked& worked) {
  const auto& [x, y, z] = worked.carriage;
  return {{x, y, z, worked.pose.a_deg, worked.pose.c_deg}};
}

TEST(Capture, ThePoseIsTheFocusUnderTheHead) {
  const Capture capture(laser5());
  for (const Worked& worked : kWorked) {
    const Pose pose = capture.pose_at(joints_of(worked));
    EXPECT_NEAR(pose.x, worked.pose.x, 1e-6);
    EXPECT_NEAR(pose.y, worked.pose.y, 1e-6);
    EXPECT_NEAR(pose.z, worked.pose.z, 1e-6);
    EXPECT_EQ(pose.a_deg, worked.pose.a_deg);
    EXPECT_EQ(pose.c_deg, worked.pose.c_deg);
  }
}

TEST(Capture, KeysMakeRecordsThatReadBackBitForBit) {
  Capture capture(laser5());
  EXPECT_FALSE(capture.add(teach::Feed{3000}));
  EXPECT_FALSE(capture.point(joints_of(kWorked[0]), "edge"));
  EXPECT_FALSE(capture.add(teach::Laser{true, 62.5}));
  EXPECT_FALSE(capture.line(joints_of(kWorked[1])));
  capture.middle(joints_of(kWorked[2]));
  EXPECT_FALSE(capture.arc(joints_of(kWorked[4])));
  capture.middle(joints_of(kWorked[5]));
  EXPECT_FALSE(capture.circle(joints_of(kWorked[6])));
  EXPECT_FALSE(capture.add(teach::Dwell{0.1}));
  EXPECT_FALSE(capture.add(teach::End{}));
  const std::string text = capture.recorder().text();
  EXPECT_EQ(text.substr(0, text.find("LASER")),
            "TEACH 1\nUNITS MM DEG\nPERIOD 8\nRADII 150 80\nFEED 3000\nPOINT 0 0 0 0 0 edge\n");
  const TaughtText read = read_taught(text);
  EXPECT_EQ(read.mistakes, std::vector<std::string>{});
  const auto records = capture.recorder().records();
  EXPECT_EQ(read.records, std::vector<teach::Record>(records.begin(), records.end()));
  EXPECT_EQ(read.rewritten, text);
}

TEST(Capture, RefusesWhatNoArcLeadsThroughAndStaysAsItWas) {
  Capture capture(laser5());
  const auto at = [](double x, double y) { return JointPoint{{x, y, 150, 0, 0}}; };
  EXPECT_EQ(capture.line(at(1, 1))->code, base::Code::teach_order);
  EXPECT_FALSE(capture.add(teach::Feed{100}));
  EXPECT_FALSE(capture.point(at(0, 0)));
  EXPECT_EQ(capture.arc(at(1, 1))->code, base::Code::teach_order);
  const std::string before = capture.recorder().text();
  capture.middle(at(20, 0));
  EXPECT_EQ(capture.arc(at(10, 0))->code, base::Code::arc_collinear);
  capture.middle(at(0, 0));
  EXPECT_EQ(capture.arc(at(10, 0))->code, base::Code::arc_coincident);
  capture.middle(at(5, 0));
  EXPECT_EQ(capture.circle(at(10, 0))->code, base::Code::arc_collinear);
  EXPECT_EQ(capture.recorder().text(), before);
  EXPECT_TRUE(capture.waiting_middle());
  EXPECT_FALSE(capture.arc(at(10, 0)));  // between the ends: two lines
  EXPECT_FALSE(capture.waiting_middle());
}

TEST(Capture, RefusesWhatTheFileCannotHold) {
  Capture capture(laser5());
  const JointPoint joints{};
  EXPECT_EQ(capture.point(joints, "two words")->code, base::Code::teach_count);
  EXPECT_EQ(capture.point(joints, "a;b")->code, base::Code::teach_range);
  EXPECT_EQ(capture.point(joints, std::string(64, 'n'))->code, base::Code::teach_range);
  EXPECT_EQ(capture.add(teach::Feed{0})->code, base::Code::teach_range);
  EXPECT_EQ(capture.add(teach::Laser{true, 120})->code, base::Code::teach_range);
  EXPECT_EQ(capture.add(teach::Dwell{std::nan("")})->code, base::Code::teach_number);
  EXPECT_EQ(capture.recorder().records().size(), 4U);
}

TEST(Capture, TakesBackTheMiddleThenTheLastRecord) {
  Capture capture(laser5());
  EXPECT_FALSE(capture.add(teach::Feed{100}));
  EXPECT_FALSE(capture.point({}));
  capture.middle({});
  EXPECT_TRUE(capture.take_back());
  EXPECT_FALSE(capture.waiting_middle());
  EXPECT_TRUE(capture.take_back());
  EXPECT_TRUE(capture.take_back());
  EXPECT_FALSE(capture.take_back());
  EXPECT_EQ(capture.recorder().text(), "TEACH 1\nUNITS MM DEG\nPERIOD 8\nRADII 150 80\n");
  EXPECT_EQ(capture.line({})->code, base::Code::teach_order);
}

TEST(SurfaceNormal, PointsToTheHeadWhateverTheOrderOfItsPoints) {
  std::mt19937 random(11);
  std::uniform_real_distribution<> any(-100, 100);
  for (int i = 0; i < 1000; ++i) {
    const kinematics::HeadAngles head{any(random), 3 * any(random)};
    const Vec3 beam = kinematics::beam_axis(head);
    const Vec3 q1{any(random), any(random), any(random)};
    const Vec3 q2{any(random), any(random), any(random)};
    const Vec3 q3{any(random), any(random), any(random)};
    const auto normal = kinematics::surface_normal(q1, q2, q3, beam);
    ASSERT_TRUE(normal.has_value());
    EXPECT_NEAR(length(*normal), 1, 1e-12);
    EXPECT_NEAR(dot(*normal, q2 - q1), 0, 1e-10);
    EXPECT_NEAR(dot(*normal, q3 - q1), 0, 1e-10);
    EXPECT_GT(dot(*normal, beam), 0);
    EXPECT_LT(length(*kinematics::surface_normal(q2, q1, q3, beam) - *normal), 1e-12);
    // Turned there the beam is square to the surface.
    const auto square = kinematics::orientation(*normal, head);
    EXPECT_LT(length(kinematics::beam_axis(*square) - *normal), 1e-12);
  }
}

TEST(SurfaceNormal, ThreePointsOnALineAndABeamInTheSurfaceHaveNone) {
  const Vec3 up{0, 0, 1};
  EXPECT_FALSE(kinematics::surface_normal({0, 0, 0}, {1, 1, 1}, {3, 3, 3}, up));
  EXPECT_FALSE(kinematics::surface_normal({0, 0, 0}, {0, 0, 0}, {3, 3, 3}, up));
  EXPECT_FALSE(kinematics::surface_normal({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, up));
  EXPECT_EQ(*kinematics::surface_normal({0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {0, 0, -1}),
            (Vec3{0, 0, -1}));
}

// A alone and C alone at A = 90 turn on a great circle; C alone at A = 45 turns on a small one,
// whose middle is off by the angle between the small circle and the chord's: worked from two
// vectors.
TEST(ShortestTurn, LinearAnglesLeaveItWhereBothTurn) {
  using kinematics::most_off_shortest_turn_deg;
  EXPECT_NEAR(most_off_shortest_turn_deg({10, 20}, {10, 20}), 0, 1e-9);
  EXPECT_NEAR(most_off_shortest_turn_deg({-20, 70}, {50, 70}), 0, 1e-9);
  EXPECT_NEAR(most_off_shortest_turn_deg({90, 0}, {90, 120}), 0, 1e-9);
  // Ends (sin 45 sin c, -sin 45 cos c, cos 45) at c = 0, 90; the middle of the great circle is
  // along their sum, (1, -1, 2) / sqrt 6; the small circle is there at (1/2, -1/2, sqrt 1/2).
  const double wanted = std::acos((0.5 + 0.5 + 2 * std::sqrt(0.5)) / std::sqrt(6)) * 180 / M_PI;
  EXPECT_NEAR(most_off_shortest_turn_deg({45, 0}, {45, 90}), wanted, 1e-6);
  EXPECT_EQ(most_off_shortest_turn_deg({90, 0}, {90, 180}), 180);
}

}  // namespace
}  // namespace kerf::test
