// What is cut through a window is what is cut of the whole.
#include "stock/turned/window.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/contour/boolean.hpp"
#include "stock/turned/material.hpp"
#include "stock/turned/turned_job.hpp"

namespace kerf::stock::turned {
namespace {

using contour::Contour;
using contour::Region;
using contour::Vec2;

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_;
};

/// A part of many edges, hollow, with a cavity and a ring beside it.
Region wavy(Dice& dice) {
  Contour loop{{{{-100, 0}}, {{0, 0}}}};
  for (int i = 0; i <= 60; ++i) {
    const double bulge = i == 60 || dice.between(0, 1) < 0.5 ? 0 : dice.between(-0.5, 0.5);
    loop.vertices.push_back({{-100.0 * i / 60, 20 + dice.between(-4, 4)}, bulge});
  }
  const Region outer = contour::region_of(loop);
  const Region hollow = contour::subtract(outer, contour::disc({-50, 8}, 5));
  return contour::unite(hollow, contour::disc({10, 20}, 4));
}

std::vector<Contour> random_tool(Dice& dice) {
  const Region disc = contour::disc({}, dice.between(0.5, 12));
  const Vec2 from{dice.between(-110, 20), dice.between(0, 40)};
  const Vec2 to = from + Vec2{dice.between(-20, 20), dice.between(-20, 20)};
  return swept(disc, false, {{{from, to, dice.between(-1, 1)}}, 7});
}

contour::Box box_of(const std::vector<Contour>& loops) {
  contour::Box box;
  for (const Contour& loop : loops) box.take(contour::extents(loop));
  return box;
}

TEST(TurnedWindow, CutsWhatTheWholeWouldLose) {
  Dice dice(86);
  for (int round = 0; round < 300; ++round) {
    const Region part = wavy(dice);
    const std::vector<Contour> tool = random_tool(dice);
    const contour::Division some = Material(part).divide(tool, box_of(tool));
    const contour::Division all = contour::divide(part, tool);
    EXPECT_LT(contour::area(contour::symmetric_difference(some.inside, all.inside)), 1e-6);
    EXPECT_LT(contour::area(contour::symmetric_difference(some.outside, all.outside)), 1e-6);
    EXPECT_EQ(some.outside.loops.size(), all.outside.loops.size());
  }
}

TEST(TurnedWindow, PutsBackWhatNothingHasCut) {
  Dice dice(87);
  int seen = 0;
  for (int round = 0; round < 200; ++round) {
    const Region part = wavy(dice);
    const Vec2 low{dice.between(-110, 10), dice.between(-5, 20)};
    const Window window(part, {low, low + Vec2{dice.between(1, 60), dice.between(1, 30)}});
    ASSERT_TRUE(window.is_good());
    const auto whole = window.with(contour::divide(window.seen(), {}).outside);
    ASSERT_TRUE(whole.has_value());
    EXPECT_EQ(contour::vertex_count(*whole), contour::vertex_count(part));
    EXPECT_NEAR(contour::area(*whole), contour::area(part), 1e-9 * contour::area(part));
    seen += window.seen().is_empty() ? 0 : 1;
  }
  EXPECT_GT(seen, 100);
}

}  // namespace
}  // namespace kerf::stock::turned
