#include "planner/corner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/vec3.hpp"
#include "motion_axes.hpp"
#include "planner/interpolator.hpp"
#include "seeded_random.hpp"

namespace kerf::planner {
namespace {

using base::AxisVector;
using base::TipJet;
using base::TipPoint;
using geometry::Vec3;
using motion::Line;
using test::kSeed;
using test::SeededRandom;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kAxes = 3;
constexpr std::array<bool, base::kMaxAxes> kLinear{true, true, true};
constexpr int kCases = 3000;

TipPoint axes_of(Vec3 p) { return {{p.x, p.y, p.z}}; }
Vec3 tip_of(const TipPoint& p) { return {p.values[0], p.values[1], p.values[2]}; }

/// A curve that ends, or begins, in the origin, and how far a point is from it.
struct Side {
  motion::Curve curve;
  Vec3 direction;           // of travel in the origin
  Vec3 centre;              // of an arc
  double radius = 0;        // 0: a line
  bool ends_there = false;  // else it begins there

  [[nodiscard]] double distance(Vec3 p) const {
    if (radius > 0) {  // arcs lie in the plane of XY
      return std::hypot(p.z, std::hypot(p.x - centre.x, p.y - centre.y) - radius);
    }
    const double along = ends_there ? -dot(p, direction) : dot(p, direction);
    return length(p - std::max(0.0, along) * (ends_there ? -1.0 : 1.0) * direction);
  }
};

class Random : public SeededRandom {
 public:
  explicit Random(unsigned seed = kSeed) : SeededRandom(seed) {}

  Vec3 direction() {
    for (;;) {
      const Vec3 p{in(-1, 1), in(-1, 1), in(-1, 1)};
      if (length(p) > 0.1) return unit(p);
    }
  }
  Side line(bool ends_there) {
    Side side{{}, direction(), {}, 0, ends_there};
    const double l = size(0.01, 100);
    side.curve = ends_there ? motion::Curve::line(axes_of(-l * side.direction), {}, l, kAxes)
                            : motion::Curve::line({}, axes_of(l * side.direction), l, kAxes);
    return side;
  }
  Side arc(bool ends_there) {
    const double radius = size(0.1, 100);
    const double heading = in(-std::numbers::pi, std::numbers::pi);
    const double turning = coin() ? 1 : -1;
    Side side{{}, {std::cos(heading), std::sin(heading), 0}, {}, radius, ends_there};
    side.centre = turning * radius * Vec3{-std::sin(heading), std::cos(heading), 0};
    const double l = radius * size(0.01, 3);
    motion::ArcShape shape;
    shape.origin = axes_of(side.centre);
    shape.e1.values[0] = 1;
    shape.e2.values[1] = 1;
    shape.radius = radius;
    shape.rate = turning / radius;
    shape.angle_rad = heading - turning * std::numbers::pi / 2;
    if (ends_there) shape.angle_rad -= l * shape.rate;
    const double end = shape.angle_rad + l * shape.rate;
    const TipPoint to = ends_there
                            ? TipPoint{}
                            : axes_of(side.centre + radius * Vec3{std::cos(end), std::sin(end), 0});
    side.curve = motion::Curve::arc(shape, to, l, kAxes);
    return side;
  }
  Side side(bool ends_there) { return coin() ? line(ends_there) : arc(ends_there); }
};

CellLimits limits_of(double acceleration, double jerk, double velocity = 1000) {
  return {test::equal_limits(velocity, acceleration, jerk), Settings{}, kAxes, kLinear};
}

struct RandomCorner {
  Side in, out;
  CellLimits limits;
  double tolerance = 0;
  double feed = 0;
  double most_reach = 0;

