// Cutting parts of all kinds, by the formulas of their kind, by volume, and by what cannot be.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>

#include "tool_maker.hpp"

namespace kerf::stock {
namespace {

using test::Said;
using test::tool_of;
using M = Measure;

constexpr double kPi = std::numbers::pi;
double tan_deg(double degrees) { return std::tan(degrees / 180 * kPi); }

/// Simpson's rule over each edge: exact for lines, and for arcs about a centre on the axis.
double volume_mm3(const Profile& profile, double top) {
  double sum = 0;
  for (const ProfileEdge& edge : profile.edges()) {
    const double to = std::min(edge.to.z, top);
    if (to <= edge.from.z) continue;
    constexpr int kPieces = 2000;
    const Profile alone({{{0, 0}, {0, edge.from.z}, 0, edge.part},
                         {{0, edge.from.z}, edge.from, 0, edge.part},
                         edge});
    const double step = (to - edge.from.z) / kPieces;
    const auto section = [&](double z) {
      const double r = z <= edge.from.z ? edge.from.r : alone.radius_at(z);
      return kPi * r * r;
    };
    for (int i = 0; i < kPieces; ++i) {
      const double z = edge.from.z + i * step;
      sum += step / 6 * (section(z) + 4 * section(z + step / 2) + section(std::min(z + step, to)));
    }
  }
  return sum;
}

bool is_sound(const Profile& profile) {
  ProfilePoint at;
  for (const ProfileEdge& edge : profile.edges()) {
    if (!(edge.from == at) || !std::isfinite(edge.to.r) || !std::isfinite(edge.to.z)) return false;
    if (edge.to.r < 0 || edge.to.z < at.z || std::abs(edge.bulge) > std::tan(kPi / 8) + 1e-9)
      return false;
    at = edge.to;
  }
  return !profile.is_empty();
}

struct Shape {
  std::string type;
  Said said;
  double top;  ///< height up to which `radius` is the formula
  std::function<double(double)> radius;
  double volume;  ///< up to there
};

double frustum(double height, double a, double b) {
  return kPi * height / 3 * (a * a + a * b + b * b);
}

std::vector<Shape> plain_shapes() {
  const auto constant = [](double r) { return [r](double) { return r; }; };
  const double drill_tip = 5 / tan_deg(59);
  const double torus = kPi * (4 * 4 * 2 + 4 * 2 * 2 * kPi / 2 + 2.0 * 2 * 2 * 2 / 3);
  const double v_height = 2.9 / tan_deg(30);
  const double ball_z = 0.5 * (1 - std::sin(kPi / 18));
  const double ball_r = 0.5 * std::cos(kPi / 18);
  const double cone_z = ball_z + (3 - ball_r) / tan_deg(10);
  const double pilot_tip = 1 / tan_deg(59);
  const double centre_top = 3 + 2 / tan_deg(30);
  return {
      {"flat", {{M::diameter, 10}}, 7, constant(5), kPi * 25 * 7},
      {"slot", {{M::diameter, 10}}, 7, constant(5), kPi * 25 * 7},
      {"ball",
       {{M::diameter, 6}},
       3,
       [](double z) { return std::sqrt(6 * z - z * z); },
       2 * kPi / 3 * 27},
      {"bull",
       {{M::diameter, 12}, {M::corner_radius, 2}},
       2,
       [](double z) { return 4 + std::sqrt(4 * z - z * z); },
       torus},
      {"v",
       {{M::diameter, 6}, {M::angle, 60}, {M::tip_diameter, 0.2}},
       v_height,
       [](double z) { return 0.1 + z * tan_deg(30); },
       frustum(v_height, 0.1, 3)},
      {"countersink", {{M::diameter, 12}}, 6, [](double z) { return z; }, frustum(6, 0, 6)},
      {"taper",
       {{M::diameter, 6}, {M::angle, 20}, {M::tip_radius, 0.5}},
       cone_z,
       [=](double z) {
         if (z < ball_z) return std::sqrt(z - z * z);
         return ball_r + (z - ball_z) * tan_deg(10);
       },
       kPi * ball_z * ball_z * (1.5 - ball_z) / 3 + frustum(cone_z - ball_z, ball_r, 3)},
      {"drill",
       {{M::diameter, 10}},
       drill_tip,
       [](double z) { return z * tan_deg(59); },
       frustum(drill_tip, 0, 5)},
      {"centre-drill",
       {{M::diameter, 6}, {M::pilot_diameter, 2}, {M::pilot_length, 3}},
       centre_top,
       [=](double z) {
         if (z < pilot_tip) return z * tan_deg(59);
         return z < 3 ? 1 : 1 + (z - 3) * tan_deg(30);
       },
       frustum(pilot_tip, 0, 1) + kPi * (3 - pilot_tip) + frustum(centre_top - 3, 1, 3)},
  };
}

std::vector<Shape> necked_shapes() {
  const auto constant = [](double r) { return [r](double) { return r; }; };
  const double lollipop_top = 6 + std::sqrt(36 - 6.25);
  return {
      {"reamer", {{M::diameter, 8}}, 0.5, [](double z) { return 3.5 + z; }, frustum(0.5, 3.5, 4)},
      {"tap",
       {{M::diameter, 10}, {M::pitch, 1.5}},
       6,
       [](double z) {
         const double minor = (10 - 1.082531755 * 1.5) / 2;
         return z > 3 ? minor : minor - (3 - z) / 3 * 1.082531755 * 1.5 / 2;
       },
       frustum(3, 5 - 1.082531755 * 1.5, 5 - 1.082531755 * 0.75) +
           kPi * 3 * std::pow(5 - 1.082531755 * 0.75, 2)},
      {"face",
       {{M::diameter, 40}, {M::entering_angle, 45}, {M::ap_max, 4}},
       4,
       [](double z) { return 20 + z; },
       frustum(4, 20, 24)},
      {"t-slot",
       {{M::diameter, 16}, {M::width, 4}, {M::neck_diameter, 7}},
       4,
       constant(8),
       kPi * 64 * 4},
      {"dovetail",
       {{M::diameter, 20}, {M::angle, 60}, {M::height, 5}, {M::neck_diameter, 8}},
       5,
       [](double z) { return 10 - z / tan_deg(60); },
       frustum(5, 10, 10 - 5 / tan_deg(60))},
      {"lollipop",
       {{M::diameter, 12}, {M::neck_diameter, 5}},
       lollipop_top,
       [](double z) { return std::sqrt(12 * z - z * z); },
       kPi * lollipop_top * lollipop_top * (18 - lollipop_top) / 3},
      {"boring", {{M::diameter, 30}}, 3, constant(15), kPi * 225 * 3},
  };
}

std::vector<Shape> shapes() {
  std::vector<Shape> all = plain_shapes();
  for (Shape& shape : necked_shapes()) all.push_back(std::move(shape));
  return all;
}

TEST(ToolProfile, HasTheRadiusOfTheFormulaOfItsKindAtEveryHeight) {
  for (const Shape& shape : shapes()) {
    const Tool tool = tool_of(shape.type, shape.said);
    ASSERT_EQ(objection(tool), "") << shape.type;
    const Profile profile = profile_of(tool);
    for (int i = 1; i < 50; ++i) {
      const double z = shape.top * i / 50;
      EXPECT_NEAR(profile.radius_at(z), shape.radius(z), 1e-9) << shape.type << " at " << z;
    }
  }
}

TEST(ToolProfile, HoldsTheVolumeOfItsShape) {
  for (const Shape& shape : shapes()) {
    const Profile profile = profile_of(tool_of(shape.type, shape.said));
    EXPECT_NEAR(volume_mm3(profile, shape.top), shape.volume, 1e-4 * shape.volume) << shape.type;
  }
}

TEST(ToolProfile, CutsAsHighAsThereIsMaterialWhereNobodySaysHowLongTheFlutesAre) {
  for (const char* type : {"flat", "ball", "drill", "boring"}) {
    const Profile profile = profile_of(tool_of(type, {{M::diameter, 10}}));
    EXPECT_EQ(profile.edge_height(), Profile::kEndless_mm) << type;
    EXPECT_EQ(profile.radius_at(5000), 5) << type;
  }
  const Profile held = profile_of(tool_of("flat", {{M::diameter, 10}, {M::stickout, 40}}));
  EXPECT_EQ(held.edge_height(), 40);
}

TEST(ToolProfile, IsAsWideAboveTheFlutesAndCutsNothingThere) {
  const Profile open = profile_of(tool_of("flat", {{M::diameter, 10}, {M::flute_length, 20}}));
  EXPECT_EQ(open.edge_height(), 20);
  EXPECT_EQ(open.height(), Profile::kEndless_mm);
  EXPECT_EQ(open.widest(ToolPart::flank), 5);
  EXPECT_EQ(open.widest(ToolPart::shank), 0);
}

Tool held_tool() {
  Tool tool = tool_of(
      "bull", {{M::diameter, 12}, {M::corner_radius, 2}, {M::flute_length, 26}, {M::stickout, 45}});
  tool.shank = {{60, 12, 12}};
  tool.holder = {{25, 30, 40}, {40, 63, 63}};
  return tool;
}

TEST(ToolProfile, HasShankAndHolderWhereTheyStand) {
  const Profile profile = profile_of(held_tool());
  EXPECT_TRUE(is_sound(profile));
  EXPECT_EQ(profile.edge_height(), 26);
  EXPECT_EQ(profile.widest(ToolPart::flank), 6);
  EXPECT_EQ(profile.widest(ToolPart::shank), 0);
  EXPECT_EQ(profile.widest(ToolPart::holder), 31.5);
  EXPECT_EQ(profile.radius_at(44.9), 6);
  EXPECT_EQ(profile.radius_at(45), 15);
  EXPECT_NEAR(profile.radius_at(57.5), 17.5, 1e-12);
  EXPECT_EQ(profile.height(), 110);
}

TEST(ToolProfile, TellsAShankThatIsWiderThanTheCutterFromOneThatIsNot) {
  Tool tool = tool_of("flat", {{M::diameter, 10}, {M::flute_length, 20}});
  tool.shank = {{5, 8, 8}, {10, 8, 16}, {5, 16, 16}};
  const Profile profile = profile_of(tool);
  ASSERT_TRUE(is_sound(profile));
  EXPECT_EQ(profile.widest(ToolPart::flank), 5);
  EXPECT_EQ(profile.widest(ToolPart::shank), 8);
  EXPECT_EQ(profile.height(), 40);
  for (const ProfileEdge& edge : profile.edges()) {
    if (edge.part == ToolPart::flank) {
      EXPECT_LE(edge.to.z, 27.5 + 1e-12);
    }
    if (edge.part == ToolPart::shank) {
      EXPECT_GE(edge.from.z, 27.5 - 1e-12);
    }
  }
}

TEST(ToolProfile, HasItsNeckAboveADisc) {
  const Profile profile = profile_of(
      tool_of("saw", {{M::diameter, 16}, {M::width, 4}, {M::neck_diameter, 7}, {M::stickout, 50}}));
  EXPECT_TRUE(profile.has_undercut());
  EXPECT_EQ(profile.edge_height(), 4);
  EXPECT_EQ(profile.radius_at(4.001), 3.5);
  EXPECT_EQ(profile.widest(ToolPart::flank), 8 - 4.5);
  EXPECT_EQ(profile.height(), 50);
}

TEST(ToolProfile, OfAFaceMillHasItsBodyAboveTheEdges) {
  const Said said = {{M::diameter, 40}, {M::ap_max, 4}, {M::body_diameter, 50}};
  const Profile profile = profile_of(tool_of("face", said));
  EXPECT_EQ(profile.edge_height(), 4);
  EXPECT_EQ(profile.widest(ToolPart::shank), 25);
  const Profile unknown = profile_of(tool_of("face", {{M::diameter, 40}}));
  EXPECT_EQ(unknown.edge_height(), Profile::kEndless_mm);
}

TEST(ToolProfile, OfAThreadMillHasATeethAtEachPitch) {
  const Profile profile = profile_of(tool_of(
      "thread-mill", {{M::diameter, 12}, {M::pitch, 2}, {M::teeth, 3}, {M::neck_diameter, 9.4}}));
  ASSERT_TRUE(is_sound(profile));
  const double flank = 1.3 * tan_deg(30);
  for (int tooth = 0; tooth < 3; ++tooth) {
    EXPECT_NEAR(profile.radius_at(2 * tooth + flank + 0.125), 6, 1e-12);
    EXPECT_NEAR(profile.radius_at(2 * tooth + flank / 2), 6 - 0.65, 1e-12);
  }
  EXPECT_NEAR(profile.radius_at(1.9), 4.7, 1e-12);
  EXPECT_NEAR(profile.edge_height(), 4 + 2 * flank + 0.25, 1e-12);
  const Profile usual = profile_of(tool_of("thread-mill", {{M::diameter, 12}, {M::pitch, 2}}));
  EXPECT_NEAR(usual.edges().front().to.r, 6 - 0.6134 * 2, 1e-12);
  EXPECT_EQ(usual.height(), usual.edge_height()) << "a neck that nobody knows";
}

TEST(ToolProfile, CutsDeepTeethOffWhereTheirFlanksMeet) {
  const Profile profile = profile_of(tool_of(
      "thread-mill", {{M::diameter, 12}, {M::pitch, 1}, {M::teeth, 4}, {M::neck_diameter, 6}}));
  ASSERT_TRUE(is_sound(profile));
  const double depth = (1 - 0.125) / 2 / tan_deg(30);
  EXPECT_NEAR(profile.edges().front().to.r, 6 - depth, 1e-12);
  EXPECT_EQ(profile.radius_at(profile.edge_height() + 1), 3);
}

TEST(ToolProfile, OfAFormToolIsWhatIsGivenInArcsOfAtMostAQuarter) {
  Tool tool = tool_of("form", {});
  // A half circle inwards: concave, about (10, 4), then a cylinder that does not cut.
  tool.form = {{10, 0, 0}, {10, 1, -1}, {10, 7, 0}, {10, 12, 0}};
  tool.cutting = FormCutting{0, 2};
  ASSERT_EQ(objection(tool), "");
  const Profile profile = profile_of(tool);
  EXPECT_TRUE(is_sound(profile));
  EXPECT_NEAR(profile.radius_at(4), 7, 1e-9);
  EXPECT_NEAR(profile.radius_at(2), 10 - std::sqrt(5), 1e-9);
  EXPECT_EQ(profile.edge_height(), 7);
  EXPECT_EQ(profile.widest(ToolPart::flank), 10);
}

TEST(ToolProfile, OfAProbeIsABallOnItsStem) {
  const Profile bare = profile_of(tool_of("probe", {{M::diameter, 4}}));
  EXPECT_TRUE(is_sound(bare));
  EXPECT_NEAR(volume_mm3(bare, 4), 4 * kPi / 3 * 8, 1e-3);
  EXPECT_EQ(bare.height(), 4);
  const Profile whole = profile_of(tool_of("probe", {{M::diameter, 4}, {M::neck_diameter, 2}}));
  EXPECT_EQ(whole.radius_at(100), 1);
}

// Any numbers: either a sentence or a body.
TEST(Tool, WithRandomMeasuresIsRefusedOrHasAProfile) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  int made = 0;
  for (int i = 0; i < 20000; ++i) {
    const KindRow& row = kind_rows()[random() % kind_rows().size()];
    if (row.is_insert() || row.kind == ToolKind::form) continue;
    Tool tool = tool_of(row.names.front(), {});
    for (const KindKey& key : row.keys) {
      const MeasureRow& measure = row_of(key.measure);
      const double most = std::min(measure.high, measure.whole ? 9.0 : 180.0);
      const double value = measure.low + (most - measure.low) * std::pow(share(random), 2);
      if (key.is_needed || random() % 2 == 0)
        tool.measures.set(key.measure, measure.whole ? std::ceil(value) : value);
    }
    if (random() % 2 == 0) tool.measures.set(M::flute_length, 200 * share(random));
    if (random() % 2 == 0) tool.measures.set(M::stickout, 400 * share(random));
    if (!objection(tool).empty()) continue;
    ++made;
    ASSERT_TRUE(is_sound(profile_of(tool))) << row.names.front() << ' ' << i;
  }
  EXPECT_GT(made, 3000);
}

}  // namespace
}  // namespace kerf::stock
