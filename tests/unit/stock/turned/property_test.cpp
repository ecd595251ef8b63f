// What holds for turning whatever is turned: points of many moments, orders, parts, mirrors.
#include <gtest/gtest.h>

#include <random>

#include "geometry/contour/boolean.hpp"
#include "stock/turned/revolved.hpp"
#include "stock/turned/tip_path.hpp"
#include "stock/turned/turned_job.hpp"

namespace kerf::stock::turned {
namespace {

using contour::Region;
using contour::Vec2;
using std::numbers::pi;

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  int one_of(int count) { return static_cast<int>(between(0, count)); }

 private:
  std::mt19937_64 engine_;
};

Body random_tool(Dice& dice) {
  switch (dice.one_of(5)) {
    case 0: return turning(0.8, 3, 12.7);
    case 1: return turning(0.4, 2, 6.35);
    case 2: return turning(0, 4, 9.525);
    case 3: return blade(3, 3, 0.4);
    default: return drill(10);
  }
}

/// A move near the bar, sometimes across the axis.
void random_move(Dice& dice, Job& job) {
  if (dice.one_of(3) == 0) {
    const double x = 2 * job.place().x;
    job.turn(x + dice.between(-30, 30), job.place().z + dice.between(-15, 15), dice.between(-3, 3));
  } else {
    job.to(dice.between(-20, 60), dice.between(-50, 10));
  }
}

Region section_of(const Body& body) { return TurnedTool(body).cutter().whole; }

double depth_in(const Region& region, Vec2 point) {
  const double away = contour::distance_to_border(region, point);
  return contour::side_of(region, point, 0) == contour::Side::inside ? away : -away;
}

/// Deepest that a point of the part, or the one that it is on the far side, ever was in the tool.
double deepest(const Region& tool, const Way& way, Vec2 point, int steps) {
  double best = -1e9;
  for (int i = 0; i <= steps; ++i) {
    const Vec3 tip = point_at(way, static_cast<double>(i) / steps);
    best = std::max({best, depth_in(tool, point - Vec2{tip.z, tip.x}),
                     depth_in(tool, Vec2{point.u, -point.v} - Vec2{tip.z, tip.x})});
  }
  return best;
}

TEST(TurnedProperty, PointsAreGoneWhereTheToolWas) {
  Dice dice(861);
  constexpr int kSteps = 150;
  for (int round = 0; round < 40; ++round) {
    Job job(50, -40, 0);
    const Body body = random_tool(dice);
    const Region tool = section_of(body);
    job.with(body).at(dice.between(0, 80), dice.between(-40, 20));
    for (int i = 0; i < 3; ++i) random_move(dice, job);
    for (int i = 0; i < 60; ++i) {
      const Vec2 point{dice.between(-40, 0), dice.between(0, 25)};
      double depth = -1e9;
      double step = 0;
      for (const Sweep& sweep : job.sweeps()) {
        depth = std::max(depth, deepest(tool, sweep.way, point, kSteps));
        step = std::max(step, length(sweep.way) / kSteps);
      }
      const auto side = contour::side_of(job.part().region(), point, 1e-6);
      if (depth > 1e-5) {
        EXPECT_NE(side, contour::Side::inside) << "round " << round;
      } else if (depth < -step) {
        EXPECT_NE(side, contour::Side::outside) << "round " << round;
      }
    }
    EXPECT_NEAR(job.removed() + job.part().left_mm3(), job.part().stock_mm3(),
                1e-9 * job.part().stock_mm3());
  }
}

TEST(TurnedProperty, CutTwiceRemovesNothingTheSecondTime) {
  Dice dice(862);
  for (int round = 0; round < 60; ++round) {
    Job job(50, -40, 0);
    job.with(random_tool(dice)).at(dice.between(0, 80), dice.between(-40, 20));
    for (int i = 0; i < 4; ++i) random_move(dice, job);
    const std::vector<Sweep> sweeps = job.sweeps();
    const double left = job.part().left_mm3();
    for (const Sweep& sweep : sweeps) {
      job.make(sweep);
      EXPECT_EQ(job.last().removed.value(), 0);
    }
    EXPECT_EQ(job.part().left_mm3(), left);
  }
}

TEST(TurnedProperty, AMoveIsTheSumOfItsParts) {
  Dice dice(863);
  for (int round = 0; round < 60; ++round) {
    const Body body = random_tool(dice);
    Job whole(50, -40, 0);
    Job parts(50, -40, 0);
    whole.with(body).at(dice.between(0, 80), dice.between(-40, 20));
    parts.with(body);
    random_move(dice, whole);
    const Way way = whole.sweeps().front().way;
    const double t = dice.between(0.1, 0.9);
    if (const auto* const line = std::get_if<StraightWay>(&way)) {
      parts.make({.way = part(*line, 0, t)}).make({.way = part(*line, t, 1)});
    } else {
      const auto& arc = std::get<ArcWay>(way);
      parts.make({.way = part(arc, 0, t)}).make({.way = part(arc, t, 1)});
    }
    EXPECT_LT(
        contour::area(contour::symmetric_difference(whole.part().region(), parts.part().region())),
        1e-6);
    EXPECT_NEAR(whole.removed(), parts.removed(), 1e-5);
  }
}

TEST(TurnedProperty, OrderDoesNotMatter) {
  Dice dice(864);
  for (int round = 0; round < 40; ++round) {
    const Body body = random_tool(dice);
    Job there(50, -40, 0);
    there.with(body).at(dice.between(0, 80), dice.between(-40, 20));
    for (int i = 0; i < 4; ++i) random_move(dice, there);
    Job back(50, -40, 0);
    back.with(body);
    const std::vector<Sweep>& sweeps = there.sweeps();
    for (auto sweep = sweeps.rbegin(); sweep != sweeps.rend(); ++sweep) back.make(*sweep);
    EXPECT_LT(
        contour::area(contour::symmetric_difference(there.part().region(), back.part().region())),
        1e-6);
  }
}

TEST(TurnedProperty, AcrossTheAxisCountsAtItsRadius) {
  Dice dice(865);
  for (int round = 0; round < 30; ++round) {
    Job behind(50, -40, 0);
    Job before(50, -40, 0);
    behind.with(turning(0.8, 3, 12.7)).at(70, 5);
    before.with(turning(0.8, 2, 12.7)).at(-70, 5);
    for (int i = 0; i < 3; ++i) {
      const double x = dice.between(0, 60);
      const double z = dice.between(-40, 5);
      behind.to(x, z);
      before.to(-x, z);
    }
    EXPECT_LT(contour::area(
                  contour::symmetric_difference(behind.part().region(), before.part().region())),
              1e-6);
    EXPECT_NEAR(behind.removed(), before.removed(), 1e-6);
  }
}

TEST(TurnedProperty, EveryEdgeKnowsItsMotion) {
  Job job(50, -80, 0);
  job.with(turning(0)).at(54, 2).rapid(40, 2).to(40, -60).to(52, -60);
  std::size_t cut = 0;
  for (const contour::Vertex& vertex : job.part().region().loops.front().vertices) {
    EXPECT_TRUE(vertex.owner == 0 || vertex.owner == 2 || vertex.owner == 3);
    cut += vertex.owner == 2 ? 1 : 0;
  }
  EXPECT_GE(cut, 1U);
}

/// The same body by rings of many radii.
double by_rings(const Region& region, int steps) {
  const contour::Box box = contour::extents(region);
  double sum = 0;
  const double du = (box.high.u - box.low.u) / steps;
  const double dv = (box.high.v - box.low.v) / steps;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const Vec2 point{box.low.u + (i + 0.5) * du, box.low.v + (j + 0.5) * dv};
      int winding = 0;
      for (const auto& loop : region.loops) winding += contour::winding(loop, point);
      if (winding > 0) sum += 2 * pi * point.v * du * dv;
    }
  }
  return sum;
}

