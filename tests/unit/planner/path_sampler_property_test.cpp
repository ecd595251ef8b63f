// Properties of set-points at equal steps, over random lines and arcs.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "geometry/vec3.hpp"
#include "motion/space_arc_path.hpp"
#include "motion_axes.hpp"
#include "planner/chord.hpp"
#include "planner/path_sampler.hpp"
#include "seeded_random.hpp"

namespace kerf::planner {
namespace {

using base::AxisVector;
using base::TipPoint;
using geometry::Vec3;
using motion::Arc;
using motion::Direction;
using motion::Line;
using motion::Motion;
using motion::Plane;
using motion::Rapid;
using motion::SpaceArc;
using test::kSeed;
using test::SeededRandom;
using Points = std::vector<TipPoint>;

constexpr double kPi = std::numbers::pi;
constexpr Sampling kConstantFeed[] = {Sampling::tail, Sampling::equal};
constexpr Sampling kAtSteps[] = {Sampling::tail, Sampling::equal, Sampling::equal_steps};

Settings settings_of(Sampling sampling, double period_s, double step_mm) {
  Settings settings;
  settings.sampling = sampling;
  settings.period_s = period_s;
  settings.step_mm = step_mm;
  return settings;
}

// The way there, at 0.1 mm a period or a step.
constexpr double kStep_mm = 0.1;
Points sample_from(const TipPoint& from, const Motion::Action& action, Sampling sampling,
                   double step_mm = kStep_mm) {
  PathSampler sampler(test::axes_named("XYZAC", 1e9), settings_of(sampling, 0.001, step_mm));
  Points points;
  for (const motion::Setpoint& point :
       test::points_of(sampler, test::motions_of({Rapid{from}, action}))) {
    if (point.mark.block.line == 2) points.push_back(point.tip);
  }
  return points;
}
double feed_of(double step_mm) { return step_mm / 0.001 * 60; }

Vec3 tip_of(const TipPoint& p) { return {p.values[0], p.values[1], p.values[2]}; }
TipPoint axes_of(Vec3 p, double a = 0, double c = 0) { return {{p.x, p.y, p.z, a, c}}; }

class Random : public SeededRandom {
 public:
  Random() : SeededRandom(kSeed) {}
  Vec3 point(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  Vec3 direction() {
    for (;;) {
      const Vec3 p = point(1);
      if (length(p) > 0.1) return (1 / length(p)) * p;
    }
  }
};

// Every step but the last is the wanted one, and that is no longer; of equal steps all are one.
void expect_steps(const std::vector<double>& steps, Sampling sampling, double wanted,
                  const std::string& what) {
  double whole = 0;
  for (const double step : steps) whole += step;
  const double all =
      sampling == Sampling::equal ? whole / static_cast<double>(steps.size()) : wanted;
  const double rounding = 1e-8;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) ASSERT_NEAR(steps[i], all, rounding) << what;
  ASSERT_LE(steps.back(), all + rounding) << what;
  ASSERT_LE(all, wanted + rounding) << what;
  if (sampling == Sampling::equal) {
    ASSERT_NEAR(steps.back(), all, rounding) << what;
  }
  const double least = (static_cast<double>(steps.size()) - 1) * wanted;
  ASSERT_GT(whole, least - rounding) << what << ": a point too many";
}

TEST(PathSamplerProperty, PointsOfALineLieOnItAtEqualStepsAndEndExactly) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const double size = random.size(0.01, 20);
    const TipPoint from = axes_of(random.point(100), random.in(-90, 90), random.in(-90, 90));
    const TipPoint to =
        axes_of(tip_of(from) + random.point(size), random.in(-90, 90), random.in(-90, 90));
    const Vec3 way = tip_of(to) - tip_of(from);
    for (const Sampling sampling : kAtSteps) {
      const Points points = sample_from(from, Line{to, {feed_of(kStep_mm)}}, sampling);
      ASSERT_EQ(points.back(), to);
      std::vector<double> steps;
      TipPoint before = from;
      for (const TipPoint& p : points) {
        const Vec3 arm = tip_of(p) - tip_of(from);
        ASSERT_LE(length(cross(arm, way)) / length(way), 1e-9);
        const double share = dot(arm, way) / dot(way, way);
        for (const std::size_t m : {3U, 4U})
          ASSERT_NEAR(p.values[m], std::lerp(from.values[m], to.values[m], share), 1e-9);
        steps.push_back(length(tip_of(p) - tip_of(before)));
        before = p;
      }
      expect_steps(steps, sampling, kStep_mm, "line " + std::to_string(i));
    }
  }
}

