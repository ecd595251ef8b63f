// Jets: functions whose derivatives are known, and differences of jets for the others.
#include "geometry/jet.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "seeded_random.hpp"

namespace kerf::geometry {
namespace {

using test::kSeed;
using test::SeededRandom;

/// s itself, as a jet.
constexpr Jet parameter(double s) { return {s, 1, 0, 0}; }

void expect_near(const Jet& jet, const Jet& wanted, double tolerance = 1e-12) {
  EXPECT_NEAR(jet.value, wanted.value, tolerance * (1 + std::fabs(wanted.value)));
  EXPECT_NEAR(jet.first, wanted.first, tolerance * (1 + std::fabs(wanted.first)));
  EXPECT_NEAR(jet.second, wanted.second, tolerance * (1 + std::fabs(wanted.second)));
  EXPECT_NEAR(jet.third, wanted.third, tolerance * (1 + std::fabs(wanted.third)));
}

TEST(Jet, SumsAndProductsArePolynomials) {
  constexpr Jet s = parameter(3);
  constexpr Jet cube = s * s * s - 2.0 * s + 5;
  static_assert(cube == Jet{26, 25, 18, 6});
  static_assert(1 - cube == Jet{-25, -25, -18, -6});
  static_assert(-cube + cube == Jet{});
  static_assert(cube - 26 == Jet{0, 25, 18, 6});
}

TEST(Jet, AQuotientTimesItsDivisorIsTheDividend) {
  constexpr Jet s = parameter(2);
  static_assert(Jet{1} / s == Jet{0.5, -0.25, 0.25, -0.375});
  SeededRandom random(kSeed);
  const auto any = [&] {
    return Jet{random.in(-9, 9), random.in(-9, 9), random.in(-9, 9), random.in(-9, 9)};
  };
  for (int i = 0; i < 10'000; ++i) {
    const Jet a = any();
    Jet b = any();
    b.value = std::copysign(1 + std::fabs(b.value), b.value);
    expect_near(a / b * b, a, 1e-9);
  }
}

TEST(Jet, RootsAreThoseOfCalculus) {
  expect_near(sqrt(parameter(4)), {2, 1 / 4.0, -1 / 32.0, 3 / 256.0});
  expect_near(hypot(parameter(3), Jet{4}), {5, 3 / 5.0, 16 / 125.0, -144 / 3125.0});
  const Jet far{1e200, 1, 0, 0};
  EXPECT_EQ(hypot(far, far).value, std::hypot(1e200, 1e200)) << "the value does not overflow";
}

TEST(Jet, SineAndCosineTurnIntoEachOther) {
  const double k = radians(1.0);
  for (const double at : {0.0, 30.0, 90.0, 217.0, -450.0, 720.0}) {
    const auto [s, c] = sine_cosine_deg(at);
    const auto [sine, cosine] = sine_cosine_deg(parameter(at));
    expect_near(sine, {s, k * c, -k * k * s, -k * k * k * c});
    expect_near(cosine, {c, -k * s, -k * k * c, k * k * k * s});
  }
  EXPECT_EQ(sine_cosine_deg(parameter(180)).sine.value, 0) << "exact at right angles";
}

TEST(Jet, ArcTangentUndoesSineAndCosine) {
  const Jet angle{40, 3, -2, 7};
  for (const double turned : {0.0, 90.0, 135.0, -170.0}) {
    const auto [sine, cosine] = sine_cosine_deg(angle + turned);
    const Jet back = degrees(atan2(2.5 * sine, 2.5 * cosine));
    expect_near(back, {nearest_turn(40 + turned, 0), 3, -2, 7});
  }
  const Jet slope = atan2(parameter(1), Jet{1});  // of the arc tangent at 1
  expect_near(slope, {std::atan(1.0), 1 / 2.0, -1 / 2.0, 1 / 2.0});
}

TEST(Jet, EveryOrderIsTheSlopeOfTheOneBelow) {
  const std::function<Jet(const Jet&)> formulas[] = {
      [](const Jet& s) { return s * s / (s + 2); },
      [](const Jet& s) { return sqrt(s * s * s + 1); },
      [](const Jet& s) { return hypot(s - 5, 2 * s); },
      [](const Jet& s) { return atan2(s * s - 3, s); },
      [](const Jet& s) { return sine_cosine_deg(40 * (s * s)).sine; },
      [](const Jet& s) { return sine_cosine_deg(90.0 * s - 7).cosine / s; },
  };
  constexpr double h = 1e-3;
  SeededRandom random(kSeed);
  for (const auto& formula : formulas) {
    for (int i = 0; i < 1000; ++i) {
      const double s = random.in(0.5, 4);
      const Jet near = formula(parameter(s + h)) - formula(parameter(s - h));
      const Jet far = formula(parameter(s + 2 * h)) - formula(parameter(s - 2 * h));
      const Jet slope = (1 / (12 * h)) * (8.0 * near - far);
      const Jet jet = formula(parameter(s));
      const Jet wanted{jet.value, slope.value, slope.first, slope.second};
      expect_near(jet, wanted, 1e-7);
      if (HasFailure()) FAIL() << "at " << s;
    }
  }
}

}  // namespace
}  // namespace kerf::geometry
