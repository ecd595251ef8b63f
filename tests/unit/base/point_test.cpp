#include "base/point.hpp"

#include <gtest/gtest.h>

#include <concepts>
#include <type_traits>

namespace kerf::base {
namespace {

// What must not compile.

template <typename A, typename B>
concept Subtracts = requires(A a, B b) {
  a - b;
};
template <typename A, typename B>
concept Adds = requires(A a, B b) {
  a + b;
};
template <typename A, typename B>
concept Compares = requires(A a, B b) {
  { a == b } -> std::convertible_to<bool>;
};

template <typename A, typename B>
constexpr bool kDoNotMix =
    !Subtracts<A, B> && !Adds<A, B> && !Compares<A, B> && !std::constructible_from<A, B> &&
    !std::convertible_to<B, A> && !std::is_assignable_v<A&, B>;

static_assert(kDoNotMix<ProgramPoint, PathPoint>);
static_assert(kDoNotMix<PathPoint, TipPoint>);
static_assert(kDoNotMix<TipPoint, MachinePoint>, "a tool length is between them");
static_assert(kDoNotMix<MachinePoint, TipPoint>);
static_assert(kDoNotMix<TipPoint, JointPoint>, "a linkage is between them");
static_assert(kDoNotMix<ProgramPoint, MachinePoint>, "work offsets are between them");

static_assert(!std::convertible_to<AxisVector, TipPoint>, "numbers alone are no point");
static_assert(!std::is_assignable_v<TipPoint&, AxisVector>);
static_assert(!Adds<TipPoint, TipPoint>, "two places have no sum");

// What must.

static_assert(std::same_as<decltype(TipPoint() - TipPoint()), AxisVector>, "a way");
static_assert(std::same_as<decltype(TipPoint() + AxisVector()), TipPoint>);
static_assert(std::same_as<decltype(TipPoint() - AxisVector()), TipPoint>);
static_assert(std::constructible_from<TipPoint, AxisVector>, "where somebody says so");
static_assert(std::convertible_to<TipPoint, AxisVector>);
static_assert(Compares<TipPoint, TipPoint>);
static_assert(std::is_trivially_copyable_v<TipPoint> && sizeof(TipPoint) == sizeof(AxisVector));

TEST(Point, WhatIsAddedToATipForTheMachineIsTakenAwayOnTheWayBack) {
  const TipPoint tip{1, -2, 3};
  AxisVector length;
  length[Axis{2}] = 80;
  const MachinePoint machine = machine_of(tip, length);
  EXPECT_EQ(machine, (MachinePoint{1, -2, 83}));
  EXPECT_EQ(tip_of(machine, length), tip);
}

TEST(Point, ANumberThatIsNotWrittenIsZero) {
  EXPECT_EQ((TipPoint{4}), (TipPoint{{4, 0, 0, 0, 0, 0, 0, 0}}));
}

}  // namespace
}  // namespace kerf::base
