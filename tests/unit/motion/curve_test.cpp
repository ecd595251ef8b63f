#include "motion/curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "seeded_random.hpp"

namespace kerf::motion {
namespace {

using base::AxisVector;
using base::TipJet;
using base::TipPoint;
using test::kSeed;
using test::SeededRandom;

constexpr std::size_t kAxes = 5;
constexpr int kCases = 3000;

class Random : public SeededRandom {
 public:
  Random() : SeededRandom(kSeed) {}

  AxisVector vector(double size) {
    AxisVector v;
    for (std::size_t m = 0; m < kAxes; ++m) v.values[m] = in(-size, size);
    return v;
  }
  TipJet jet(double length) {
    return {TipPoint(vector(100)), vector(1), vector(1 / length), vector(1 / length / length)};
  }
  double length() { return size(0.001, 1000); }

  Curve line() {
    const double l = length();
    const TipPoint from(vector(100));
    return Curve::line(from, from + vector(l), l, kAxes);
  }
  // What joins two curves differs by little from going straight on.
  TipJet going_on(const TipJet& jet, double l) {
    TipJet next = jet;
    for (std::size_t m = 0; m < kAxes; ++m) {
      const double turn = in(-0.3, 0.3);
      const double bend = jet.second.values[m];
      next.value.values[m] += l * (jet.first.values[m] + l * bend / 2 + turn / 2);
      next.first.values[m] += l * bend + turn;
      next.second.values[m] += in(-1, 1) / l;
    }
    return next;
  }
  Curve hermite() {
    const double l = length();
    const TipJet from = jet(l);
    return Curve::hermite(from, going_on(from, l), l, kAxes);
  }
  Curve cubic() {
    const double l = length();
    const TipJet from = jet(l);
    return Curve::cubic(from, going_on(from, l), l, kAxes);
  }
  ArcShape arc_shape(double l) {
    ArcShape shape;
    shape.origin = vector(100);
    shape.radius = size(0.01, 100);
    shape.angle_rad = in(-3, 3);
    shape.rate = (coin() ? 1 : -1) * size(0.001, 7) / l;
    shape.radius_slope = in(-0.01, 0.01) * shape.radius * shape.rate;
    double e1[3];
    double e2[3];
    double norm = 0;
    for (double& value : e1) norm = std::hypot(norm, value = in(-1, 1));
    for (double& value : e1) value /= norm;
    // Perpendicular to e1, from any other direction.
    double along = 0;
    for (std::size_t m = 0; m < 3; ++m) along += (e2[m] = in(-1, 1)) * e1[m];
    norm = 0;
    for (std::size_t m = 0; m < 3; ++m) norm = std::hypot(norm, e2[m] -= along * e1[m]);
    for (std::size_t m = 0; m < 3; ++m) {
      shape.e1.values[m] = e1[m];
      shape.e2.values[m] = e2[m] / norm;
    }
    for (std::size_t m = 3; m < kAxes; ++m) shape.slope.values[m] = in(-2, 2);
    return shape;
  }
  static TipPoint point_of(const ArcShape& shape, double s) {
    const double angle = shape.angle_rad + shape.rate * s;
    const double radius = shape.radius + shape.radius_slope * s;
    AxisVector p = shape.origin;
    for (std::size_t m = 0; m < kAxes; ++m) {
      p.values[m] += s * shape.slope.values[m] + radius * (std::cos(angle) * shape.e1.values[m] +
                                                           std::sin(angle) * shape.e2.values[m]);
    }
    return TipPoint(p);
  }
  Curve arc() {
    const double l = length();
    const ArcShape shape = arc_shape(l);
    return Curve::arc(shape, point_of(shape, l), l, kAxes);
  }
  // As programs have it: in the plane of two axes, often from one quarter to the next.
  Curve plane_arc() {
    const double l = length();
    ArcShape shape = arc_shape(l);
    shape.e1 = shape.e2 = {};
    shape.e1.values[0] = shape.e2.values[1] = 1;
    if (coin()) {
      shape.angle_rad = std::numbers::pi / 2 * static_cast<int>(in(-2, 3));
      shape.rate = (coin() ? 1 : -1) * std::numbers::pi / 2 / l;
    }
    return Curve::arc(shape, point_of(shape, l), l, kAxes);
  }
};

struct Kind {
  const char* name;
  Curve (Random::*make)();
};
constexpr Kind kKinds[] = {{"line", &Random::line},
                           {"hermite", &Random::hermite},
                           {"cubic", &Random::cubic},
                           {"arc", &Random::arc},
                           {"plane arc", &Random::plane_arc}};

double largest(const AxisVector& v) {
  double most = 0;
  for (const double value : v.values) most = std::max(most, std::fabs(value));
  return most;
}

void expect_near(const AxisVector& got, const AxisVector& wanted, double tolerance,
                 const std::string& what) {
  ASSERT_LE(largest(got - wanted), tolerance) << what;
}

// Hermite: value, first and second derivative of both ends. Cubic: value and first.

TEST(Curve, LeavesAndArrivesInTheJetsGiven) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    const double l = random.length();
    const TipJet from = random.jet(l);
    const TipJet to = random.jet(l);
    // Values are up to 100, slopes of the way between them up to 200 / l.
    const double rounding = 1e-11 * (1 + 200 / l);
    for (const bool hermite : {true, false}) {
      const Curve curve =
          hermite ? Curve::hermite(from, to, l, kAxes) : Curve::cubic(from, to, l, kAxes);
      EXPECT_EQ(curve.length(), l);
      EXPECT_EQ(curve.end(), to.value);
      EXPECT_EQ(curve.at(0), from.value);
      EXPECT_EQ(curve.at(l), to.value);
      expect_near(curve.jet(0).first, from.first, 1e-12, "first");
      expect_near(curve.jet(l).first, to.first, rounding, "first at the end");
      if (!hermite) continue;
      expect_near(curve.jet(0).second, from.second, 1e-12 / l, "second");
      expect_near(curve.jet(l).second, to.second, 10 * rounding / l, "second at the end");
    }
  }
}