struct RandomArc {
  TipPoint from;
  Arc arc;
  double radius = 0;
  double sweep = 0;  // > 0
};

RandomArc random_arc(Random& random) {
  RandomArc made;
  Arc& arc = made.arc;
  made.radius = random.size(0.05, 2);
  made.sweep = random.in(0.01, 2 * kPi - 0.01);
  arc.plane = static_cast<Plane>(random.count(0, 2));
  arc.direction = random.coin() ? Direction::clockwise : Direction::counterclockwise;
  const double side = arc.direction == Direction::clockwise ? -1 : 1;
  const std::array<std::size_t, 3> first_axes{0, 2, 1};
  const std::size_t first = first_axes[static_cast<std::size_t>(arc.plane)];
  const double begin = random.in(-kPi, kPi);
  const Vec3 centre = random.point(50);
  made.from = axes_of(centre, random.in(-90, 90), random.in(-90, 90));
  arc.to = axes_of(centre, random.in(-90, 90), random.in(-90, 90));
  const std::size_t second = (first + 1) % 3;
  arc.center = {made.from.values[first], made.from.values[second]};
  const auto place = [&](TipPoint& p, double angle) {
    p.values[first] = arc.center[0] + made.radius * std::cos(angle);
    p.values[second] = arc.center[1] + made.radius * std::sin(angle);
  };
  place(made.from, begin);
  place(arc.to, begin + side * made.sweep);
  arc.to.values[(first + 2) % 3] += random.in(-1, 1);
  arc.feed.value = feed_of(kStep_mm);
  return made;
}

TEST(PathSamplerProperty, PointsOfAnArcLieOnItAtEqualAnglesAndEndExactly) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const RandomArc made = random_arc(random);
    const std::array<std::size_t, 3> first_axes{0, 2, 1};
    const std::size_t first = first_axes[static_cast<std::size_t>(made.arc.plane)];
    const std::size_t second = (first + 1) % 3;
    const double side = made.arc.direction == Direction::clockwise ? -1 : 1;
    for (const Sampling sampling : kAtSteps) {
      const Points points = sample_from(made.from, made.arc, sampling);
      ASSERT_EQ(points.back(), made.arc.to);
      std::vector<double> steps;
      TipPoint before = made.from;
      double swept = 0;
      const auto angle = [&](const TipPoint& p) {
        return std::atan2(p.values[second] - made.arc.center[1],
                          p.values[first] - made.arc.center[0]);
      };
      for (const TipPoint& p : points) {
        ASSERT_NEAR(
            std::hypot(p.values[first] - made.arc.center[0], p.values[second] - made.arc.center[1]),
            made.radius, 1e-9 * std::max(1.0, made.radius));
        const double turned = std::remainder(angle(p) - angle(before), 2 * kPi);
        // A step of 0.1 mm is at most two radians here, so the remainder tells it.
        swept += side * turned;
        steps.push_back(side * turned * made.radius);
        const double share = swept / made.sweep;
        for (const std::size_t m : {(first + 2) % 3, std::size_t{3}, std::size_t{4}})
          ASSERT_NEAR(p.values[m], std::lerp(made.from.values[m], made.arc.to.values[m], share),
                      1e-7);
        before = p;
      }
      expect_steps(steps, sampling, kStep_mm, "arc " + std::to_string(i));
    }
  }
}

struct RandomSpaceArc {
  TipPoint from;
  SpaceArc arc;
  Vec3 centre, e1, e2;
  double radius = 0;
  double second = 0;  // angles
  double third = 0;