  [[nodiscard]] Corner rounded(double used = 0) const {
    Follower follower(nullptr);
    return CornerRounder(limits, kAxes, kLinear, follower)
        .between(in.curve, out.curve, {feed, feed, most_reach, tolerance - used});
  }
};

RandomCorner random_corner(Random& random) {
  const double jerk = random.coin() ? kInfinite : random.size(1e4, 1e7);
  RandomCorner corner{random.side(true), random.side(false),
                      limits_of(random.size(100, 1e4), jerk)};
  corner.tolerance = random.size(1e-4, 0.5);
  corner.feed = random.size(1, 1000);
  corner.most_reach = 0.49 * std::min(corner.in.curve.length(), corner.out.curve.length());
  return corner;
}

TEST(CornerRounder, StaysWithinTheTolerance) {
  constexpr int kPlaces = 500;
  Random random;
  int rounded = 0;
  for (int i = 0; i < kCases; ++i) {
    const RandomCorner corner = random_corner(random);
    const double used = random.coin() ? 0 : random.in(0, 0.5) * corner.tolerance;
    const Corner made = corner.rounded(used);
    if (made.kind != Corner::Kind::rounded) continue;
    ++rounded;
    const Rounding& rounding = made.rounding;
    ASSERT_LE(rounding.reach, corner.most_reach) << i;
    ASSERT_EQ(rounding.curve.length(), 2 * rounding.reach) << i;
    for (int n = 0; n <= kPlaces; ++n) {
      const Vec3 p = tip_of(rounding.curve.at(2 * rounding.reach * n / kPlaces));
      const double off = std::min(corner.in.distance(p), corner.out.distance(p));
      ASSERT_LE(off, corner.tolerance - used + 1e-12 * (1 + corner.in.radius)) << i;
    }
  }
  EXPECT_GT(rounded, kCases * 8 / 10);
}

TEST(CornerRounder, GoesOnFromOneCurveIntoTheOther) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    const RandomCorner corner = random_corner(random);
    const Corner made = corner.rounded();
    if (made.kind != Corner::Kind::rounded) continue;
    const Rounding& rounding = made.rounding;
    const double reach = rounding.reach;
    const std::pair<TipJet, TipJet> joints[] = {
        {corner.in.curve.jet(corner.in.curve.length() - reach), rounding.curve.jet(0)},
        {rounding.curve.jet(2 * reach), corner.out.curve.jet(reach)}};
    for (const auto& joint : joints) {
      const auto apart = [&](auto derivative) {
        const AxisVector off = joint.first.*derivative - joint.second.*derivative;
        return std::hypot(off.values[0], off.values[1], off.values[2]);
      };
      ASSERT_LE(apart(&TipJet::value), 1e-10) << i;
      // Points are known to 1e-14 of some hundred mm, slopes over the reach.
      const double rounding_error = 1e-12 + 1e-12 / reach;
      ASSERT_LE(apart(&TipJet::first), rounding_error) << i;
      if (corner.limits.jerk_limited()) {
        ASSERT_LE(apart(&TipJet::second), 10 * rounding_error / reach) << i;
      }
    }
  }
}

// Between lines: |Δu| reach / 4 from the corner, with limited jerk 3/16 of it.
TEST(CornerRounder, CutsACornerOfLinesByWhatTheFormulaSays) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    RandomCorner corner = random_corner(random);
    corner.in = random.line(true);
    corner.out = random.line(false);
    corner.most_reach = 0.49 * std::min(corner.in.curve.length(), corner.out.curve.length());
    const Corner made = corner.rounded();
    if (made.kind != Corner::Kind::rounded) continue;
    const double turn = length(corner.out.direction - corner.in.direction);
    const double share = corner.limits.jerk_limited() ? 3.0 / 16 : 1.0 / 4;
    const double middle = length(tip_of(made.rounding.curve.at(made.rounding.reach)));
    ASSERT_NEAR(middle, share * turn * made.rounding.reach, 1e-9 * corner.tolerance + 1e-13) << i;
  }
}

