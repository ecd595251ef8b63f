// Threads of taps and thread mills: what is told of them, and the real groove against its section
// found by search.
#include "stock/cutting/thread_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "../dexel/mill.hpp"
#include "../tool/tool_maker.hpp"
#include "stock/field/height_field.hpp"

namespace kerf::stock {
namespace {

using dexel::test::Mill;
using std::numbers::pi;
using M = Measure;

constexpr double kTouch_mm = 0.01;

/// Tools by their numbers.
class Rack final : public ToolRack {
 public:
  const CuttingTool& add(int number, const std::string& type, const test::Said& said) {
    Tool tool = test::tool_of(type, said);
    tool.number = number;
    return tools_.emplace(number, cutting_tool(tool, kTouch_mm)).first->second;
  }
  const CuttingTool& tool(std::uint32_t number) override {
    return tools_.at(static_cast<int>(number));
  }

 private:
  std::map<int, CuttingTool> tools_;
};

/// All that the last tool of a mill did, as moves of one motion each.
void watch(ThreadWatch& threads, const CuttingTool& tool, Mill& mill, std::size_t first,
           Turning spindle = Turning::right) {
  mill.run();
  for (std::size_t i = first; i < mill.sweeps.size(); ++i) {
    threads.take({.tool = tool,
                  .block = {.line = static_cast<std::uint32_t>(i + 1)},
                  .motion = i + 1,
                  .spindle = spindle,
                  .sweeps = {&mill.sweeps[i], 1},
                  .outcomes = {&mill.outcomes[i], 1}});
  }
}

dexel::Shape block() { return dexel::box_shape({{-20, -20, -30}, {20, 20, 0}}); }

TEST(ThreadWatch, ATapMakesTheThreadThatItsHoleHolds) {
  Rack rack;
  const CuttingTool& tap = rack.add(2, "tap", {{M::diameter, 10}, {M::pitch, 1.5}});
  Mill mill(block(), 0.25);
  mill.tool(dexel::test::flat(8.376)).at({0, 0, 5}).line({0, 0, -25}).line({0, 0, 5});
  const std::size_t first = mill.sweeps.size();
  mill.tool(tap.body).at({0, 0, 5}).line({0, 0, -20}).line({0, 0, 5});
  ThreadWatch threads;
  watch(threads, tap, mill, first);
  const auto found = threads.threads(mill.model, rack);
  ASSERT_EQ(found.size(), 1U);
  const CutThread& thread = found.front();
  EXPECT_NEAR(thread.from.z, 0, 1e-5);
  EXPECT_NEAR(thread.to.z, -20 + 3, 1e-5);  // two pitches of chamfer
  EXPECT_NEAR(thread.major, 10, 1e-9);
  EXPECT_NEAR(thread.minor, 10 - 1.082531755 * 1.5, 1e-9);
  EXPECT_EQ(thread.hand, Hand::right);
  EXPECT_FALSE(thread.is_milled);
  // Trapezoids of 3/4 and 1/8 of the pitch, 5/8 H deep, summed in thin rings.
  double volume = 0;
  const double depth = 1.082531755 * 1.5 / 2;
  const int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double share = (i + 0.5) / n;
    const double width = 1.5 * (0.75 + share * (0.125 - 0.75));
    volume += 2 * pi * (thread.minor / 2 + share * depth) * width * depth / n;
  }
  EXPECT_NEAR(thread.volume_mm3, volume * 17 / 1.5, 1e-6 * thread.volume_mm3);
}

TEST(ThreadWatch, ThroughHolesAndPecksAndLeftHandsAndAirAreTold) {
  Rack rack;
  const CuttingTool& tap = rack.add(3, "tap", {{M::diameter, 6}, {M::pitch, 1}});
  Mill mill(block(), 0.25);
  const std::size_t first = mill.sweeps.size();
  mill.tool(tap.body).at({-10, 0, 5}).line({-10, 0, -20}).line({-10, 0, -18});
  mill.line({-10, 0, -36}).line({-10, 0, 5});             // through
  mill.at({30, 0, 5}).line({30, 0, -20});                 // beside the block
  mill.at({10, 0, 5}).line({10, 0, 1}).line({10, 0, 5});  // above it
  ThreadWatch threads;
  watch(threads, tap, mill, first, Turning::left);
  const auto found = threads.threads(mill.model, rack);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].hand, Hand::left);
  EXPECT_NEAR(found[0].to.z, -30, 1e-5);
  ThreadWatch stopped;
  watch(stopped, tap, mill, first, Turning::stopped);
  EXPECT_TRUE(stopped.threads(mill.model, rack).empty());
}

TEST(ThreadWatch, AHeightFieldTellsTheSameOfATap) {
  Rack rack;
  const CuttingTool& tap = rack.add(1, "tap", {{M::diameter, 8}, {M::pitch, 1.25}});
  field::HeightField field(field::grid_of({{-10, -10, -20}, {10, 10, -2}}, 0.25), 1);
  Sweep sweep{
      .way = StraightWay{{0, 0, 5}, {0, 0, -15}}, .body = field.add_body(tap.body), .motion = 1};
  Outcome outcome;
  field.cut({&sweep, 1}, {&outcome, 1});
  ThreadWatch threads;
  threads.take({.tool = tap,
                .block = {},
                .motion = 1,
                .spindle = Turning::right,
                .sweeps = {&sweep, 1},
                .outcomes = {&outcome, 1}});
  const auto found = threads.threads(field, rack);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].from.z, -2, 1e-5);
  EXPECT_NEAR(found[0].to.z, -12.5, 1e-5);
}

