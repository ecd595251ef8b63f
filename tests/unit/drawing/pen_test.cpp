#include "drawing/pen.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace kerf::drawing {
namespace {

constexpr double kKappa = 0.5522847498;

/// A sheet to draw on, with one entity.
struct Sheet {
  Reading reading;
  Drawing drawing;
  Canvas canvas{reading, drawing};
  EntityId entity = 0;

  Sheet() {
    canvas.begin_file({}, "test");
    entity = canvas.add(Entity{});
  }
  Pen pen(const Affine& to_mm = {}) { return Pen(canvas, entity, to_mm); }
  contour::Contour path(std::size_t index) { return contour_of(drawing, drawing.paths.at(index)); }
};

double rounded(double value, double step) { return std::round(value / step) * step; }

/// Four cubics that go round, as drawing programs write circles with few decimals.
void draw_round(Pen& pen, Vec2 centre, double radius, double step, double turn = 0) {
  const auto at = [&](double u, double v) {
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    return Vec2{rounded(centre.u + radius * (c * u - s * v), step),
                rounded(centre.v + radius * (s * u + c * v), step)};
  };
  pen.begin(at(1, 0));
  pen.cubic_to(at(1, kKappa), at(kKappa, 1), at(0, 1));
  pen.cubic_to(at(-kKappa, 1), at(-1, kKappa), at(-1, 0));
  pen.cubic_to(at(-1, -kKappa), at(-kKappa, -1), at(0, -1));
  pen.cubic_to(at(kKappa, -1), at(1, -kKappa), at(1, 0));
  pen.close();
}

TEST(Pen, four_cubics_of_a_circle_are_one_circle) {
  Sheet sheet;
  {
    Pen pen = sheet.pen();
    draw_round(pen, {20, 30}, 3, 1e-12);
  }
  const contour::Contour round = sheet.path(0);
  ASSERT_EQ(round.vertices.size(), 2U);
  EXPECT_EQ(round.vertices[0].bulge, 1);
  EXPECT_NEAR(contour::length(round), 6 * std::numbers::pi, 1e-9);
  EXPECT_LE(sheet.drawing.error_mm, 0.001);
  EXPECT_GT(sheet.drawing.error_mm, 0.0002 * 3);  // what such cubics are away from a circle
}

TEST(Pen, they_are_one_circle_also_with_few_decimals_and_turned) {
  for (const double step : {1e-5, 1e-4, 4e-4}) {
    for (const double turn : {0.0, 0.4, 1.1}) {
      Sheet sheet;
      {
        Pen pen = sheet.pen();
        draw_round(pen, {123.4567, 76.54321}, 2.34567, step, turn);
      }
      const contour::Contour round = sheet.path(0);
      ASSERT_EQ(round.vertices.size(), 2U) << step << " " << turn;
      EXPECT_NEAR(contour::length(round), 2 * std::numbers::pi * 2.34567, 10 * step);
      EXPECT_LE(sheet.drawing.error_mm, 0.001);
    }
  }
}

TEST(Pen, what_is_farther_than_a_tenth_of_the_tolerance_from_a_circle_is_none) {
  Sheet sheet;
  {
    Pen pen = sheet.pen();
    draw_round(pen, {0, 0}, 3, 0.01);
    pen.whole({{0, 0}, {3, 0}, {0, 3.003}});
  }
  EXPECT_GT(sheet.path(0).vertices.size(), 3U);
  EXPECT_GT(sheet.path(1).vertices.size(), 3U);
}

TEST(Pen, three_quarters_and_a_line_stay_open_to_the_line) {
  Sheet sheet;
  {
    Pen pen = sheet.pen();
    pen.begin({3, 0});
    pen.cubic_to({3, 3 * kKappa}, {3 * kKappa, 3}, {0, 3});
    pen.cubic_to({-3 * kKappa, 3}, {-3, 3 * kKappa}, {-3, 0});
    pen.close();
  }
  EXPECT_NEAR(contour::length(sheet.path(0)), 3 * std::numbers::pi + 6, 1e-3);
}

TEST(Pen, a_mirrored_circle_of_cubics_goes_round_the_other_way) {
  Sheet sheet;
  {
    Pen pen = sheet.pen(Affine::scaled(1, -1));
    draw_round(pen, {5, 5}, 1, 1e-12);
  }
  ASSERT_EQ(sheet.path(0).vertices.size(), 2U);
  EXPECT_NEAR(contour::area(sheet.path(0)), -std::numbers::pi, 1e-6);
}

TEST(Pen, an_arc_that_begins_where_the_pen_is_needs_no_line_there) {
  Sheet sheet;
  {
    Pen pen = sheet.pen();
    pen.begin({std::cos(0.3) + 1e-9, std::sin(0.3)});
    pen.ellipse({{0, 0}, {1, 0}, {0, 1}}, 0.3, 2);
    pen.end_at({0, 0.5});
  }
  const contour::Contour arc = sheet.path(0);
  ASSERT_EQ(arc.vertices.size(), 2U);
  EXPECT_NEAR(arc.vertices[0].bulge, std::tan(0.5), 1e-12);
  EXPECT_EQ(arc.vertices[1].point, (Vec2{0, 0.5}));
}

}  // namespace
}  // namespace kerf::drawing
