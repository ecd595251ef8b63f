#include "output/picture/drawing/view.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plot_motions.hpp"

namespace kerf::output::plot {
namespace {

constexpr Rect kFrame{100, 50, 400, 300};

Box3 box(const Point3& low, const Point3& high) {
  Box3 result;
  result.add(low);
  result.add(high);
  return result;
}

bool contains(const Rect& rect, Point p) {
  return p.x >= rect.left - 1e-9 && p.x <= rect.right() + 1e-9 && p.y >= rect.top - 1e-9 &&
         p.y <= rect.bottom() + 1e-9;
}

TEST(View, FromAboveShowsXToTheRightAndYUp) {
  const View view(kFromAbove, box({0, 0, 0}, {100, 50, 9}), kFrame, kFrame);
  EXPECT_DOUBLE_EQ(view.scale(), 4);
  EXPECT_EQ(view.map({0, 0, 5}), (Point{100, 300}));
  EXPECT_EQ(view.map({100, 50, 0}), (Point{500, 100}));
}

TEST(View, ALatheShowsZToTheRightAndXUp) {
  const View view(kLathe, box({0, 0, -100}, {50, 0, 0}), kFrame, kFrame);
  EXPECT_EQ(view.map({0, 0, -100}), (Point{100, 300}));
  EXPECT_EQ(view.map({50, 0, 0}), (Point{500, 100}));
}

TEST(View, IsometricShowsAllThreeAxesInTheSameScale) {
  const View view(kIsometric, box({0, 0, 0}, {10, 10, 10}), kFrame, kFrame);
  const Point origin = view.map({0, 0, 0});
  for (const Point3& end : {Point3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    const Point p = view.map(end);
    EXPECT_NEAR(std::hypot(p.x - origin.x, p.y - origin.y), view.scale(), 1e-9);
  }
}

TEST(View, ShowsTheWholeBoxInTheFrame) {
  testing::Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Point3 low{random.next(), random.next(), random.next()};
    Point3 high = low;
    for (double& value : high) value += 1000 * random.next() * random.next();
    for (const Projection& projection : {kFromAbove, kLathe, kIsometric}) {
      const View view(projection, box(low, high), kFrame, kFrame);
      for (const double x : {low[kX], high[kX]}) {
        for (const double y : {low[kY], high[kY]}) {
          for (const double z : {low[kZ], high[kZ]}) {
            EXPECT_TRUE(contains(kFrame, view.map({x, y, z})));
          }
        }
      }
    }
  }
}

TEST(View, TellsTheMillimetresAtItsFrame) {
  const View view(kFromAbove, box({0, 0, 0}, {100, 50, 9}), kFrame, kFrame);
  EXPECT_DOUBLE_EQ(view.left_mm(), 0);
  EXPECT_DOUBLE_EQ(view.right_mm(), 100);
  EXPECT_DOUBLE_EQ(view.bottom_mm(), -12.5);
  EXPECT_DOUBLE_EQ(view.top_mm(), 62.5);
  EXPECT_DOUBLE_EQ(view.x_of(25), 200);
  EXPECT_DOUBLE_EQ(view.y_of(62.5), 50);
}

TEST(Clipped, KeepsWhatLiesInside) {
  const auto part = clipped({200, 100}, {300, 200}, kFrame);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->first, (Point{200, 100}));
  EXPECT_EQ(part->second, (Point{300, 200}));
}

TEST(Clipped, CutsAtTheFrame) {
  const auto part = clipped({-1e6, 100}, {1e6, 100}, kFrame);
  ASSERT_TRUE(part);
  EXPECT_NEAR(part->first.x, 100, 1e-6);
  EXPECT_NEAR(part->second.x, 500, 1e-6);
}

TEST(Clipped, AgreesWithTryingEveryPoint) {
  testing::Random random(9);
  const auto number = [&] { return 800 * random.next() - 100; };
  for (int i = 0; i < 1000; ++i) {
    const double ax = number(), ay = number(), bx = number(), by = number();
    std::optional<Point> first, last;
    for (int k = 0; k <= 4000; ++k) {
      const Point p{ax + (bx - ax) * k / 4000, ay + (by - ay) * k / 4000};
      if (!contains(kFrame, p)) continue;
      if (!first) first = p;
      last = p;
    }
    const auto part = clipped({ax, ay}, {bx, by}, kFrame);
    if (!first) continue;  // a corner may be missed by trying
    ASSERT_TRUE(part);
    EXPECT_NEAR(part->first.x, first->x, 0.3);
    EXPECT_NEAR(part->first.y, first->y, 0.3);
    EXPECT_NEAR(part->second.x, last->x, 0.3);
    EXPECT_NEAR(part->second.y, last->y, 0.3);
    EXPECT_TRUE(contains(kFrame, part->first) && contains(kFrame, part->second));
  }
}

TEST(Clipped, GivesNothingOfALineOutside) {
  EXPECT_FALSE(clipped({0, 0}, {0, 400}, kFrame));
  EXPECT_FALSE(clipped({80, 60}, {110, 40}, kFrame));  // past the corner
  EXPECT_FALSE(clipped({0, 0}, {0, 0}, kFrame));
}

}  // namespace
}  // namespace kerf::output::plot
