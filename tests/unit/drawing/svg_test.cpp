#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "svg_sheet.hpp"

namespace kerf::drawing {
namespace {

constexpr double kPi = std::numbers::pi;

// Shapes and paths

TEST(Svg, zero_is_the_lower_left_corner_of_the_page_and_y_goes_up) {
  const Svg svg(page("<rect x='5' y='10' width='20' height='12'/>"));
  expect_box(svg.extents(), {5, 18}, {25, 30});
  EXPECT_NEAR(contour::length(svg.contour(0)), 64, 1e-9);
  EXPECT_EQ(svg.codes(), "");
  const Entity& entity = svg.drawing.entities[0];
  EXPECT_EQ(svg.drawing.names[entity.kind], "rect");
  EXPECT_EQ(entity.line, 2U);
  EXPECT_EQ(svg.drawing.files[0].page_mm, (Vec2{40, 40}));
}

TEST(Svg, a_circle_is_one_circle_and_a_round_corner_one_arc) {
  const Svg svg(page("<circle cx='9' cy='9' r='5'/><rect width='20' height='10' rx='2'/>"));
  EXPECT_EQ(svg.contour(0).vertices.size(), 2U);
  EXPECT_NEAR(contour::length(svg.contour(0)), 10 * kPi, 1e-9);
  EXPECT_EQ(svg.contour(1).vertices.size(), 8U);
  EXPECT_NEAR(contour::length(svg.contour(1)), 2 * (16 + 6) + 4 * kPi, 1e-9);
}

TEST(Svg, radii_of_a_rect_are_half_of_its_sides_at_most_and_follow_each_other) {
  const Svg svg(
      page("<rect width='20' height='10' rx='99' ry='5'/><rect width='20' height='10' ry='5'/>"));
  EXPECT_NEAR(contour::area(svg.contour(0)), -kPi * 10 * 5, 0.1);  // clockwise in the file
  EXPECT_EQ(svg.contour(1).vertices.size(), 6U);
  EXPECT_NEAR(contour::length(svg.contour(1)), 20 + 10 * kPi, 1e-9);
}

TEST(Svg, the_oracle_of_a_cubic_has_its_length) {
  const Svg svg(page("<path d='M0 40C10 10 20 70 30 40'/>"));
  EXPECT_NEAR(contour::length(svg.contour(0)), 47.8608297, 1e-3);
  EXPECT_FALSE(svg.drawing.paths[0].is_closed);
}

TEST(Svg, an_arc_of_a_circle_is_one_arc_that_ends_where_it_says) {
  const Svg svg(page("<path d='M10 20A10 10 0 0 1 30 20'/><path d='M10 20A10 10 0 1 0 20 10'/>"));
  ASSERT_EQ(svg.contour(0).vertices.size(), 2U);
  EXPECT_NEAR(svg.contour(0).vertices[0].bulge, -1, 1e-12);  // clockwise as seen
  EXPECT_EQ(svg.contour(0).vertices[1].point, (Vec2{30, 20}));
  EXPECT_NEAR(contour::length(svg.contour(1)), 15 * kPi, 1e-9);
}

TEST(Svg, radii_that_are_too_small_are_enlarged_and_signs_dropped) {
  const Svg svg(page("<path d='M10 20A-1 -1 0 0 1 30 20'/>"));
  EXPECT_NEAR(contour::length(svg.contour(0)), 10 * kPi, 1e-9);
}

TEST(Svg, an_arc_of_an_ellipse_is_within_the_tolerance) {
  // half of an ellipse 32 by 16: its length is half of 77.507586
  const Svg svg(page("<path d='M4 20A16 8 0 0 1 36 20'/>"));
  EXPECT_NEAR(contour::length(svg.contour(0)), 0.5 * 77.507586, 0.001);
  EXPECT_LE(svg.drawing.error_mm, 0.01);
  expect_box(svg.extents(), {4, 20}, {36, 28}, 0.01);
}

TEST(Svg, glued_flags_and_numbers_are_read) {
  const Svg svg(page("<path d='M20 10a1 1 0 01.5.5'/><path d='m.5.5-1e1.25L3+4'/>"));
  EXPECT_EQ(svg.contour(0).vertices[1].point, (Vec2{20.5, 29.5}));
  const auto& lines = svg.contour(1).vertices;
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[1].point, (Vec2{-9.5, 39.25}));
  EXPECT_EQ(lines[2].point, (Vec2{3, 36}));
  EXPECT_EQ(svg.codes(), "");
}

TEST(Svg, a_path_goes_on_where_it_was_closed) {
  const Svg svg(page("<path d='M5 5h10v10zl0 20'/>"));
  ASSERT_EQ(svg.drawing.paths.size(), 2U);
  EXPECT_TRUE(svg.drawing.paths[0].is_closed);
  EXPECT_EQ(svg.contour(1).vertices[0].point, (Vec2{5, 35}));
  EXPECT_EQ(svg.contour(1).vertices[1].point, (Vec2{5, 15}));
}

TEST(Svg, a_mistake_ends_a_path_and_is_told_with_its_character) {
  const Svg svg(page("<path d='M5 5 L20 20 X 30 5'/>\n<path d='M1 1 L2 2 3'/>\n<path d='L1 1'/>"));
  EXPECT_EQ(svg.codes(), "SVG_PATH SVG_PATH SVG_PATH");
  EXPECT_NE(svg.message(0).find("character 13, 'X'"), std::string::npos) << svg.message(0);
  EXPECT_NE(svg.message(1).find("at its end"), std::string::npos);
  EXPECT_EQ(svg.drawing.findings[1].diagnostic.place.line, 3U);
  EXPECT_EQ(svg.drawing.findings[1].diagnostic.place.column, 1U);
  EXPECT_EQ(svg.drawing.findings[0].diagnostic.severity, base::Severity::warning);
  ASSERT_EQ(svg.drawing.paths.size(), 2U);
  EXPECT_EQ(svg.contour(0).vertices.size(), 2U);
}

TEST(Svg, a_path_that_goes_nowhere_is_points_and_a_last_move_is_none) {
  const Svg svg(page("<path d='M5 5'/><path d='M1 2zM3 4h0'/><path d='M9 9h5M7 7'/>"));
  ASSERT_EQ(svg.drawing.points.size(), 3U);
  EXPECT_EQ(svg.drawing.points[0].at, (Vec2{5, 35}));
  EXPECT_EQ(svg.drawing.points[2].at, (Vec2{3, 36}));
  EXPECT_EQ(svg.drawing.paths.size(), 1U);
}

TEST(Svg, what_is_no_number_or_beyond_all_machines_is_told_and_not_drawn) {
  const Svg svg(
      page("<path d='M0 0L1e999 5'/><path d='M0 0L2e6 5'/><path d='M0 0C1e300 0 3 4 5 5'/>"
           "<circle r='1e200'/>"));
  EXPECT_TRUE(svg.drawing.paths.empty());
  EXPECT_EQ(svg.drawing.findings.size(), 4U);
  EXPECT_EQ(svg.codes().substr(0, 18), "DRAW_NAN DRAW_RANG");
}

// Transforms

TEST(Svg, transforms_are_done_from_the_inside_out) {
  const Svg svg(
      page("<g transform='translate(10,20) scale(2)'><path d='M1 2H3' "
           "transform='rotate(90)'/></g>"));
  // (1,2) turned by 90 is (-2,1), twice (-4,2), moved (6,22), up (6,18); (3,2): (6,14)
  EXPECT_EQ(svg.contour(0).vertices[0].point, (Vec2{6, 18}));
  EXPECT_EQ(svg.contour(0).vertices[1].point, (Vec2{6, 14}));
}

TEST(Svg, a_turn_about_a_point_a_skew_and_a_matrix) {
  const Svg svg(
      page("<path transform='rotate(180 10 10)' d='M5 5H6'/><path transform='skewX(45)' "
           "d='M0 10H1'/><path transform='matrix(1 2 3 4 5 6)' d='M1 1H2'/>"));
  EXPECT_EQ(svg.contour(0).vertices[0].point, (Vec2{15, 25}));
  EXPECT_NEAR(svg.contour(1).vertices[0].point.u, 10, 1e-12);
  EXPECT_EQ(svg.contour(2).vertices[0].point, (Vec2{9, 28}));
}

TEST(Svg, circles_stay_circles_unless_they_are_stretched) {
  const Svg svg(
      page("<circle r='3' transform='translate(9 9) rotate(20) scale(-2)'/>"
           "<circle r='3' transform='translate(9 9) scale(2 1)'/>"));
  EXPECT_EQ(svg.contour(0).vertices.size(), 2U);
  EXPECT_NEAR(contour::length(svg.contour(0)), 12 * kPi, 1e-9);
  EXPECT_GT(svg.contour(1).vertices.size(), 4U);
  EXPECT_NEAR(std::abs(contour::area(svg.contour(1))), 18 * kPi, 0.3);
}

TEST(Svg, a_transform_with_a_mistake_is_told) {
  EXPECT_EQ(Svg(page("<path transform='rotate(1 2)' d='M0 0H1'/>")).codes(), "SVG_PATH");
  EXPECT_EQ(Svg(page("<path transform='turn(1)' d='M0 0H1'/>")).codes(), "SVG_PATH");
}

// Units

TEST(Svg, width_and_view_box_give_the_scale) {
  const Svg svg(
      root("width='100mm' height='50mm' viewBox='0 0 200 100'", "<rect width='20' height='20'/>"));
  expect_box(svg.extents(), {0, 40}, {10, 50});
  EXPECT_EQ(svg.drawing.files[0].unit, "mm");
  EXPECT_EQ(svg.drawing.files[0].unit_from, "viewBox");
  EXPECT_DOUBLE_EQ(svg.drawing.files[0].scale_mm, 0.5);
  EXPECT_EQ(svg.codes(), "");
}

TEST(Svg, units_of_css_are_what_they_are) {
  const std::pair<const char*, double> units[] = {{"1in", 25.4}, {"1cm", 10},     {"72pt", 25.4},
                                                  {"6pc", 25.4}, {"40Q", 10},     {"96px", 25.4},
                                                  {"96", 25.4},  {"25.4mm", 25.4}};
  for (const auto& [width, mm] : units) {
    const Svg svg(root("viewBox='0 0 1 1' width='" + std::string(width) + "'",
                       "<rect width='1' height='1'/>"));
    EXPECT_NEAR(svg.extents().high.u, mm, 1e-9) << width;
    EXPECT_EQ(svg.codes(), "") << width;
  }
}

TEST(Svg, without_a_view_box_a_unit_is_a_px) {
  const Svg svg(root("width='10mm' height='96'", "<rect x='96' width='1in' height='96'/>"));
  expect_box(svg.extents(), {25.4, 0}, {50.8, 25.4});
  EXPECT_EQ(svg.codes(), "");
}

TEST(Svg, a_missing_width_is_told_and_a_unit_is_a_px) {
  for (const char* attributes :
       {"viewBox='0 0 96 96'", "viewBox='0 0 96 96' width='100%' height='100%'"}) {
    const Svg svg(root(attributes, "<rect width='96' height='96'/>"));
    expect_box(svg.extents(), {0, 0}, {25.4, 25.4});
    EXPECT_EQ(svg.codes(), "DRAW_UNIT");
    EXPECT_EQ(svg.drawing.files[0].unit_from, "assumed");
  }
  EXPECT_EQ(Svg(root("", "<rect width='96' height='96'/>")).codes(), "DRAW_UNIT");
}

TEST(Svg, a_side_that_is_missing_follows_the_other) {
  const Svg svg(root("viewBox='0 0 10 20' height='40mm'", "<rect width='10' height='10'/>"));
  expect_box(svg.extents(), {0, 20}, {20, 40});
  EXPECT_EQ(svg.drawing.files[0].page_mm, (Vec2{20, 40}));
}

TEST(Svg, unit_and_dpi_replace_what_the_file_says) {
  Reading inch;
  inch.unit = "in";
  const std::string text =
      root("width='99px' height='99px' viewBox='0 0 2 2'", "<rect width='1' height='1'/>");
  expect_box(Svg(text, inch).extents(), {0, 25.4}, {25.4, 50.8});
  Reading dpi;
  dpi.dpi = 99;
  const Svg svg(text, dpi);
  expect_box(svg.extents(), {0, 12.7}, {12.7, 25.4});
  EXPECT_EQ(svg.codes(), "");
}

TEST(Svg, px_of_illustrator_and_old_inkscape_are_told_with_what_helps) {
  const std::string body = " width='10px' height='10px' viewBox='0 0 10 10'";
  const Svg illustrator("<!-- Generator: Adobe Illustrator 24 -->" + root(body, ""));
  EXPECT_EQ(illustrator.codes(), "DRAW_UNIT");
  EXPECT_EQ(illustrator.drawing.findings[0].diagnostic.hint, "--dpi 72");
  const std::string inkscape =
      "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' inkscape:version='";
  EXPECT_EQ(Svg(root(inkscape + "0.91 r13725'" + body, "")).drawing.findings.at(0).diagnostic.hint,
            "--dpi 90");
  EXPECT_EQ(Svg(root(inkscape + "1.2'" + body, "")).codes(), "");
}

TEST(Svg, another_aspect_is_kept_in_the_middle_or_where_it_says) {
  const std::string inside = "<rect width='20' height='10'/>";
  const std::string size = "width='40mm' height='40mm' viewBox='0 0 20 10' preserveAspectRatio=";
  expect_box(Svg(root(size + "''", inside)).extents(), {0, 10}, {40, 30});
  expect_box(Svg(root(size + "'xMidYMin'", inside)).extents(), {0, 20}, {40, 40});
  expect_box(Svg(root(size + "'none'", inside)).extents(), {0, 0}, {40, 40});
  expect_box(Svg(root(size + "'xMinYMid slice'", inside)).extents(), {0, 0}, {80, 40});
}

}  // namespace
}  // namespace kerf::drawing