TEST(Curve, BetweenTwoLinesACubicIsAParabola) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    const double reach = random.length();
    TipJet in;
    TipJet out;
    in.value = TipPoint(random.vector(100));
    in.first = random.vector(1);
    out.first = random.vector(1);
    for (std::size_t m = 0; m < kAxes; ++m)
      out.value.values[m] = in.value.values[m] + reach * (in.first.values[m] + out.first.values[m]);
    const Curve curve = Curve::cubic(in, out, 2 * reach, kAxes);
    for (const double s : {0.0, 0.3 * reach, reach, 1.9 * reach}) {
      const TipJet jet = curve.jet(s);
      for (std::size_t m = 0; m < kAxes; ++m) {
        const double bend = (out.first.values[m] - in.first.values[m]) / (2 * reach);
        ASSERT_NEAR(jet.second.values[m] * reach, bend * reach, 1e-12 * (1 + 100 / reach)) << i;
      }
    }
  }
}

TEST(Curve, IsWhereItsEquationSays) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    const double l = random.length();
    const ArcShape shape = random.arc_shape(l);
    const TipPoint end = Random::point_of(shape, l);
    const Curve arc = Curve::arc(shape, end, l, kAxes);
    const double s = random.in(0, l);
    expect_near(arc.at(s), Random::point_of(shape, s), 1e-11, "arc");
    EXPECT_EQ(arc.at(l), end);
    EXPECT_NEAR(arc.length_at_first_radius(), shape.radius * std::fabs(shape.rate) * l,
                1e-12 * shape.radius);
    const TipPoint to(random.vector(100));
    const Curve line = Curve::line(TipPoint(shape.origin), to, l, kAxes);
    AxisVector between;
    for (std::size_t m = 0; m < kAxes; ++m)
      between.values[m] = std::lerp(shape.origin.values[m], to.values[m], s / l);
    expect_near(line.at(s), between, 1e-11, "line");
    EXPECT_EQ(line.at(0), TipPoint(shape.origin));
    EXPECT_EQ(line.at(l), to);
  }
}

// Of a function of a curve's parameter, from four neighbours: the error is of the fourth order.
AxisVector central_difference(const std::function<AxisVector(double)>& f, double s, double h) {
  const AxisVector near = f(s + h) - f(s - h);
  const AxisVector far = f(s + 2 * h) - f(s - 2 * h);
  AxisVector slope;
  for (std::size_t m = 0; m < base::kMaxAxes; ++m)
    slope.values[m] = (8 * near.values[m] - far.values[m]) / (12 * h);
  return slope;
}