  [[nodiscard]] Vec3 at(double angle) const {
    return centre + (radius * std::cos(angle)) * e1 + (radius * std::sin(angle)) * e2;
  }
};

RandomSpaceArc random_space_arc(Random& random) {
  RandomSpaceArc made;
  made.radius = random.size(0.05, 3);
  made.centre = random.point(20);
  made.e1 = random.direction();
  do {
    made.e2 = cross(made.e1, random.direction());
  } while (length(made.e2) < 0.1);
  made.e2 = (1 / length(made.e2)) * made.e2;
  made.third = random.in(0.2, 6);
  made.second = made.third * random.in(0.2, 0.8);
  const auto tip = [&](double angle) {
    return axes_of(made.at(angle), random.in(-90, 90), random.in(-90, 90));
  };
  made.from = tip(0);
  made.arc.via = tip(made.second);
  made.arc.to = tip(made.third);
  made.arc.feed.value = feed_of(kStep_mm);
  return made;
}

TEST(PathSamplerProperty, PointsOfAnArcInSpaceLieOnItAtEqualAnglesAndEndExactly) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const RandomSpaceArc made = random_space_arc(random);
    for (const Sampling sampling : kAtSteps) {
      const Points points = sample_from(made.from, made.arc, sampling);
      ASSERT_EQ(points.back(), made.arc.to);
      const auto count = static_cast<double>(points.size());
      const double length = made.radius * made.third;
      ASSERT_EQ(count, std::ceil(length / kStep_mm - 1e-6)) << i;
      const double step = sampling == Sampling::equal ? length / count : kStep_mm;
      for (std::size_t n = 1; n < points.size(); ++n) {
        const double angle = static_cast<double>(n) * step / made.radius;
        const TipPoint& p = points[n - 1];
        ASSERT_LE(geometry::length(tip_of(p) - made.at(angle)), 1e-9 * std::max(1.0, made.radius))
            << i;
        const bool before = angle < made.second;
        const double share =
            before ? angle / made.second : (angle - made.second) / (made.third - made.second);
        const AxisVector& a = before ? made.from : made.arc.via;
        const AxisVector& b = before ? made.arc.via : made.arc.to;
        for (const std::size_t m : {3U, 4U})
          ASSERT_NEAR(p.values[m], std::lerp(a.values[m], b.values[m], share), 1e-7) << i;
      }
    }
  }
}

// The second point lies at a whole number of steps.
TEST(PathSamplerProperty, RotaryAxesAreWhereTheSecondPointSaysWhenTheTipIsThere) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    RandomSpaceArc made = random_space_arc(random);
    const int steps = random.count(1, 50);
    const motion::SpaceArcPath path(test::axes_named("XYZAC"), made.from, made.arc);
    const double step = path.circle().to_second_rad() * path.circle().radius() / steps;
    made.arc.feed.value = feed_of(step);
    for (const Sampling sampling : {Sampling::tail, Sampling::equal_steps}) {
      const TipPoint p =
          sample_from(made.from, made.arc, sampling, step)[static_cast<std::size_t>(steps) - 1];
      for (std::size_t m = 0; m < 3; ++m)
        ASSERT_NEAR(p.values[m], made.arc.via.values[m], 1e-9) << i;
      for (const std::size_t m : {3U, 4U})
        ASSERT_NEAR(p.values[m], made.arc.via.values[m], 1e-12) << i;
    }
  }
}

// Equal steps are the same from both ends.
TEST(PathSamplerProperty, AnArcDrivenBackPassesTheSamePoints) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const RandomSpaceArc made = random_space_arc(random);
    SpaceArc back = made.arc;
    back.to = made.from;
    const Points there = sample_from(made.from, made.arc, Sampling::equal);
    const Points here = sample_from(made.arc.to, back, Sampling::equal);
    ASSERT_EQ(there.size(), here.size());
    for (std::size_t n = 0; n + 1 < there.size(); ++n) {
      const AxisVector off = there[n] - here[there.size() - 2 - n];
      for (const double d : off.values) ASSERT_NEAR(d, 0, 1e-7) << i;
    }
  }
}

