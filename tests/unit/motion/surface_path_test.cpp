// Properties of moves on a face and on a cylinder, over random figures: against the figure in its
// plane.
#include "motion/surface_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "motion_axes.hpp"
#include "planner/interpolator.hpp"
#include "seeded_random.hpp"

namespace kerf::motion {
namespace {

using base::Axis;
using base::TipPoint;
using geometry::Vec2;
using test::kSeed;
using test::SeededRandom;

constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 1;
constexpr std::size_t kC = 2;
constexpr int kFigures = 2000;

const AxisSetup kAxes = test::axes_named("XZC");

double distance(Vec2 a, Vec2 b) { return std::hypot(a.u - b.u, a.v - b.v); }

Surface face(double side) {
  Surface surface;
  surface.first = Axis{kX};
  surface.rotary = Axis{kC};
  surface.centre_mm = 3;
  surface.zero_deg = 25;
  surface.side = side;
  return surface;
}

Surface cylinder(double radius_mm) {
  Surface surface;
  surface.kind = Surface::Kind::cylinder;
  surface.first = Axis{kZ};
  surface.rotary = Axis{kC};
  surface.radius_mm = radius_mm;
  return surface;
}

/// A figure in the plane, by formulas of its own.
struct Figure {
  Vec2 from;
  SurfaceMove move;
  double length = 0;
  double sweep_rad = 0;

  [[nodiscard]] Vec2 centre() const { return {move.about[0], move.about[1]}; }
  [[nodiscard]] Vec2 to() const { return {move.flat_to[0], move.flat_to[1]}; }
  [[nodiscard]] Vec2 at(double way) const {
    const double share = way / length;
    if (!move.is_arc) return from + share * (to() - from);
    const Vec2 arm = from - centre();
    const double angle = share * sweep_rad;
    return centre() + Vec2{arm.u * std::cos(angle) - arm.v * std::sin(angle),
                           arm.u * std::sin(angle) + arm.v * std::cos(angle)};
  }
  [[nodiscard]] double off(Vec2 point) const {
    if (move.is_arc) return std::fabs(distance(point, centre()) - distance(from, centre()));
    const Vec2 way = to() - from;
    const double foot = std::clamp(dot(point - from, way) / dot(way, way), 0.0, 1.0);
    return distance(point, from + foot * way);
  }
};

class RandomFigures : public SeededRandom {
 public:
  RandomFigures() : SeededRandom(kSeed) {}

  // Some end near the centre, some go near it, some are radial.
  Vec2 end(Vec2 from) {
    switch (count(0, 5)) {
      case 0: return size(1e-3, 1) * direction();
      case 1: return size(0.01, 3) * from;
      case 2: return -size(0.1, 3) * from + size(1e-5, 0.1) * left_of(unit(from));
      default: return size(0.01, 100) * direction();
    }
  }
  Figure line(const Surface& surface, Vec2 from) {
    Figure figure{from, {}};
    const Vec2 to = end(from);
    figure.move.surface = surface;
    figure.move.flat_to = {to.u, to.v};
    figure.length = distance(from, to);
    return figure;
  }
  Figure arc(const Surface& surface, Vec2 from) {
    Figure figure{from, {}};
    SurfaceMove& move = figure.move;
    move.surface = surface;
    move.is_arc = true;
    const Vec2 about = coin() ? from + size(0.01, 100) * direction() : size(1e-3, 1) * direction();
    move.about = {about.u, about.v};
    figure.sweep_rad = (coin() ? 1 : -1) * in(0.01, 2 * std::numbers::pi);
    move.direction = figure.sweep_rad > 0 ? Direction::counterclockwise : Direction::clockwise;
    figure.length = std::fabs(figure.sweep_rad) * distance(from, about);
    const Vec2 to = figure.at(figure.length);
    move.flat_to = {to.u, to.v};
    return figure;
  }
  Figure figure(const Surface& surface, Vec2 from) {
    return coin() ? line(surface, from) : arc(surface, from);
  }