TEST(TurnedVolume, IsThatOfItsRings) {
  Dice dice(866);
  for (int round = 0; round < 20; ++round) {
    contour::Contour loop;
    for (int i = 0; i < 6; ++i) {
      const double angle = 2 * pi * (i + dice.between(0, 0.6)) / 6;
      loop.vertices.push_back({{8 * std::cos(angle), 20 + 8 * std::sin(angle)},
                               dice.between(0, 1) < 0.5 ? 0 : dice.between(-0.3, 0.9)});
    }
    const Region region = contour::region_of(loop);
    EXPECT_NEAR(volume(region) / by_rings(region, 400), 1, 4e-3);
  }
}

TEST(TurnedVolume, OfABallAndATorus) {
  const Region ball = contour::intersect(
      contour::disc({}, 10),
      contour::region_of(contour::Contour{{{{-20, 0}}, {{20, 0}}, {{20, 20}}, {{-20, 20}}}}));
  EXPECT_NEAR(volume(ball) / (4000 * pi / 3), 1, 1e-12);
  EXPECT_NEAR(volume(contour::disc({5, 30}, 4)) / (2 * pi * pi * 30 * 16), 1, 1e-12);
}

// An arc that is nearly straight is nearly its chord.
TEST(TurnedVolume, OfFlatArcsLosesNoDigits) {
  for (const double bulge : {1e-3, 1e-5, 1e-8, 1e-12}) {
    const contour::Contour bent{{{{0, 0}}, {{100, 0}}, {{100, 20}, bulge}, {{0, 20}}}};
    // A parabola of the same height: 2π ∫∫ρ over it, but for the square of the bulge.
    const double height = 50 * bulge;
    const double more = 2 * pi * (2.0 / 3 * 100 * height) * (20 + 0.4 * height);
    EXPECT_NEAR(volume({{bent}}), pi * 400 * 100 + more, 1e-9 * pi * 40000 + more * bulge * bulge);
  }
}

}  // namespace
}  // namespace kerf::stock::turned
