#include "stock/cutting/cutting_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "stock/cutting/cut_clock.hpp"

namespace kerf::stock {
namespace {

Tool tool_of(ToolKind kind, double diameter) {
  Tool tool;
  tool.number = 1;
  tool.kind = kind;
  tool.type = row_of(kind).names.front();
  tool.measures.set(Measure::diameter, diameter);
  return tool;
}

/// A way across that removed all between two distances from it.
Outcome side_cut(double from, double to, double ap, double length, double radius) {
  Outcome outcome;
  const double h = 0.01;
  for (int i = 0; i < static_cast<int>(std::lround((to - from) / h)); ++i) {
    const double s = from + (i + 0.5) * h;
    const Exact volume(h * ap * length);
    outcome.across[static_cast<std::size_t>((s + radius) / (2 * radius) * Outcome::kBins)] +=
        volume;
    outcome.removed += volume;
    outcome.aside.add(s);
  }
  outcome.heights.add(0);
  outcome.heights.add(ap);
  return outcome;
}

struct Milled {
  CuttingData data;
  double kw = 0;
  double nm = 0;
};

/// The example of stock.md §6: D10, three teeth, 3000 rpm, F900, 5 deep.
Milled milled(double ae) {
  Tool tool = tool_of(ToolKind::flat, 10);
  tool.measures.set(Measure::flutes, 3);
  const CuttingTool mill = cutting_tool(tool, 0.01);
  const Outcome outcome = side_cut(5 - ae, 5, 5, 60, 5);
  Milled milled;
  milled.data = cutting_data({.tool = mill,
                              .outcome = outcome,
                              .feed = {900},
                              .has_feed = true,
                              .length_mm = 60,
                              .grain_mm = 0.01,
                              .rpm = 3000,
                              .material = material_named("P")});
  const double time_s = 60 / (900.0 / 60);
  milled.kw = removal_kw(milled.data.told_mm3 / time_s, milled.data.kc);
  milled.nm = torque_nm(milled.kw, 3000);
  return milled;
}

TEST(CuttingData, OfAMillAtTheSide) {
  const Milled side = milled(2);
  EXPECT_NEAR(side.data.fz_mm, 0.1, 1e-12);
  EXPECT_NEAR(side.data.vc_m_min, std::numbers::pi * 30, 1e-9);
  EXPECT_NEAR(side.data.engagement.phi_rad * 180 / std::numbers::pi, 53.1301024, 1e-6);
  EXPECT_NEAR(side.data.hm_mm, 0.0431362086, 1e-9);
  EXPECT_NEAR(side.data.kc, 3730.25420, 1e-4);
  EXPECT_NEAR(side.kw, 0.559538131, 1e-7);
  EXPECT_NEAR(side.nm, 1.78106519, 1e-6);
}

TEST(CuttingData, OfASlot) {
  const Milled slot = milled(10);
  EXPECT_NEAR(slot.data.hm_mm, 0.0636619772, 1e-9);
  EXPECT_NEAR(slot.data.kc, 3384.37821, 1e-4);
  EXPECT_NEAR(slot.kw, 2.53828366, 1e-6);
}

// A second method: the chip of a tooth at the angle ψ is fz·sin ψ thick; its mean over the
// engagement is what the formula says.
TEST(CuttingData, TheMeanChipIsTheMeanOverTheEngagement) {
  for (const double ae : {0.5, 2.0, 5.0, 9.0}) {
    const double phi = std::acos(1 - 2 * ae / 10);
    constexpr int kSteps = 200'000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) sum += 0.1 * std::sin(phi * (i + 0.5) / kSteps);
    EXPECT_NEAR(milled(ae).data.hm_mm, sum / kSteps, 1e-8) << ae;
  }
}

TEST(CuttingData, OfADrill) {
  Tool tool = tool_of(ToolKind::drill, 10);
  tool.measures.set(Measure::angle, 118);
  const CuttingTool drill = cutting_tool(tool, 0.01);
  Outcome outcome;
  outcome.removed = Exact(1000);
  outcome.aside = {0, 5};
  CutFacts facts{.tool = drill,
                 .outcome = outcome,
                 .feed = {400},
                 .has_feed = true,
                 .length_mm = 20,
                 .rpm = 2000,
                 .is_axial = true,
                 .material = material_named("P")};
  const CuttingData data = cutting_data(facts);
  EXPECT_NEAR(specific_force(*facts.material, data.hm_mm), 3141.82884, 1e-4);
  EXPECT_NEAR(data.feed_kw, 1.64505774, 1e-7);
  // P = f·vc·D·kc / 240000.
  const double vc = std::numbers::pi * 10 * 2000 / 1000;
  EXPECT_NEAR(data.feed_kw, 0.2 * vc * 10 * 3141.82884 / 240000, 1e-6);
  // In a hole of half its width three quarters of the section are left.
  outcome.aside = {2.5, 5};
  EXPECT_NEAR(cutting_data(facts).feed_kw, 0.75 * data.feed_kw, 1e-9);
}

TEST(CuttingData, OfAnInsertThatTurns) {
  Tool tool = tool_of(ToolKind::turning, 0);
  tool.measures = {};
  tool.measures.set(Measure::kapr, 95);
  const CuttingTool insert = cutting_tool(tool, 0.01);
  Outcome outcome;
  outcome.removed = Exact(1000);
  outcome.section = Exact(2.5 * 40);
  const double radius = 30;
  const CuttingData data = cutting_data({.tool = insert,
                                         .outcome = outcome,
                                         .feed = {0.3, motion::FeedMode::per_revolution},
                                         .has_feed = true,
                                         .length_mm = 40,
                                         .rpm = 200 * 1000 / (2 * std::numbers::pi * radius),
                                         .turns_work = true,
                                         .radius_mm = radius,
                                         .material = material_named("P")});
  EXPECT_NEAR(data.engagement.ap_mm, 2.5, 1e-9);
  EXPECT_NEAR(data.vc_m_min, 200, 1e-9);
  EXPECT_NEAR(turning_force_n({1700, 0.25}, 2.5, 0.3, std::sin(95 * std::numbers::pi / 180)),
              1724.42303, 1e-4);
  EXPECT_NEAR(data.feed_kw, 5.74807678, 1e-6);
}

TEST(CuttingData, OfUnknownTeethIsNotTold) {
  const CuttingTool mill = cutting_tool(tool_of(ToolKind::flat, 10), 0.01);
  const Outcome outcome = side_cut(3, 5, 5, 60, 5);
  const CuttingData data = cutting_data({.tool = mill,
                                         .outcome = outcome,
                                         .feed = {900},
                                         .has_feed = true,
                                         .length_mm = 60,
                                         .grain_mm = 0.01,
                                         .rpm = 3000,
                                         .material = material_named("P")});
  EXPECT_EQ(data.fz_mm, 0);
  EXPECT_EQ(data.hm_mm, 0);
  EXPECT_EQ(data.kc, 0);
  EXPECT_GT(data.engagement.ae_mm, 0);
}

TEST(CuttingForce, GroupsAreThoseOfTheTable) {
  EXPECT_EQ(material_named("K")->kc11, 1100);
  EXPECT_EQ(material_named("K")->mc, 0.28);
  EXPECT_FALSE(material_named("X").has_value());
}

/// Notes what it gets.
struct Cuts final : TimedCutSink {
  void take(const TimedCut& cut) override { cuts.push_back(cut); }
  std::vector<TimedCut> cuts;
};

MotionCut cut_of(std::uint64_t motion, double removed) {
  MotionCut cut;
  cut.motion = motion;
  cut.removed_mm3 = cut.data.told_mm3 = removed;
  return cut;
}

TEST(CutClock, JoinsMotionsWithTheirEndsWhicheverComesFirst) {
  for (const bool ends_first : {true, false}) {
    CutClock clock;
    Cuts cuts;
    clock.add_sink(cuts);
    const auto tell_ends = [&] {
      clock.motion_ends(1, 2);
      clock.motion_ends(2, 3);  // a dwell
      clock.motion_ends(4, 7);
    };
    if (ends_first) tell_ends();
    for (const std::uint64_t motion : {1U, 3U, 4U, 5U}) clock.take(cut_of(motion, 8));
    if (!ends_first) tell_ends();
    clock.finish(9);
    ASSERT_EQ(cuts.cuts.size(), 4U);
    EXPECT_EQ(cuts.cuts[0].start_s, 0);
    EXPECT_EQ(cuts.cuts[0].end_s, 2);
    EXPECT_EQ(cuts.cuts[0].mrr_mm3_s, 4);
    EXPECT_EQ(cuts.cuts[1].start_s, 3);  // it goes nowhere: no time
    EXPECT_EQ(cuts.cuts[1].end_s, 3);
    EXPECT_EQ(cuts.cuts[2].start_s, 3);
    EXPECT_EQ(cuts.cuts[2].end_s, 7);
    EXPECT_EQ(cuts.cuts[3].end_s, 9);
  }
}

}  // namespace
}  // namespace kerf::stock