 private:
  Vec2 direction() {
    const double angle = in(-std::numbers::pi, std::numbers::pi);
    return {std::cos(angle), std::sin(angle)};
  }
};

TipPoint start_on(const Surface& surface) {
  return surface.kind == Surface::Kind::face ? TipPoint{{3 + surface.side * 40, 0, 25}}
                                             : TipPoint{{40, 0, 25}};
}

std::vector<Curve> curves_of(const TipPoint& from, const SurfaceMove& move) {
  std::vector<Curve> curves;
  const SurfacePath path(kAxes, from, move, [&](const Curve& curve) { curves.push_back(curve); });
  return curves;
}

/// Calls `see(figure, curves)` with figures one behind the other.
template <typename See>
void along_random_figures(const Surface& surface, See&& see) {
  RandomFigures random;
  TipPoint at = start_on(surface);
  for (int i = 0; i < kFigures; ++i) {
    const Figure figure = random.figure(surface, flat_of(surface, at));
    const auto curves = curves_of(at, figure.move);
    ASSERT_FALSE(curves.empty());
    see(figure, curves);
    at = end_of(kAxes, at, figure.move);
    if (std::fabs(at.values[kX]) > 1000) at = start_on(surface);
  }
}

const Surface kSurfaces[] = {face(1), face(-1), cylinder(20)};

TEST(SurfacePath, LiesOnTheFigure) {
  constexpr int kPlaces = 7;
  for (const Surface& surface : kSurfaces) {
    along_random_figures(surface, [&](const Figure& figure, const std::vector<Curve>& curves) {
      double way = 0;
      for (const Curve& curve : curves) {
        for (int n = 0; n <= kPlaces; ++n) {
          const double s = curve.length() * n / kPlaces;
          const Vec2 flat = flat_of(surface, curve.at(s));
          ASSERT_LT(distance(flat, figure.at(way + s)), 1e-9);
        }
        way += curve.length();
      }
      ASSERT_NEAR(way, figure.length, 1e-9 * (1 + figure.length));
    });
  }
}

TEST(SurfacePath, TurnsWithoutAJump) {
  constexpr double kOfOneCurve_deg = 90;
  for (const Surface& surface : {face(1), face(-1)}) {
    along_random_figures(surface, [&](const Figure&, const std::vector<Curve>& curves) {
      TipPoint at = curves.front().at(0);
      for (const Curve& curve : curves) {
        ASSERT_NEAR(curve.at(0).values[kC], at.values[kC], 1e-6);
        at = curve.end();
        ASSERT_LT(std::fabs(at.values[kC] - curve.at(0).values[kC]), kOfOneCurve_deg);
        ASSERT_NEAR(curve.at(curve.length() * (1 - 1e-12)).values[kC], at.values[kC], 1e-6);
      }
    });
  }
}

// The jet against differences, in what the rates of the curve are.
TEST(SurfacePath, HasTheDerivativesOfItsPoints) {
  for (const Surface& surface : kSurfaces) {
    along_random_figures(surface, [&](const Figure&, const std::vector<Curve>& curves) {
      for (const Curve& curve : curves) {
        const double h = 1e-4 * curve.length();
        const double s = 0.4 * curve.length();
        const auto before = curve.jet(s - h);
        const auto after = curve.jet(s + h);
        const auto jet = curve.jet(s);
        const CurveBounds bounds = curve.bounds(0, curve.length());
        const auto check = [&](double first, double second, double derivative, double bound) {
          ASSERT_NEAR((second - first) / (2 * h), derivative, 1e-5 * bound + 1e-9 / h);
        };
        for (const std::size_t m : {kX, kC}) {
          check(before.value.values[m], after.value.values[m], jet.first.values[m],
                bounds.first.values[m] + h * bounds.second.values[m]);
          check(before.first.values[m], after.first.values[m], jet.second.values[m],
                bounds.second.values[m] + h * bounds.third.values[m]);
        }
      }
    });
  }
}

TEST(SurfacePath, ItsDerivativesStayWithinTheirBounds) {
  constexpr int kPlaces = 9;
  for (const Surface& surface : kSurfaces) {
    along_random_figures(surface, [&](const Figure&, const std::vector<Curve>& curves) {
      for (const Curve& curve : curves) {
        const CurveBounds bounds = curve.bounds(0, curve.length());
        for (int n = 0; n <= kPlaces; ++n) {
          const auto jet = curve.jet(curve.length() * n / kPlaces);
          for (const std::size_t m : {kX, kZ, kC}) {
            // Radial lines do not turn but by rounding.
            const double reach = std::fabs(jet.value.values[kX] - surface.centre_mm);
            const auto within = [&](double value, double bound, int order) {
              return std::fabs(value) <= bound * (1 + 1e-6) + 1e-12 * (1 + std::pow(reach, -order));
            };
            ASSERT_TRUE(within(jet.first.values[m], bounds.first.values[m], 1));
            ASSERT_TRUE(within(jet.second.values[m], bounds.second.values[m], 2));
            ASSERT_TRUE(within(jet.third.values[m], bounds.third.values[m], 3));
          }
        }
      }
    });
  }
}

TEST(SurfacePath, GoesThroughTheCentreWithATurnAtRest) {
  const Surface surface = face(1);
  SurfaceMove line;
  line.surface = surface;
  line.flat_to = {-20, 0};
  const auto straight = curves_of(start_on(surface), line);
  ASSERT_EQ(straight.size(), 3U);
  EXPECT_EQ(straight[0].end(), (TipPoint{{3, 0, 25}}));
  EXPECT_EQ(straight[1].end(), (TipPoint{{3, 0, 205}}));
  EXPECT_EQ(straight[2].end(), (TipPoint{{23, 0, 205}}));
  // A circle through the centre: in it, and away from it.
  SurfaceMove circle;
  circle.surface = surface;
  circle.is_arc = true;
  circle.about = {20, 0};
  circle.flat_to = {40, 0};
  const Figure figure{{40, 0}, circle, 40 * std::numbers::pi, 2 * std::numbers::pi};
  double turned = 0;
  for (const Curve& curve : curves_of(start_on(surface), circle)) {
    EXPECT_LT(figure.off(flat_of(surface, curve.at(curve.length() / 2))), 1e-9);
    turned += std::fabs(curve.end().values[kC] - curve.at(0).values[kC]);
  }
  EXPECT_NEAR(turned, 360, 1e-3);
}

TEST(SurfacePath, AMoveBesideThePlaneHasItsLength) {
  const Surface surface = face(1);
  SurfaceMove move;
  move.surface = surface;
  move.flat_to = {40, 30};
  move.to = TipPoint{{0, -40, 0}};
  const SurfacePath path(kAxes, start_on(surface), move, [](const Curve&) {});
  EXPECT_DOUBLE_EQ(path.length(), 50);
  EXPECT_NEAR(path.end().values[kX], 53, 1e-12);
  EXPECT_NEAR(path.end().values[kZ], -40, 1e-12);
}

planner::AxisLimits lathe_limits() {
  planner::AxisLimits limits = test::equal_limits(400, 3000, planner::kInfinite);
  limits.velocity.values[kC] = 600;
  return limits;
}

TEST(SurfacePath, SetPointsStayOnTheFaceAndWithinTheRatesOfTheAxes) {
  constexpr double kOff_mm = 1e-3;
  constexpr double kPeriod_s = 1e-3;
  RandomFigures random;
  const Surface surface = face(1);
  for (int n = 0; n < 40; ++n) {
    AxisSetup axes = kAxes;
    axes.start = start_on(surface);
    std::vector<Motion::Action> actions;
    std::vector<Figure> figures;
    TipPoint at = axes.start;
    for (int i = 0; i < 12; ++i) {
      Figure figure = random.figure(surface, flat_of(surface, at));
      figure.move.feed = {random.size(50, 5000), FeedMode::per_minute};
      figure.move.to = end_of(axes, at, figure.move);
      at = figure.move.to;
      figures.push_back(figure);
      actions.emplace_back(figure.move);
    }
    planner::Interpolator interpolator(axes, lathe_limits(), {.period_s = kPeriod_s});
    TipPoint last = axes.start;
    for (const Setpoint& point : test::points_of(interpolator, test::motions_of(actions))) {
      const Vec2 flat = flat_of(surface, point.tip);
      double off = 1;
      for (const Figure& figure : figures) off = std::min(off, figure.off(flat));
      ASSERT_LE(off, kOff_mm);
      const double turn = std::fabs(point.tip.values[kC] - last.values[kC]);
      ASSERT_LE(turn, 600 * kPeriod_s * (1 + 1e-6));
      last = point.tip;
    }
    EXPECT_NEAR(last.values[kC], at.values[kC], 1e-6);
    EXPECT_NEAR(last.values[kX], at.values[kX], 1e-9);
  }
}

}  // namespace
}  // namespace kerf::motion
