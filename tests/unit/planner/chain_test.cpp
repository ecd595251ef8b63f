#include "planner/chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "seeded_random.hpp"

namespace kerf::planner {
namespace {

using base::AxisVector;
using base::TipJet;
using base::TipPoint;
using test::kSeed;
using test::SeededRandom;

constexpr std::size_t kAxes = 3;
constexpr std::array<bool, base::kMaxAxes> kLinear{true, true, true};
constexpr double kPi = std::numbers::pi;

double size(const AxisVector& v) { return std::hypot(v.values[0], v.values[1], v.values[2]); }

struct Point {
  TipPoint at;
  double feed = 10;
  bool fixed_override = false;
};

/// A piece, and the number of the point where it ends.
struct Made {
  ChainSmoother::Piece piece;
  std::size_t first = 0;
  std::size_t last = 0;
  bool begins_chain = false;
  bool ends_chain = false;
};

struct Smoothed {
  std::vector<Made> pieces;
  std::size_t chains = 1;
};

// One chain after the other, as lines join them.
Smoothed smooth(const std::vector<Point>& points, double tolerance) {
  Follower follower(nullptr);
  ChainSmoother chain(tolerance, kAxes, kLinear, follower);
  Smoothed smoothed;
  std::size_t end = 0;
  bool begins = true;
  const auto drain = [&](bool ended) {
    ChainSmoother::Piece piece;
    for (; chain.next(ended, piece); begins = false) {
      const std::size_t lines = piece.last - piece.first;
      smoothed.pieces.push_back({piece, end, end + lines, begins, false});
      end += lines;
    }
    if (ended) smoothed.pieces.back().ends_chain = begins = true;
  };
  chain.start(points[0].at);
  for (std::size_t n = 1; n < points.size(); ++n) {
    const double length = size(points[n].at - points[n - 1].at);
    if (!chain.empty() && !chain.accepts(points[n].at, length)) {
      drain(true);
      chain.start(points[n - 1].at);
      ++smoothed.chains;
    }
    chain.add(points[n].at, length, {points[n].feed, false, points[n].fixed_override}, {});
    drain(false);
  }
  drain(true);
  return smoothed;
}

std::vector<Point> points_on(const std::function<TipPoint(double)>& curve, int count,
                             double digit = 0) {
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i) {
    TipPoint at = curve(i);
    for (double& value : at.values) {
      if (digit > 0) value = std::round(value / digit) * digit;
    }
    if (points.empty() || !(points.back().at == at)) points.push_back({at});
  }
  return points;
}

std::vector<Point> circle(double radius, double step_mm, double sweep_rad, double digit = 0) {
  const auto at = [=](double i) {
    const double angle = i * step_mm / radius;
    return TipPoint{{radius * std::cos(angle), radius * std::sin(angle), 0.1 * angle}};
  };
  return points_on(at, static_cast<int>(sweep_rad * radius / step_mm), digit);
}

double distance_to_lines(const TipPoint& p, const std::vector<Point>& points, std::size_t first,
                         std::size_t last) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = first; n < last; ++n) {
    const AxisVector way = points[n + 1].at - points[n].at;
    const AxisVector arm = p - points[n].at;
    double along = 0;
    double square = 0;
    for (std::size_t m = 0; m < kAxes; ++m) {
      along += arm.values[m] * way.values[m];
      square += way.values[m] * way.values[m];
    }
    const double t = std::clamp(along / square, 0.0, 1.0);
    AxisVector off = arm;
    for (std::size_t m = 0; m < kAxes; ++m) off.values[m] -= t * way.values[m];
    least = std::min(least, size(off));
  }
  return least;
}

void expect_near_the_lines(const Smoothed& smoothed, const std::vector<Point>& points,
                           double tolerance) {
  for (const Made& made : smoothed.pieces) {
    const motion::Curve& curve = made.piece.curve;
    const std::size_t places = 16 * (made.last - made.first);
    for (std::size_t i = 0; i <= places; ++i) {
      const double s = curve.length() * static_cast<double>(i) / static_cast<double>(places);
      ASSERT_LE(distance_to_lines(curve.at(s), points, made.first, made.last),
                tolerance * (1 + 1e-9) + 1e-12)
          << "points " << made.first << " to " << made.last;
    }
  }
}