struct RigidMotion {
  Vec3 x, y, z, shift;

  [[nodiscard]] TipPoint operator()(TipPoint p) const {
    const Vec3 moved = p.values[0] * x + p.values[1] * y + p.values[2] * z + shift;
    return axes_of(moved, p.values[3], p.values[4]);
  }
};

RigidMotion random_motion(Random& random) {
  RigidMotion motion;
  motion.x = random.direction();
  do {
    motion.y = cross(motion.x, random.direction());
  } while (length(motion.y) < 0.1);
  motion.y = (1 / length(motion.y)) * motion.y;
  motion.z = cross(motion.x, motion.y);
  motion.shift = random.point(30);
  return motion;
}

TEST(PathSamplerProperty, ARigidMotionOfThePathMovesThePointsRigidly) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const RigidMotion move = random_motion(random);
    const RandomSpaceArc made = random_space_arc(random);
    SpaceArc arc = made.arc;
    arc.via = move(made.arc.via);
    arc.to = move(made.arc.to);
    const Line line{made.arc.to, made.arc.feed};
    for (const Sampling sampling : kConstantFeed) {
      const auto compare = [&](const Motion::Action& action, const Motion::Action& moved) {
        const Points here = sample_from(made.from, action, sampling);
        const Points there = sample_from(move(made.from), moved, sampling);
        ASSERT_EQ(here.size(), there.size());
        for (std::size_t n = 0; n < here.size(); ++n) {
          const AxisVector off = there[n] - move(here[n]);
          for (const double d : off.values) ASSERT_NEAR(d, 0, 1e-7) << i;
        }
      };
      compare(made.arc, arc);
      compare(line, Line{arc.to, arc.feed});
    }
  }
}

// The planes are the same thing with other names for their axes.
TEST(PathSamplerProperty, AnotherPlaneRenamesTheAxes) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    RandomArc made = random_arc(random);
    made.arc.plane = Plane::xy;
    const auto turned = [](const TipPoint& p) {  // X Y Z to Z X Y
      return TipPoint{{p.values[1], p.values[2], p.values[0], p.values[3], p.values[4]}};
    };
    made.arc.center = {made.from.values[0] - made.radius, made.from.values[1]};
    made.arc.to.values[0] = made.arc.center[0] + made.radius * std::cos(made.sweep);
    made.arc.to.values[1] = made.arc.center[1] + made.radius * std::sin(made.sweep);
    Arc arc = made.arc;
    arc.plane = Plane::zx;
    arc.to = turned(made.arc.to);
    const Points flat = sample_from(made.from, made.arc, Sampling::tail);
    const Points upright = sample_from(turned(made.from), arc, Sampling::tail);
    ASSERT_EQ(flat.size(), upright.size());
    for (std::size_t n = 0; n < flat.size(); ++n) ASSERT_EQ(upright[n], turned(flat[n])) << i;
  }
}

// The chord lies farthest from the arc in its middle.
TEST(PathSamplerProperty, AtTheFeedOfADeviationNoChordLeavesTheArcByMore) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    RandomSpaceArc made = random_space_arc(random);
    const double deviation = made.radius * random.size(1e-5, 0.1);
    const double feed = i % 2 == 0 ? step_feed_mm_s(made.radius, deviation, 0.001)
                                   : chord_feed_mm_s(made.radius, deviation, 0.001);
    made.arc.feed.value = 60 * feed;
    for (const Sampling sampling : kConstantFeed) {
      Vec3 before = tip_of(made.from);
      for (const TipPoint& p : sample_from(made.from, made.arc, sampling)) {
        const Vec3 middle = 0.5 * (tip_of(p) + before);
        ASSERT_LE(made.radius - length(middle - made.centre), deviation * (1 + 1e-6) + 1e-9) << i;
        before = tip_of(p);
      }
    }
  }
}

}  // namespace
}  // namespace kerf::planner