// Where the feed needs more than the tolerance gives, all of that is taken but what is held back
// for the places between those that are asked. (With limited jerk a stop may be faster.)
TEST(CornerRounder, AFastCornerOfLinesTakesTheWholeTolerance) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    RandomCorner corner = random_corner(random);
    const double l = 1e3;
    corner.in = random.line(true);
    corner.out = random.line(false);
    corner.in.curve = motion::Curve::line(axes_of(-l * corner.in.direction), {}, l, kAxes);
    corner.out.curve = motion::Curve::line({}, axes_of(l * corner.out.direction), l, kAxes);
    corner.most_reach = l;
    corner.feed = 1e6;
    corner.tolerance = random.size(1e-4, 0.01);
    corner.limits = CellLimits(test::equal_limits(1000, random.size(100, 1e4), kInfinite),
                               {.chord_tolerance_mm = 1e6}, kAxes, kLinear);
    const double turn = length(corner.out.direction - corner.in.direction);
    // With less turn all of it would be longer than the lines, with more a stop may be faster.
    if (turn < 0.01 || turn > 1) continue;
    const Corner made = corner.rounded();
    ASSERT_EQ(made.kind, Corner::Kind::rounded) << i;
    const double middle = length(tip_of(made.rounding.curve.at(made.rounding.reach)));
    ASSERT_GE(middle, 0.979 * corner.tolerance) << i;
  }
}

// As little as the feed needs: with room and tolerance enough the corner does not slow down, and
// half of the feed needs a quarter of the way without a limit of the jerk.
TEST(CornerRounder, ReachesNoFartherThanTheFeedNeeds) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    RandomCorner corner = random_corner(random);
    corner.in = random.line(true);
    corner.out = random.line(false);
    corner.tolerance = 1e6;
    corner.most_reach = 1e6;
    corner.feed = random.size(0.1, 400);
    corner.limits =
        CellLimits(corner.limits.axis_limits(), {.chord_tolerance_mm = 1e6}, kAxes, kLinear);
    const double l = 2e7;  // longer than any rounding
    corner.in.curve = motion::Curve::line(axes_of(-l * corner.in.direction), {}, l, kAxes);
    corner.out.curve = motion::Curve::line({}, axes_of(l * corner.out.direction), l, kAxes);
    const Corner made = corner.rounded();
    if (made.kind == Corner::Kind::none) continue;
    ASSERT_EQ(made.kind, Corner::Kind::rounded) << i;
    const double reach = made.rounding.reach;
    const CellBounds bounds{.driven = made.rounding.curve.bounds(0, 2 * reach),
                            .curvature = 0,
                            .linkage = {},
                            .tip_acceleration = 0,
                            .at_border = false};
    ASSERT_NEAR(corner.limits.of(bounds, corner.feed, CellLimits::Use::corner).velocity,
                corner.feed, 1e-9 * corner.feed)
        << i;
    corner.feed /= 2;
    const double shorter = corner.rounded().rounding.reach;
    ASSERT_LT(shorter, reach) << i;
    if (!corner.limits.jerk_limited()) {
      ASSERT_NEAR(shorter, reach / 4, 1e-6 * reach) << i;
    }
  }
}

// A right angle from X into Y, long lines, acceleration a and no limit of the jerk: with vc² =
// 0.98 · 2 a reach it costs 2 reach (1/vc - 1/v) + (v - vc)²/(a v), with a stop v/a and half a
// period.
TEST(CornerTime, OfARightAngleIsWhatTheFormulaSays) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    const double a = random.size(100, 1e4);
    const double v = random.size(0.1, 1000);
    const CellLimits limits(test::equal_limits(1000, a, kInfinite),
                            {.period_s = 1e-3, .chord_tolerance_mm = 1e6}, kAxes, kLinear);
    const double length = 2 * v * v / a;
    const TipJet x{{}, {{1, 0}}, {}, {}};
    const TipJet y{{}, {{0, 1}}, {}, {}};
    const CornerTime time(limits, {0.5, 0, 0.25}, {x, {{}, x.first, {}, {}}, length, v},
                          {y, {{}, y.first, {}, {}}, length, v});
    const double reach = random.size(0.01, 1) * v * v / (0.98 * 2 * a);
    const double vc = std::sqrt(0.98 * 2 * a * reach);
    const double cost = 2 * reach * (1 / vc - 1 / v) + (v - vc) * (v - vc) / (a * v);
    ASSERT_NEAR(time.rounded_s(reach), cost, 1e-9 * v / a) << i;
    ASSERT_NEAR(time.stopped_s(), v / a + 0.0005, 1e-9 * v / a) << i;
  }
}