// Position, direction and curvature go on where a piece says that it is joined; position always.
void expect_smooth(const Smoothed& smoothed) {
  for (std::size_t i = 1; i < smoothed.pieces.size(); ++i) {
    const motion::Curve& before = smoothed.pieces[i - 1].piece.curve;
    const TipJet end = before.jet(before.length());
    const TipJet begin = smoothed.pieces[i].piece.curve.jet(0);
    ASSERT_LE(size(end.value - begin.value), 1e-12) << i;
    if (!smoothed.pieces[i].piece.joined) continue;
    const double length = std::min(before.length(), smoothed.pieces[i].piece.curve.length());
    ASSERT_LE(size(end.first - begin.first), 1e-12 + 1e-13 / length) << i;
    ASSERT_LE(size(end.second - begin.second), (1e-12 + 1e-12 / length) / length) << i;
  }
}

std::size_t joined(const Smoothed& smoothed) {
  return static_cast<std::size_t>(std::count_if(smoothed.pieces.begin(), smoothed.pieces.end(),
                                                [](const Made& m) { return m.piece.joined; }));
}

TEST(ChainSmoother, FromThePointsOfACircleComesACurveWithinItsTolerance) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 100; ++i) {
    const double radius = random.size(0.5, 500);
    const double tolerance = random.size(1e-4, 0.1);
    // The lines leave the circle by a part of the tolerance.
    const double step = std::sqrt(8 * radius * tolerance * random.size(0.001, 0.2));
    if (step > 0.2 * radius) continue;
    const std::vector<Point> points = circle(radius, step, random.in(1, 6));
    if (points.size() < 20 || points.size() > 2000) continue;
    const Smoothed smoothed = smooth(points, tolerance);
    EXPECT_EQ(smoothed.chains, 1U) << i;
    EXPECT_EQ(joined(smoothed), smoothed.pieces.size() - 1) << i;
    EXPECT_LT(4 * smoothed.pieces.size(), points.size()) << i;
    expect_smooth(smoothed);
    expect_near_the_lines(smoothed, points, tolerance);
    for (const Made& made : smoothed.pieces) {
      for (double s = 0; s <= 1; s += 1.0 / 64) {
        const TipPoint p = made.piece.curve.at(s * made.piece.curve.length());
        ASSERT_NEAR(std::hypot(p.values[0], p.values[1]), radius, tolerance) << i;
      }
    }
  }
}

struct RandomLines {
  std::vector<Point> points;
  double tolerance = 0;
};

// A walk that turns a little from line to line, now and then a lot; feeds change now and then.
RandomLines random_lines(SeededRandom& random) {
  RandomLines lines;
  lines.tolerance = random.size(1e-4, 0.05);
  const int count = random.count(2, 300);
  const double most_turn = random.size(0.001, 0.5);
  const double length = random.size(0.01, 2);
  double heading = random.in(-kPi, kPi);
  double rise = 0;
  Point p{{{random.in(-10, 10), random.in(-10, 10), random.in(-10, 10)}}};
  lines.points.push_back(p);
  for (int i = 0; i < count; ++i) {
    heading += random.count(0, 30) == 0 ? random.in(-3, 3) : random.in(-most_turn, most_turn);
    rise += random.in(-most_turn, most_turn) / 2;
    const double l = length * random.in(0.3, 1);
    p.at.values[0] += l * std::cos(heading) * std::cos(rise);
    p.at.values[1] += l * std::sin(heading) * std::cos(rise);
    p.at.values[2] += l * std::sin(rise);
    if (random.count(0, 40) == 0) p.feed = random.in(1, 100);
    if (random.count(0, 100) == 0) p.fixed_override = !p.fixed_override;
    lines.points.push_back(p);
  }
  return lines;
}

TEST(ChainSmoother, LeavesNoLineByMoreThanTheTolerance) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 500; ++i) {
    const RandomLines lines = random_lines(random);
    const Smoothed smoothed = smooth(lines.points, lines.tolerance);
    expect_near_the_lines(smoothed, lines.points, lines.tolerance);
    expect_smooth(smoothed);
    ASSERT_EQ(smoothed.pieces.front().first, 0U);
    ASSERT_EQ(smoothed.pieces.back().last, lines.points.size() - 1);
    if (HasFatalFailure()) FAIL() << "lines " << i;
  }
}

TEST(ChainSmoother, AFeedChangesExactlyWhereALineEnds) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 500; ++i) {
    const RandomLines lines = random_lines(random);
    for (const Made& made : smooth(lines.points, lines.tolerance).pieces) {
      const Point& first = lines.points[made.first + 1];
      for (std::size_t n = made.first + 1; n <= made.last; ++n) {
        ASSERT_EQ(lines.points[n].feed, first.feed) << i;
        ASSERT_EQ(lines.points[n].fixed_override, first.fixed_override) << i;
      }
    }
  }
}