/// A cutter of one tooth on a helix, inside of a hole or round a boss.
struct Helix {
  double way = 0;  ///< radius
  double pitch = 0;
  double reach = 0;  ///< radius of the tool
  double depth = 0;  ///< of its tooth
};

/// Along the axis what a helix without end removes at a radius, each turn: how far the tooth
/// reaches up and down while it goes by, searched over its way.
double removed_at(double rho, const Helix& helix) {
  const double slope = std::tan(pi / 6);
  const double whole = 2 * helix.depth * slope + helix.pitch / 8;
  double low = 1e9;
  double high = -1e9;
  for (double angle = -1; angle <= 1; angle += 0.0005) {
    const double d =
        std::sqrt(rho * rho + helix.way * helix.way - 2 * rho * helix.way * std::cos(angle));
    if (d > helix.reach) continue;
    const double foot = std::max(0.0, (d - (helix.reach - helix.depth)) * slope);
    const double tip = helix.pitch * angle / (2 * pi);
    low = std::min(low, tip + foot);
    high = std::max(high, tip + whole - foot);
  }
  return std::clamp(high - low, 0.0, helix.pitch);
}

double removed_a_turn(const Helix& helix, double from, double to) {
  double sum = 0;
  const int n = 400;
  for (int i = 0; i < n; ++i) {
    const double rho = from + (to - from) * (i + 0.5) / n;
    sum += 2 * pi * rho * removed_at(rho, helix) * (to - from) / n;
  }
  return sum;
}

TEST(ThreadWatch, AThreadMillCutsTheRealHelixInAHole) {
  Rack rack;
  const CuttingTool& tool =
      rack.add(4, "thread-mill",
               {{M::diameter, 10}, {M::pitch, 2}, {M::neck_diameter, 7}, {M::flute_length, 3}});
  const double hole = 9;  // radius
  const Helix helix{.way = 5.25, .pitch = 2, .reach = 5, .depth = 1.5};
  const auto milled = [&](int turns) {
    Mill mill(block(), 0.1);
    mill.tool(dexel::test::flat(2 * hole)).at({0, 0, 5}).line({0, 0, -28}).line({0, 0, 5});
    mill.run();
    const double before = mill.model.left_mm3();
    const std::size_t first = mill.sweeps.size();
    mill.tool(tool.body).at({helix.way, 0, -20});
    mill.arc(0, 0, 2 * pi * turns, 2.0 * turns);
    ThreadWatch threads;
    watch(threads, tool, mill, first);
    return std::pair(before - mill.model.left_mm3(), threads.threads(mill.model, rack));
  };
  const auto [three, threads] = milled(3);
  const auto [five, more] = milled(5);
  const double formula = removed_a_turn(helix, hole, helix.way + helix.reach);
  EXPECT_NEAR((five - three) / 2, formula, 0.01 * formula);
  ASSERT_EQ(threads.size(), 1U);
  EXPECT_TRUE(threads[0].is_inside);
  EXPECT_TRUE(threads[0].is_milled);
  EXPECT_EQ(threads[0].hand, Hand::right);  // up against the clock
  EXPECT_NEAR(threads[0].pitch, 2, 1e-9);
  EXPECT_NEAR(threads[0].major, 2 * (5.25 + 5), 1e-9);
  EXPECT_NEAR(threads[0].minor, 20.5 - 1.082531755 * 2, 1e-9);
  EXPECT_NEAR(threads[0].volume_mm3, three, 0.02 * three);
  const double middle = 1.5 * std::tan(pi / 6) + 0.125;
  EXPECT_NEAR(threads[0].to.z, -20 + middle, 1e-6);
  EXPECT_NEAR(threads[0].from.z, -14 + middle, 1e-6);
}

TEST(ThreadWatch, RoundABossAndDownwardsIsALeftHandedOneOutside) {
  Rack rack;
  const CuttingTool& tool =
      rack.add(5, "thread-mill", {{M::diameter, 8}, {M::pitch, 1.5}, {M::teeth, 1}});
  Mill mill(dexel::round_shape({.axis = 2, .low = -30, .high = 0, .radius_mm = 10}), 0.2);
  mill.tool(tool.body).at({13, 0, -5});
  mill.arc(0, 0, 6 * pi, -4.5);
  mill.arc(0, 0, pi / 2, 0);  // a lead-out that goes on a little
  ThreadWatch threads;
  watch(threads, tool, mill, 0);
  const auto found = threads.threads(mill.model, rack);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].is_inside);
  EXPECT_EQ(found[0].hand, Hand::left);
  EXPECT_NEAR(found[0].minor, 18, 1e-9);
}

TEST(ThreadWatch, ALevelGrooveAndAQuarterTurnAreNoThreads) {
  Rack rack;
  const CuttingTool& tool = rack.add(6, "thread-mill", {{M::diameter, 8}, {M::pitch, 1.5}});
  Mill mill(dexel::round_shape({.axis = 2, .low = -30, .high = 0, .radius_mm = 10}), 0.3);
  mill.tool(tool.body).at({13, 0, -5}).arc(0, 0, 2 * pi, 0);
  mill.at({13, 0, -15}).arc(1, 0, pi / 2, 0.4);
  ThreadWatch threads;
  watch(threads, tool, mill, 0);
  EXPECT_TRUE(threads.threads(mill.model, rack).empty());
}

}  // namespace
}  // namespace kerf::stock
