// The cut as lines and arcs, against closed formulas and cells.
#include "stock/sheet/outline.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "stock/sheet/pieces.hpp"

namespace kerf::stock::sheet {
namespace {

using std::numbers::pi;

TEST(Outline, OfASquareHasTheAreaOfItsOracle) {
  const std::vector<Trace> square{straight({0, 0}, {20, 0}), straight({20, 0}, {20, 20}),
                                  straight({20, 20}, {0, 20}), straight({0, 20}, {0, 0})};
  const contour::Region outline = outline_of(square, 0.2);
  ASSERT_EQ(outline.loops.size(), 2U);
  EXPECT_NEAR(area(outline), 15.9914159, 1e-6);
}

TEST(Outline, OfACircleIsARing) {
  for (const double turn : {2 * pi, -2 * pi}) {
    const contour::Region outline = outline_of(std::vector{round({3, 4}, 10, 1, turn)}, 0.2);
    ASSERT_EQ(outline.loops.size(), 2U);
    EXPECT_NEAR(area(outline), 12.5663706, 1e-6);
  }
}

TEST(Outline, OfAPlaceIsADisc) {
  EXPECT_NEAR(area(outline_of(std::vector{straight({1, 1}, {1, 1})}, 0.2)), pi / 100, 1e-9);
  EXPECT_TRUE(outline_of({}, 0.2).is_empty());
}

TEST(Outline, HasTheAreaOfTheCells) {
  std::mt19937 source(17);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(source);
  };
  for (int trial = 0; trial < 5; ++trial) {
    std::vector<Trace> traces;
    Vec2 at{number(-5, 5), number(-5, 5)};
    for (int n = 0; n < 40; ++n) {
      const Vec2 to{number(-5, 5), number(-5, 5)};
      if (n % 3 == 0) {
        traces.push_back(round(to, number(0.5, 3), number(-3, 3), number(-6, 6)));
        at = traces.back().to;
      } else {
        traces.push_back(straight(at, to));
        at = to;
      }
    }
    Sheet sheet(grid_of({{-9, -9}, {9, 9}}, 0.05), {.kerf_mm = 0.3});
    sheet.cut(traces);
    EXPECT_NEAR(area(outline_of(traces, 0.3)) / sheet.cut_mm2(), 1, 0.01);
  }
}

}  // namespace
}  // namespace kerf::stock::sheet
