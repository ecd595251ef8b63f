// Volumes in closed form: the table of stock.md §9 that is a mill's.
#include "mill.hpp"
#include "stock/sweep/turning_steps.hpp"

namespace kerf::stock::dexel::test {
namespace {

/// |error| <= 5 % h; faces parallel to the grid: 1e-5.
constexpr double kParallelFaces = 1e-5;
double share_of(double cell) { return 0.05 * cell; }

void expect_removed(Mill& mill, double wanted, double share) {
  const double removed = mill.removed();
  EXPECT_NEAR(removed, wanted, share * wanted) << removed;
  EXPECT_LE(std::fabs(removed - wanted), mill.model.error_mm3() + 1e-5 * wanted);
  EXPECT_FALSE(mill.has_contacts());
}

class DexelOracle : public testing::TestWithParam<double> {
 protected:
  [[nodiscard]] static double cell() { return GetParam(); }
  [[nodiscard]] static double share() { return share_of(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Cell, DexelOracle, testing::Values(0.25, 0.1),
                         [](const auto& each) { return each.param == 0.1 ? "Fine" : "Coarse"; });

TEST_P(DexelOracle, Slot) {
  Mill mill({{0, 0, -20}, {70, 40, 0}}, cell());
  mill.tool(flat(10)).at({10, 20, 5}).line({10, 20, -5}).line({60, 20, -5});
  expect_removed(mill, 2892.69908, share());
}

TEST_P(DexelOracle, Pocket) {
  Mill mill({{0, 0, -20}, {60, 50, 0}}, cell());
  mill.tool(flat(8)).at({10, 10, 5}).line({10, 10, -6});
  for (double y = 10; y <= 40; y += 5) {
    const bool is_right = std::fmod(y, 10) == 0;
    mill.line({is_right ? 10.0 : 50.0, y, -6}).line({is_right ? 50.0 : 10.0, y, -6});
  }
  mill.line({50, 10, -6}).line({10, 10, -6}).line({10, 40, -6});
  expect_removed(mill, 10861.5929, share());
}

TEST_P(DexelOracle, Island) {
  Mill mill({{-20, -20, -20}, {20, 20, 0}}, cell());
  mill.tool(flat(6)).at({10, 0, 5}).line({10, 0, -4}).arc(0, 0, 2 * pi);
  expect_removed(mill, 1507.96447, share());
}

TEST_P(DexelOracle, Helix) {
  Mill mill({{-20, -20, -20}, {20, 20, 0}}, cell());
  mill.tool(flat(10)).at({3, 0, 5}).line({3, 0, 0});
  for (int i = 0; i < 3; ++i) mill.arc(0, 0, 2 * pi, -2);
  mill.arc(0, 0, 2 * pi);
  expect_removed(mill, 1206.37158, share());
}

TEST_P(DexelOracle, BallShallow) {
  Mill mill({{0, 0, -20}, {60, 40, 0}}, cell());
  mill.tool(ball(6)).at({10, 20, 5}).line({10, 20, -2}).line({50, 20, -2});
  expect_removed(mill, 359.329837, share());
}

TEST_P(DexelOracle, BallDeep) {
  Mill mill({{0, 0, -20}, {60, 40, 0}}, cell());
  mill.tool(ball(6)).at({10, 20, 5}).line({10, 20, -5}).line({50, 20, -5});
  expect_removed(mill, 1158.58401, share());
}

TEST_P(DexelOracle, Bull) {
  Mill mill({{0, 0, -20}, {60, 40, 0}}, cell());
  mill.tool(bull(10, 2)).at({10, 20, 5}).line({10, 20, -3}).line({50, 20, -3});
  expect_removed(mill, 1342.38868, share());
}

TEST_P(DexelOracle, VGroove) {
  Mill mill({{0, 0, -20}, {60, 40, 0}}, cell());
  mill.tool(pointed(6, 30, 0.2)).at({10, 20, 5}).line({10, 20, -1.5}).line({40, 20, -1.5});
  expect_removed(mill, 49.6044692, cell() == 0.1 ? 0.01 : 0.05);
}

TEST_P(DexelOracle, Drill) {
  Mill mill({{0, 0, -30}, {60, 40, 0}}, cell());
  mill.tool(pointed(10, 59)).at({30, 20, 2}).line({30, 20, -20}).rapid({30, 20, 2});
  expect_removed(mill, 1413.49138, share());
}

TEST_P(DexelOracle, DrillThrough) {
  Mill mill({{0, 0, -20}, {60, 40, 0}}, cell());
  mill.tool(pointed(10, 59)).at({30, 20, 2}).line({30, 20, -26}).rapid({30, 20, 2});
  expect_removed(mill, 1570.79633, share());
}

TEST_P(DexelOracle, Chamfer) {
  Mill mill({{0, 0, -20}, {50, 30, 0}}, cell());
  mill.tool(pointed(12, 45)).at({-10, 0, -2}).line({50, 0, -2}).line({50, 30, -2});
  mill.line({0, 30, -2}).line({0, 0, -2});
  expect_removed(mill, 309.333333, share());
}

TEST_P(DexelOracle, Facing) {
  Mill mill({{0, 0, -20}, {80, 50, 0}}, cell());
  mill.tool(flat(40)).at({-25, 10, -1.5}).line({105, 10, -1.5}).line({105, 40, -1.5});
  mill.line({-25, 40, -1.5});
  expect_removed(mill, 6000, kParallelFaces);
}

TEST_P(DexelOracle, TSlot) {
  Mill mill({{0, 0, -30}, {60, 40, 0}}, cell());
  mill.tool(flat(8)).at({-15, 20, -10}).line({75, 20, -10});
  mill.tool(t_slot(16, 4, 7)).at({-15, 20, -10}).line({75, 20, -10});
  expect_removed(mill, 6720, kParallelFaces);
}

TEST_P(DexelOracle, Lollipop) {
  Mill mill({{0, 0, -30}, {50, 40, 0}}, cell());
  mill.tool(flat(6)).at({-10, 20, -10}).line({60, 20, -10});
  mill.tool(lollipop(12, 5)).at({-10, 20, -16}).line({60, 20, -16});
  expect_removed(mill, 6932.96612, share());
}

/// A tool over a table that turns about X and carries one that turns about Z, both through 0
/// (stock.md §2.4): tip and axis in the work.
struct Pose {
  Vec3 tip;
  Vec3 axis;
};
Pose on_table(Vec3 m, double a, double c) {
  const auto turned = [&](Vec3 v) {
    const double ca = std::cos(a * pi / 180), sa = std::sin(a * pi / 180);
    const double cc = std::cos(c * pi / 180), sc = std::sin(c * pi / 180);
    const Vec3 w{v.x, v.y * ca - v.z * sa, v.y * sa + v.z * ca};
    return Vec3{w.x * cc - w.y * sc, w.x * sc + w.y * cc, w.z};
  };
  return {turned(m), turned({0, 0, 1})};
}

TEST(Table, TurnsToolsAsItsFormulaSays) {
  const Pose pose = on_table({10, 20, 5}, 30, 90);
  EXPECT_NEAR(pose.tip.x, -14.820508, 1e-6);
  EXPECT_NEAR(pose.tip.y, 10, 1e-6);
  EXPECT_NEAR(pose.tip.z, 14.330127, 1e-6);
  EXPECT_NEAR(pose.axis.x, 0.5, 1e-6);
}

TEST_P(DexelOracle, CrossHoles) {
  Mill mill({{-20, -20, -20}, {20, 20, 20}}, cell());
  mill.tool(flat(20, 50));
  for (const double a : {0.0, 90.0}) {
    const auto tip = [&](double z) { return on_table({0, 0, z}, a, 0).tip; };
    mill.axis(on_table({}, a, 0).axis).at(tip(45)).line(tip(-25)).rapid(tip(45));
  }
  expect_removed(mill, 19799.4079, share());
}

TEST_P(DexelOracle, Tilted) {
  Mill mill({{-10, -30, -30}, {50, 30, 0}}, cell());
  const auto tip = [](double x, double z) { return on_table({x, 0, z}, 30, 0).tip; };
  mill.tool(flat(10, 30)).axis(on_table({}, 30, 0).axis).at(tip(0, 30));
  mill.line(tip(0, -5)).line(tip(40, -5)).line(tip(40, 30));
  expect_removed(mill, 2392.69908, share());
}

TEST(OracleOfTurning, Swing) {
  Mill mill({{-15, -30, -15}, {15, 30, 12}}, 0.25);
  mill.tool(ball(8, 40)).at({0, 0, 40}).line({0, 0, -4});
  double last = 0;
  for (const double to : {30.0, -30.0, 0.0}) {
    const auto pose = [&](double t) {
      const Pose at = on_table({0, 0, -4}, last + (to - last) * t, 0);
      return ToolPose{at.tip, at.axis};
    };
    for (const TurningStep& step : turning_steps(pose, 20, 0.005)) {
      mill.turn(step.way.to, step.way.to_axis);
    }
    last = to;
  }
  mill.line({0, 0, 40});
  expect_removed(mill, 1500.23455, share_of(0.25));
}

}  // namespace
}  // namespace kerf::stock::dexel::test
