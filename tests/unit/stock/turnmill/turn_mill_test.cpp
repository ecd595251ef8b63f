// Bars that are turned and milled, against closed formulas, and against what each half of the model
// says alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "geometry/contour/boolean.hpp"
#include "stock/turned/half_plane_lines.hpp"
#include "stock/turned/turned_job.hpp"
#include "stock/turnmill/revolved_shape.hpp"
#include "stock/turnmill/turn_mill_part.hpp"

namespace kerf::stock::turnmill {
namespace {

using std::numbers::pi;
using turned::Crossing;
using turned::HalfPlaneLines;
using turned::M;

constexpr double kCell_mm = 0.25;

Body mill(double diameter) {
  return turned::body_of(test::tool_of("flat", {{M::diameter, diameter}, {M::flute_length, 200}}));
}

/// A part, and sweeps of it: turned ones as in the plane of (X, Z), driven ones in space.
class TurnMill {
 public:
  TurnMill(double diameter, double from, double to, unsigned jobs = 1)
      : part_(turned::bar(diameter, from, to), kCell_mm, jobs) {}
  explicit TurnMill(const dexel::Shape& shape) : part_(shape, kCell_mm, 1) {}

  TurnMill& with(const Body& body, Vec3 axis = {0, 0, 1}) {
    body_ = part_.add_body(body);
    axis_ = axis;
    return *this;
  }
  TurnMill& turn(Vec3 from, Vec3 to, SweepKind kind = SweepKind::cut) {
    return make({.way = StraightWay{from, to}, .kind = kind, .is_turned = true});
  }
  TurnMill& drive(const Way& way, SweepKind kind = SweepKind::cut) {
    return make({.way = way, .axis = axis_, .kind = kind});
  }

  [[nodiscard]] TurnMillPart& part() { return part_; }
  [[nodiscard]] double gone() const { return part_.stock_mm3() - part_.left_mm3(); }
  [[nodiscard]] const Outcome& last() const { return last_; }
  [[nodiscard]] double told() const { return told_; }

 private:
  TurnMill& make(Sweep sweep) {
    sweep.body = body_;
    sweep.motion = ++motion_;
    last_ = {};
    part_.cut({&sweep, 1}, {&last_, 1});
    told_ += last_.removed.value();
    return *this;
  }