TEST(CornerRounder, CurvesThatGoOnHaveNoCorner) {
  Random random;
  const CellLimits limits = limits_of(1000, 1e5);
  Follower follower(nullptr);
  const CornerRounder rounder(limits, kAxes, kLinear, follower);
  for (int i = 0; i < kCases; ++i) {
    const Side in = random.line(true);
    const double l = in.curve.length();
    const motion::Curve out = motion::Curve::line({}, axes_of(l * in.direction), l, kAxes);
    EXPECT_EQ(rounder.between(in.curve, out, {100, 100, 0.4 * l, 0.01}).kind, Corner::Kind::none)
        << i;
  }
}

// A line that goes over into an arc turns at once, though not its direction.
TEST(CornerRounder, WithJerkACurvatureThatBeginsAtOnceIsACorner) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    const Side out = random.arc(false);
    const motion::Curve in = motion::Curve::line(axes_of(-10.0 * out.direction), {}, 10, kAxes);
    const double most = 0.49 * std::min(10.0, out.curve.length());
    for (const double jerk : {1e5, kInfinite}) {
      const CellLimits limits = limits_of(1000, jerk);
      Follower follower(nullptr);
      const Corner corner = CornerRounder(limits, kAxes, kLinear, follower)
                                .between(in, out.curve, {100, 100, most, 0.01});
      EXPECT_EQ(corner.kind == Corner::Kind::none, jerk == kInfinite) << i;
    }
  }
}

TEST(CornerRounder, WithoutToleranceTheAxesRest) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    RandomCorner corner = random_corner(random);
    EXPECT_EQ(corner.rounded(corner.tolerance).kind, Corner::Kind::sharp) << i;
    corner.tolerance = 0;
    EXPECT_EQ(corner.rounded().kind, Corner::Kind::sharp) << i;
  }
}

// The speed of an arc that touches both lines and leaves their corner by the deviation d:
// v² = a d sin (θ/2) / (1 - sin (θ/2)), θ = π - β. Rounded corners are other curves; they are held
// against it as a bound from below.

struct JunctionRow {
  double acceleration, deviation, turn_deg, speed;
};

constexpr JunctionRow kJunctions[] = {
    {500, 0.02, 10, 51.165539},  {500, 0.02, 45, 11.016838}, {500, 0.02, 90, 4.913465},
    {500, 0.02, 135, 2.489808},  {500, 0.02, 180, 0.000000}, {1000, 0.01, 90, 4.913465},
    {1000, 0.05, 30, 37.648201},
};

TEST(Junction, SpeedsOfTheTableAreThoseOfItsFormula) {
  for (const JunctionRow& row : kJunctions) {
    const double half = std::sin((180 - row.turn_deg) / 2 * std::numbers::pi / 180);
    EXPECT_NEAR(std::sqrt(row.acceleration * row.deviation * half / (1 - half)), row.speed, 5.1e-7);
  }
}

struct CornerDrive {
  double speed = 1e300;  // least, along the lines that are cut off
  double deviation = 0;  // largest
  double acceleration = 0;
};