TEST(ChainSmoother, AFeedThatChangesOnACircleDoesNotBreakTheCurve) {
  std::vector<Point> points = circle(20, 0.2, 3);
  for (std::size_t n = 101; n < points.size(); ++n) points[n].feed = 20;
  const Smoothed smoothed = smooth(points, 0.0025);
  EXPECT_EQ(joined(smoothed), smoothed.pieces.size() - 1);
  EXPECT_TRUE(std::any_of(smoothed.pieces.begin(), smoothed.pieces.end(),
                          [](const Made& made) { return made.last == 100; }));
  expect_smooth(smoothed);
}

TEST(ChainSmoother, ItsEndsAreExact) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 500; ++i) {
    const RandomLines lines = random_lines(random);
    for (const Made& made : smooth(lines.points, lines.tolerance).pieces) {
      if (made.begins_chain) {
        EXPECT_EQ(made.piece.curve.at(0), lines.points[made.first].at);
      }
      if (made.ends_chain) {
        EXPECT_EQ(made.piece.curve.end(), lines.points[made.last].at);
      }
    }
  }
}

// Points of a circle rounded to 1e-4 mm. Without smoothing their third differences jump by up to
// eight half digits over the cube of the step.
TEST(ChainSmoother, TheRoundingOfPointsDoesNotGoIntoTheCurve) {
  constexpr double kDigit = 1e-4;
  constexpr double kStep = 0.1;
  constexpr double kTolerance = 0.0025;
  const std::vector<Point> points = circle(10, kStep, 6, kDigit);
  double raw = 0;
  for (std::size_t n = 3; n < points.size(); ++n) {
    for (std::size_t m = 0; m < 2; ++m) {
      const double third = points[n].at.values[m] - 3 * points[n - 1].at.values[m] +
                           3 * points[n - 2].at.values[m] - points[n - 3].at.values[m];
      raw = std::max(raw, std::fabs(third) / (kStep * kStep * kStep));
    }
  }
  constexpr double kOfTheCircle = 0.01;
  EXPECT_GT(raw, 20 * kOfTheCircle);
  const Smoothed smoothed = smooth(points, kTolerance);
  EXPECT_EQ(joined(smoothed), smoothed.pieces.size() - 1);
  double third = 0;
  for (const Made& made : smoothed.pieces) {
    const motion::CurveBounds bounds = made.piece.curve.bounds(0, made.piece.curve.length());
    for (const double value : bounds.third.values) third = std::max(third, value);
  }
  EXPECT_LT(third, 1.1 * kOfTheCircle);
  expect_near_the_lines(smoothed, points, kTolerance);
}

TEST(ChainSmoother, NeverGoesRoundACornerThatTurnsMoreThanTwentyDegrees) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 1000; ++i) {
    const double turn = random.in(20.5, 180) * kPi / 180;
    const double heading = random.in(-kPi, kPi);
    const double length = random.size(0.001, 1);
    Follower follower(nullptr);
    ChainSmoother chain(1e3, kAxes, kLinear, follower);
    chain.start({});
    const TipPoint first{{length * std::cos(heading), length * std::sin(heading)}};
    chain.add(first, length, {10}, {});
    TipPoint next = first;
    next.values[0] += length * std::cos(heading + turn);
    next.values[1] += length * std::sin(heading + turn);
    EXPECT_FALSE(chain.accepts(next, length)) << turn;
  }
}

// Two lines stand for an arc at most when its height over the longer one is within the tolerance.
TEST(ChainSmoother, LongLinesAreNoPartOfACurve) {
  constexpr double kTolerance = 0.01;
  Follower follower(nullptr);
  ChainSmoother chain(kTolerance, kAxes, kLinear, follower);
  chain.start({});
  chain.add({{10, 0}}, 10, {10}, {});
  const auto accepts = [&](double turn) {
    return chain.accepts({{10 + 10 * std::cos(turn), 10 * std::sin(turn)}}, 10);
  };
  EXPECT_TRUE(accepts(0.9 * 8 * kTolerance / 10));
  EXPECT_FALSE(accepts(1.1 * 8 * kTolerance / 10));
}

TEST(ChainSmoother, FewLinesStayLines) {
  const Smoothed smoothed = smooth(circle(10, 0.1, 0.035), 0.01);
  ASSERT_EQ(smoothed.pieces.size(), 3U);
  for (const Made& made : smoothed.pieces) {
    EXPECT_TRUE(made.piece.curve.is_line());
    EXPECT_FALSE(made.piece.joined);
  }
}

}  // namespace
}  // namespace kerf::planner