TEST(Curve, DerivativesAreThoseOfCentralDifferences) {
  Random random;
  for (const Kind& kind : kKinds) {
    for (int i = 0; i < kCases; ++i) {
      const Curve curve = (random.*kind.make)();
      const double l = curve.length();
      const double h = 1e-3 * l;
      const double s = random.in(0.01, 0.99) * l;
      const TipJet jet = curve.jet(s);
      const auto part = [&](auto derivative) {
        return [&curve, derivative](double at) -> AxisVector { return curve.jet(at).*derivative; };
      };
      // Scales of what is differentiated; rounding of values up to a few hundred over h.
      const double first = largest(curve.bounds(0, l).first);
      const double second = largest(curve.bounds(0, l).second);
      const double third = largest(curve.bounds(0, l).third);
      const std::string what = std::string(kind.name) + " " + std::to_string(i);
      expect_near(jet.value, curve.at(s), 1e-12, what + " value");
      expect_near(jet.first, central_difference(part(&TipJet::value), s, h),
                  1e-8 * first + 3e-13 / h, what + " first");
      expect_near(jet.second, central_difference(part(&TipJet::first), s, h),
                  1e-8 * second + 1e-13 * first / h, what + " second");
      expect_near(jet.third, central_difference(part(&TipJet::second), s, h),
                  1e-8 * third + 1e-13 * second / h, what + " third");
    }
  }
}

TEST(Curve, TheRateAloneIsThatOfTheJet) {
  Random random;
  for (const Kind& kind : kKinds) {
    for (int i = 0; i < kCases; ++i) {
      const Curve curve = (random.*kind.make)();
      for (const double share : {0.0, random.in(0, 1), 1.0}) {
        const double s = share * curve.length();
        ASSERT_EQ(curve.rate(s), curve.jet(s).first) << kind.name << ' ' << i;
      }
    }
  }
}

TEST(Curve, TheRateOfACubicIsAMeanOfThree) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    const Curve curve = random.cubic();
    const double x = random.in(0, 1);
    const AxisVector begin = curve.rate(0);
    const AxisVector between = curve.rate_between();
    const AxisVector end = curve.rate(curve.length());
    AxisVector mean;
    for (std::size_t m = 0; m < kAxes; ++m) {
      mean.values[m] = (1 - x) * (1 - x) * begin.values[m] + 2 * x * (1 - x) * between.values[m] +
                       x * x * end.values[m];
    }
    expect_near(curve.rate(x * curve.length()), mean, 1e-12, std::to_string(i));
  }
}

// Over a random part of the curve, at many places and at both ends.
TEST(Curve, NoDerivativeExceedsItsBoundAndTheBoundIsNear) {
  constexpr int kPlaces = 100;
  constexpr double kNear = 3;
  constexpr double kSpiral = 0.05;  // what a change of the radius by 1 % a radian may add
  Random random;
  for (const Kind& kind : kKinds) {
    for (int i = 0; i < kCases; ++i) {
      const Curve curve = (random.*kind.make)();
      const double one = random.in(0, curve.length());
      const double other = random.in(0, curve.length());
      const double from = i % 3 == 0 ? 0 : std::min(one, other);
      const double to = i % 3 == 0 ? curve.length() : std::max(one, other);
      const CurveBounds bounds = curve.bounds(from, to);
      CurveBounds most;
      for (int n = 0; n <= kPlaces; ++n) {
        const TipJet jet = curve.jet(from + (to - from) * n / kPlaces);
        const auto raise = [](AxisVector& bound, const AxisVector& value) {
          for (std::size_t m = 0; m < kAxes; ++m)
            bound.values[m] = std::max(bound.values[m], std::fabs(value.values[m]));
        };
        raise(most.first, jet.first);
        raise(most.second, jet.second);
        raise(most.third, jet.third);
      }
      for (AxisVector CurveBounds::*const derivative :
           {&CurveBounds::first, &CurveBounds::second, &CurveBounds::third}) {
        const double scale = largest(most.*derivative);
        for (std::size_t m = 0; m < kAxes; ++m) {
          const double bound = (bounds.*derivative).values[m];
          const double value = (most.*derivative).values[m];
          ASSERT_GE(bound, value - 1e-12 * scale) << kind.name << " " << i << " axis " << m;
          ASSERT_LE(bound, kNear * value + kSpiral * scale)
              << kind.name << " " << i << " axis " << m;
        }
      }
    }
  }
}

}  // namespace
}  // namespace kerf::motion