// Two long lines at high feed. Along the bisector of the lines way and parameter are proportional,
// so that is where the speed is read.
CornerDrive drive(Vec3 in, Vec3 out, const JunctionRow& row) {
  constexpr double kLength_mm = 20;
  constexpr double kPeriod_s = 1e-4;
  Settings settings;
  settings.period_s = kPeriod_s;
  settings.tolerance_mm = row.deviation;
  Interpolator interpolator(test::axes_named("XYZ"),
                            test::equal_limits(1000, row.acceleration, kInfinite), settings);
  const Vec3 corner = kLength_mm * in;
  const TipPoint end = axes_of(corner + kLength_mm * out);
  const auto points = test::points_of(
      interpolator, test::motions_of({Line{axes_of(corner), {60000}}, Line{end, {60000}}}));
  const Vec3 bisector = unit(in + out);
  const double share = dot(in, bisector);
  CornerDrive driven;
  double nearest = kInfinite;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec3 p = tip_of(points[i].tip);
    const double way = dot(p - tip_of(points[i - 1].tip), bisector) / share;
    nearest = std::min(nearest, length(p - corner));
    if (length(p - corner) < kLength_mm / 4) driven.speed = std::min(driven.speed, way / kPeriod_s);
    const Vec3 arm = p - corner;
    const double to_in = length(arm - std::min(0.0, dot(arm, in)) * in);
    const double to_out = length(arm - std::max(0.0, dot(arm, out)) * out);
    driven.deviation = std::max(driven.deviation, std::min(to_in, to_out));
    if (i < 2) continue;
    const AxisVector bend =
        points[i].tip - points[i - 1].tip - points[i - 1].tip + points[i - 2].tip;
    for (const double d : bend.values)
      driven.acceleration = std::max(driven.acceleration, std::fabs(d) / kPeriod_s / kPeriod_s);
  }
  // The corner itself is cut off by no more than the deviation.
  driven.deviation = std::max(driven.deviation, nearest);
  return driven;
}

TEST(Junction, RoundedCornersAreDrivenAtLeastAtTheSpeedOfTheTable) {
  constexpr int kDirections = 20;
  constexpr double kShare = 0.97;
  Random random;
  for (const JunctionRow& row : kJunctions) {
    if (row.turn_deg == 180) continue;  // there is no speed to hold
    const double turn = row.turn_deg * std::numbers::pi / 180;
    for (int i = 0; i < kDirections; ++i) {
      // The first ones along the axes.
      const Vec3 in = i == 0 ? Vec3{1, 0, 0} : i == 1 ? Vec3{0, -1, 0} : random.direction();
      const Vec3 other = i == 0 ? Vec3{0, 1, 0} : i == 1 ? Vec3{0, 0, 1} : random.direction();
      const Vec3 left = cross(other, in);
      if (length(left) < 0.1) continue;
      const Vec3 out = std::cos(turn) * in + std::sin(turn) * unit(cross(in, left));
      const CornerDrive driven = drive(in, out, row);
      EXPECT_GE(driven.speed, kShare * row.speed) << row.turn_deg << " " << i;
      EXPECT_LE(driven.deviation, row.deviation) << row.turn_deg << " " << i;
      EXPECT_LE(driven.acceleration, row.acceleration * (1 + 1e-6)) << row.turn_deg << " " << i;
    }
  }
}

TEST(Junction, WhereALineGoesBackItTurnsWithinTheDeviation) {
  const JunctionRow row{500, 0.02, 180, 0};
  Settings settings;
  settings.period_s = 1e-4;
  settings.tolerance_mm = row.deviation;
  Interpolator interpolator(test::axes_named("XYZ"),
                            test::equal_limits(1000, row.acceleration, kInfinite), settings);
  const auto points = test::points_of(
      interpolator, test::motions_of({Line{{{20, 0, 0}}, {60000}}, Line{{{0, 0, 0}}, {60000}}}));
  double farthest = 0;
  for (const motion::Setpoint& point : points) farthest = std::max(farthest, point.tip.values[0]);
  EXPECT_LE(farthest, 20);
  EXPECT_GE(farthest, 20 - row.deviation);
}

}  // namespace
}  // namespace kerf::planner