  TurnMillPart part_;
  BodyId body_ = 0;
  Vec3 axis_;
  std::uint32_t motion_ = 0;
  Outcome last_;
  double told_ = 0;
};

/// ∫ of f over [0, to] by Simpson's rule.
template <class F>
double integral(F f, double to, int steps = 200000) {
  double sum = f(0) + f(to);
  for (int i = 1; i < steps; ++i) sum += (i % 2 == 0 ? 2 : 4) * f(to * i / steps);
  return sum * to / steps / 3;
}

/// What a hole of radius r across a bar of radius R takes, through its axis: 8∫√(R²-x²)√(r²-x²)dx.
double cross_hole(double bar, double hole) {
  const auto slice = [&](double angle) {
    const double x = hole * std::sin(angle);
    return std::sqrt(bar * bar - x * x) * hole * hole * std::cos(angle) * std::cos(angle);
  };
  return 8 * integral(slice, pi / 2);
}

TEST(TurnMill, AHoleAcrossABarHasItsVolume) {
  for (const double angle : {0.0, 0.6, pi / 2}) {
    const Vec3 up{std::cos(angle), std::sin(angle), 0};
    TurnMill job(40, -60, 0);
    job.with(mill(12), up);
    job.drive(StraightWay{25 * up + Vec3{0, 0, -30}, -25 * up + Vec3{0, 0, -30}});
    const double formula = cross_hole(20, 6);
    EXPECT_NEAR(job.gone(), formula, 0.05 * kCell_mm * formula) << angle;
    EXPECT_LE(std::fabs(job.gone() - formula), job.part().error_mm3()) << angle;
    EXPECT_NEAR(job.told(), formula, 0.05 * kCell_mm * formula) << angle;
  }
}

TEST(TurnMill, WhatIsTurnedIsExactAlsoBesideHoles) {
  TurnMill job(50, -80, 0);
  job.with(turned::turning(0));
  job.turn({20, 0, 2}, {20, 0, -60}).turn({20, 0, -60}, {26, 0, -60});
  const double turned = pi * (25 * 25 - 20 * 20) * 60;
  EXPECT_NEAR(job.gone(), turned, 1e-9 * turned);
  job.with(mill(12));
  job.drive(StraightWay{{12, 0, 5}, {12, 0, -20}});
  const double hole = pi * 36 * 20;
  EXPECT_NEAR(job.gone(), turned + hole, 0.05 * kCell_mm * hole);
  EXPECT_LE(std::fabs(job.gone() - turned - hole), job.part().error_mm3());
  // Facing behind the hole takes a ring less what the hole had taken of it.
  job.with(turned::turning(0));
  job.turn({26, 0, -3}, {-1, 0, -3});
  const double faced = (pi * 20 * 20 - pi * 36) * 3;
  EXPECT_NEAR(job.last().removed.value(), faced, 0.02 * faced);
  EXPECT_NEAR(job.gone(), turned + hole + faced, 0.05 * kCell_mm * hole);
}

TEST(TurnMill, ProfileAndDexelsOfOneBarAgree) {
  TurnMill job(50, -80, 0);
  job.with(turned::turning(0.8));
  job.turn({20, 0, 2}, {20, 0, -60}).turn({20, 0, -60}, {26, 0, -60});
  job.turn({15, 0, 1}, {15, 0, -5}).turn({15, 0, -5}, {21, 0, -20});
  job.with(turned::drill(10));
  job.turn({0, 0, 5}, {0, 0, -25});
  job.part().catch_up();
  const double exact = job.part().profile().left_mm3();
  const auto grids = job.part().dexels().grids_mm3();
  // Half a cell of all faces, as if every dexel were wrong to the same side.
  const double faces = 2 * pi * 25 * 80;
  for (const double one : grids) EXPECT_NEAR(one, exact, 0.05 * kCell_mm * faces);
  EXPECT_EQ(job.part().error_mm3(), 0);
  EXPECT_NEAR(job.part().left_mm3(), exact, 1e-6 * exact);
  EXPECT_NEAR(job.part().extents().high.x, 25, 1e-4);
  EXPECT_NEAR(job.part().extents().low.z, -80, 1e-4);
}

TEST(TurnMill, TurningInManyPassesOrInOneLeavesTheSameDexels) {
  const auto turned_by = [](bool first, TurnMill& job) {
    if (first) job.with(mill(6)).drive(StraightWay{{12, 0, 5}, {12, 0, -8}});
    job.with(turned::turning(0.4));
    for (int i = 1; i <= 8; ++i) job.turn({25 - 0.5 * i, 0, 2}, {25 - 0.5 * i, 0, -50 - 0.1 * i});
    if (!first) job.with(mill(6)).drive(StraightWay{{12, 0, 5}, {12, 0, -8}});
  };
  TurnMill before(50, -80, 0);
  TurnMill after(50, -80, 0);
  turned_by(true, before);
  turned_by(false, after);
  const auto a = before.part().dexels().grids_mm3();
  const auto b = after.part().dexels().grids_mm3();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-6 * b[i]) << i;
  EXPECT_NEAR(before.gone(), after.gone(), 1e-6 * after.gone());
}

TEST(TurnMill, AToolThatComesWhereEverythingIsMilledAwayMeetsNothing) {
  TurnMill job(40, -60, 0);
  // All round with a mill of 16 on a circle: a pin of 20 is left.
  job.with(mill(16));
  job.drive(ArcWay{{0, 0, -10}, {}, {1, 0, 0}, {0, 1, 0}, 18, 0, 0, 2 * pi});
  const double ring = pi * (400 - 100) * 10;
  EXPECT_NEAR(job.gone(), ring, 0.05 * kCell_mm * ring);
  job.with(turned::turning(0.4));
  job.turn({30, 0, -8}, {10.5, 0, -8}, SweepKind::rapid);
  EXPECT_FALSE(job.last().contacts[index(ToolPart::edge)].is_one());
  EXPECT_LT(job.last().removed.value(), 1e-6);
  job.turn({10.5, 0, -8}, {9, 0, -8}, SweepKind::rapid);
  EXPECT_TRUE(job.last().contacts[index(ToolPart::edge)].is_one());
}

TEST(TurnMill, ASquareBarIsTurnedRound) {
  TurnMill job(dexel::box_shape({{-20, -20, -60}, {20, 20, 0}}));
  job.with(turned::turning(0, 3, 60));
  job.turn({10, 0, 2}, {10, 0, -40}).turn({10, 0, -40}, {30, 0, -40});
  const double formula = (40 * 40 - pi * 100) * 40;
  EXPECT_NEAR(job.gone(), formula, 0.05 * kCell_mm * formula);
  EXPECT_NEAR(job.told(), formula, 0.05 * kCell_mm * formula);
  EXPECT_NEAR(job.part().extents().high.x, std::hypot(20, 20), 2 * kCell_mm);
}

TEST(TurnMill, NeitherThreadsNorCallsChangeABit) {
  const auto job = [](unsigned jobs) {
    auto made = std::make_unique<TurnMill>(30, -40, 0, jobs);
    made->with(turned::turning(0.4)).turn({12, 0, 2}, {12, 0, -20});
    made->with(mill(8), {1, 0, 0}).drive(StraightWay{{18, 0, -10}, {-18, 0, -10}});
    made->with(turned::turning(0.4)).turn({16, 0, -1}, {-1, 0, -1});
    return made;
  };
  const auto one = job(1);
  for (const unsigned jobs : {2U, 7U}) {
    const auto other = job(jobs);
    EXPECT_EQ(one->told(), other->told());
    EXPECT_EQ(one->gone(), other->gone());
    for (int grid = 0; grid < 3; ++grid) {
      const dexel::TriDexel& a = one->part().dexels();
      const dexel::TriDexel& b = other->part().dexels();
      for (std::size_t t = 0; t < a.tiles(grid); ++t)
        EXPECT_EQ(a.save(grid, t), b.save(grid, t)) << grid << " " << t;
    }
  }
}

// A line across arcs, holes and islands: what is inside of it adds up to what a grid of points
// says.
TEST(HalfPlaneLines, SayWhatPointsSay) {
  contour::Region region = contour::region_of(
      std::vector<contour::Contour>{{{{{-20, 2}}, {{-3, 2}, 0.6}, {{-3, 9}, -0.4}, {{-20, 9}}}}});
  region = contour::unite(region, contour::disc({-12, 9}, 4));
  region = contour::subtract(region, contour::disc({-10, 6}, 2));
  const HalfPlaneLines lines(region);
  std::vector<Crossing> found;
  for (double at = -21.037; at < 14; at += 0.211) {
    for (const bool is_along_u : {true, false}) {
      is_along_u ? lines.along_u(at, found) : lines.along_v(at, found);
      ASSERT_EQ(found.size() % 2, 0U);
      for (double place = -25.013; place < 15; place += 0.173) {
        const contour::Vec2 point =
            is_along_u ? contour::Vec2{place, at} : contour::Vec2{at, place};
        if (contour::distance_to_border(region, point) < 1e-3) continue;
        const auto before = std::count_if(found.begin(), found.end(),
                                          [&](const Crossing& c) { return c.at < place; });
        const bool is_inside = contour::side_of(region, point, 0) == contour::Side::inside;
        EXPECT_EQ(before % 2 == 1, is_inside) << at << " " << place;
      }
      for (const Crossing& c : found) {
        const contour::Vec2 point = is_along_u ? contour::Vec2{c.at, at} : contour::Vec2{at, c.at};
        EXPECT_NEAR(contour::distance_to_border(region, point), 0, 1e-9);
        EXPECT_NEAR(geometry::length(c.normal), 1, 1e-9);
        EXPECT_EQ(contour::side_of(region, point + 1e-4 * c.normal, 0), contour::Side::outside);
      }
    }
  }
}

// A torus by its region: dexels of each direction against 2π²Rr².
TEST(RevolvedShape, ATorusHasItsVolumeOfEachGrid) {
  const dexel::Shape shape = revolved_shape(contour::disc({-5, 12}, 4), 0);
  const double formula = 2 * pi * pi * 12 * 16;
  EXPECT_NEAR(shape.volume_mm3, formula, 1e-9 * formula);
  const dexel::TriDexel dexels(shape, 0.2, 1);
  for (const double one : dexels.grids_mm3()) EXPECT_NEAR(one, formula, 0.002 * formula);
}

}  // namespace
}  // namespace kerf::stock::turnmill
