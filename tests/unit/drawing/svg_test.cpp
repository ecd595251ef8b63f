#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "drawing/svg/read_svg.hpp"

namespace kerf::drawing {
namespace {

constexpr double kPi = std::numbers::pi;

/// What becomes of an SVG file.
struct Svg {
  Reading reading;
  Drawing drawing;

  explicit Svg(const std::string& text, const Reading& how = {}, const std::string& folder = {})
      : reading(how) {
    Canvas canvas(reading, drawing);
    const auto file = base::SourceFile::from_text("drawing.svg", text);
    read_svg(*file, base::FileId{}, canvas, folder);
  }
  [[nodiscard]] contour::Contour contour(std::size_t index) const {
    return contour_of(drawing, drawing.paths.at(index));
  }
  [[nodiscard]] contour::Box extents() const {
    contour::Box box;
    for (const Path& path : drawing.paths) box.take(contour::extents(contour_of(drawing, path)));
    return box;
  }
  [[nodiscard]] std::string layer(std::size_t entity) const {
    return std::string(drawing.names[drawing.entities.at(entity).layer]);
  }
  /// Codes of all findings, parted by blanks.
  [[nodiscard]] std::string codes() const {
    std::string all;
    for (const Finding& finding : drawing.findings) all += finding.diagnostic.number + " ";
    return all.empty() ? all : all.substr(0, all.size() - 1);
  }
  [[nodiscard]] std::string message(std::size_t index) const {
    return drawing.findings.at(index).diagnostic.message;
  }
  [[nodiscard]] std::size_t ignored(const std::string& what) const {
    for (const Ignored& one : drawing.files[0].ignored)
      if (one.what == what) return one.count;
    return 0;
  }
};

/// 40 mm square, a unit a mm; Y of the file is 40 - y.
std::string page(const std::string& inside) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"40mm\" "
         "height=\"40mm\" viewBox=\"0 0 40 40\">\n" +
         inside + "\n</svg>";
}

std::string root(const std::string& attributes, const std::string& inside) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">" + inside + "</svg>";
}

void expect_box(const contour::Box& box, Vec2 low, Vec2 high, double within = 1e-9) {
  EXPECT_NEAR(box.low.u, low.u, within);
  EXPECT_NEAR(box.low.v, low.v, within);
  EXPECT_NEAR(box.high.u, high.u, within);
  EXPECT_NEAR(box.high.v, high.v, within);
}

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

// Style

TEST(Svg, layers_are_those_of_inkscape_or_colours) {
  const Svg svg(
      page("<g inkscape:groupmode='layer' inkscape:label='Cut out'><rect width='1' height='1' "
           "stroke='red'/></g><rect width='1' height='1' stroke='#0f0' fill='blue'/>"
           "<rect width='1' height='1' fill='rgb(0,0,100%)'/>"));
  EXPECT_EQ(svg.layer(0), "Cut out");
  EXPECT_EQ(svg.layer(1), "#00ff00");
  EXPECT_EQ(svg.layer(2), "#0000ff");
  EXPECT_EQ(text_of(svg.drawing.entities[0].colour), "#ff0000");
}

TEST(Svg, colours_are_names_digits_and_functions) {
  const std::pair<const char*, const char*> colours[] = {
      {"RebeccaPurple", "#663399"},       {"#ABC", "#aabbcc"},
      {"#12345678", "#123456"},           {"rgb(300,-5,12.5)", "#ff000d"},
      {"hsl(120, 100%, 25%)", "#008000"}, {"rgb(1 2 3 / 50%)", "#010203"}};
  for (const auto& [written, colour] : colours) {
    const Svg svg(page(std::string("<rect width='1' height='1' fill='") + written + "'/>"));
    EXPECT_EQ(svg.layer(0), colour) << written;
  }
}

TEST(Svg, what_weighs_more_wins) {
  // attribute < sheet (type < class < id) < style < !important
  const auto layer = [](const std::string& sheet, const std::string& attributes) {
    return Svg(page("<style>" + sheet +
                    "</style><g class='g'><rect id='i' class='k m' width='1' height='1' " +
                    attributes + "/></g>"))
        .layer(0);
  };
  EXPECT_EQ(layer("", "fill='#000001'"), "#000001");
  EXPECT_EQ(layer("rect{fill:#000002}", "fill='#000001'"), "#000002");
  EXPECT_EQ(layer(".k{fill:#000003}rect{fill:#000002}", ""), "#000003");
  EXPECT_EQ(layer("#i{fill:#000004}.k.m{fill:#000003}", ""), "#000004");
  EXPECT_EQ(layer("#i{fill:#000004}", "style='fill:#000005'"), "#000005");
  EXPECT_EQ(layer("rect{fill:#000006!important}", "style='fill:#000005'"), "#000006");
  EXPECT_EQ(layer(".m{fill:#000007}.k{fill:#000008}", ""), "#000008");
  EXPECT_EQ(layer("g rect{fill:#000009}rect{fill:#000002}", ""), "#000009");
  EXPECT_EQ(layer("svg > rect{fill:#000009}rect{fill:#000002}", ""), "#000002");
  EXPECT_EQ(layer("svg > .g > rect.k#i{fill:#00000a}", ""), "#00000a");
  EXPECT_EQ(layer("circle, rect{fill:#00000b}", ""), "#00000b");
  EXPECT_EQ(layer("*{fill:#00000c} /* } */ @font-face{a:b} @import 'x';", ""), "#00000c");
}

TEST(Svg, selectors_and_rules_that_are_not_done_are_counted) {
  const Svg svg(
      page("<style>rect:first-child{fill:red} a+b{fill:red} @media print{rect{fill:red}}</style>"
           "<rect width='1' height='1'/>"));
  EXPECT_EQ(svg.ignored("selector"), 2U);
  EXPECT_EQ(svg.ignored("@media"), 1U);
  EXPECT_EQ(svg.layer(0), "#000000");
}

TEST(Svg, inherit_and_current_colour) {
  const Svg svg(page(
      "<g color='#123456' fill='none' stroke='#00ff00'><rect fill='currentColor' stroke='none' "
      "width='1' height='1'/><g stroke='none'><rect stroke='inherit' fill='red' width='1' "
      "height='1'/></g></g>"));
  EXPECT_EQ(svg.layer(0), "#123456");
  EXPECT_EQ(svg.layer(1), "#ff0000");
}

TEST(Svg, what_is_not_seen_is_counted_and_not_drawn) {
  const Svg svg(
      page("<g display='none'><rect width='1' height='1'/><rect width='1' height='1'/></g>"
           "<rect visibility='hidden' width='1' height='1'/><g opacity='0'><circle r='1'/></g>"
           "<rect fill='none' width='1' height='1'/><line x2='5' fill='red'/>"
           "<rect width='0' height='1'/><path d=''/>"));
  EXPECT_TRUE(svg.drawing.paths.empty());
  EXPECT_EQ(svg.ignored("hidden rect"), 3U);
  EXPECT_EQ(svg.ignored("hidden circle"), 1U);
  EXPECT_EQ(svg.ignored("unpainted rect"), 1U);
  EXPECT_EQ(svg.ignored("unpainted line"), 1U);
  EXPECT_EQ(svg.ignored("rect of no size"), 1U);
  EXPECT_EQ(svg.ignored("path of no size"), 1U);
}

TEST(Svg, a_hidden_layer_is_drawn_if_it_is_named) {
  const std::string text = page(
      "<g inkscape:groupmode='layer' inkscape:label='Marks' style='display:none'>"
      "<rect width='1' height='1'/></g><rect width='1' height='1'/>");
  EXPECT_EQ(Svg(text).drawing.paths.size(), 1U);
  Reading named;
  named.layers = {"Mar*"};
  const Svg svg(text, named);
  ASSERT_EQ(svg.drawing.paths.size(), 1U);
  EXPECT_EQ(svg.layer(0), "Marks");
}

TEST(Svg, fill_rule_is_the_contours_own) {
  const Svg svg(page("<g fill-rule='evenodd'><path d='M0 0h1'/></g><path d='M0 0h1'/>"));
  EXPECT_EQ(svg.drawing.entities[0].rule, FillRule::even_odd);
  EXPECT_EQ(svg.drawing.entities[1].rule, FillRule::non_zero);
}

// Clones

TEST(Svg, a_clone_is_drawn_where_it_is_used_with_the_style_of_there) {
  const Svg svg(
      page("<defs><rect id='r' width='2' height='2'/></defs><use xlink:href='#r' x='5' y='6' "
           "fill='red'/>\n<use href='#r' transform='translate(20)'/>"));
  ASSERT_EQ(svg.drawing.paths.size(), 2U);
  EXPECT_EQ(svg.contour(0).vertices[0].point, (Vec2{5, 34}));
  EXPECT_EQ(svg.layer(0), "#ff0000");
  EXPECT_EQ(svg.layer(1), "#000000");
}

TEST(Svg, a_symbol_fills_the_size_of_its_clone) {
  const Svg svg(
      page("<symbol id='s' viewBox='0 0 10 10'><rect width='10' height='10'/></symbol>"
           "<use href='#s' x='4' width='20' height='10'/>"));
  expect_box(svg.extents(), {9, 30}, {19, 40});
  EXPECT_EQ(svg.codes(), "");
}

TEST(Svg, a_clone_gives_a_nested_svg_its_size) {
  const Svg svg(
      page("<defs><svg id='s' width='10' height='10' viewBox='0 0 5 5'><rect width='5' height='5'/>"
           "</svg></defs><use href='#s' width='20' height='20'/>"));
  expect_box(svg.extents(), {0, 20}, {20, 40});
}

TEST(Svg, a_nested_svg_has_units_of_its_own_and_clips) {
  const Svg svg(
      page("<svg x='5' y='5' width='20' height='20' viewBox='0 0 10 10'><rect width='50%' "
           "height='100%'/></svg><svg width='5' height='5'><rect width='6' height='3'/></svg>"
           "<svg overflow='visible' width='5' height='5'><rect width='6' height='3'/></svg>"));
  expect_box(contour::extents(svg.contour(0)), {5, 15}, {15, 35});
  EXPECT_EQ(svg.codes(), "SVG_CLIP");
}

TEST(Svg, clones_of_themselves_and_of_nothing_are_told) {
  const Svg direct(page("<g id='a'><use href='#a'/></g>"));
  EXPECT_EQ(direct.codes(), "SVG_CYCLE");
  const Svg by_others(
      page("<defs><g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g></defs>"
           "<use href='#a'/>"));
  EXPECT_EQ(by_others.codes(), "SVG_CYCLE");
  EXPECT_EQ(by_others.drawing.findings[0].diagnostic.severity, base::Severity::error);
  EXPECT_EQ(Svg(page("<use href='#nix'/>")).codes(), "SVG_REF");
  EXPECT_EQ(Svg(page("<use href='other.svg#a'/>")).codes(), "SVG_REF");
}

TEST(Svg, clones_are_32_deep_and_no_deeper) {
  const auto chain = [](int deep) {
    std::string text = "<defs><rect id='a0' width='1' height='1'/>";
    for (int i = 1; i < deep; ++i)
      text += "<use id='a" + std::to_string(i) + "' href='#a" + std::to_string(i - 1) + "'/>";
    return Svg(page(text + "</defs><use href='#a" + std::to_string(deep - 1) + "'/>"));
  };
  EXPECT_EQ(chain(32).drawing.paths.size(), 1U);
  EXPECT_EQ(chain(33).codes(), "SVG_CYCLE");
}

TEST(Svg, a_bomb_of_clones_ends_before_it_begins) {
  std::string text = "<defs><g id='a0'/>";  // of nothing that is drawn
  for (int i = 1; i < 20; ++i) {
    text += "<g id='a" + std::to_string(i) + "'>";
    for (int k = 0; k < 10; ++k) text += "<use href='#a" + std::to_string(i - 1) + "'/>";
    text += "</g>";
  }
  const Svg svg(page(text + "</defs><use href='#a19'/>"));
  EXPECT_EQ(svg.codes(), "DRAW_LIMIT");
  EXPECT_TRUE(svg.drawing.paths.empty());
}

TEST(Svg, entities_of_clones_count_for_the_budget) {
  Reading few;
  few.max_entities = 9;
  std::string text = "<rect id='r' width='1' height='1'/>";
  for (int i = 0; i < 10; ++i) text += "<use href='#r'/>";
  EXPECT_EQ(Svg(page(text), few).codes(), "DRAW_LIMIT");
}

TEST(Svg, switch_takes_the_first_that_is_meant) {
  const Svg svg(page(
      "<switch><g requiredExtensions='http://ns.adobe.com/x'><rect width='1' height='1'/></g>"
      "<rect systemLanguage='fr' width='2' height='1'/><rect systemLanguage='de, en-GB' width='3' "
      "height='1'/><rect width='4' height='1'/></switch>"));
  ASSERT_EQ(svg.drawing.paths.size(), 1U);
  EXPECT_NEAR(svg.extents().high.u, 3, 1e-12);
}

// Text, pictures, what is left out

TEST(Svg, text_is_words_with_a_place) {
  const Svg svg(
      page("<text x='5' y='10' font-size='10' text-anchor='middle'>  Two\n words </text>"
           "<text font-size='10'><tspan x='1' y='2'>a<tspan>b</tspan></tspan><tspan x='1' dy='5'>c"
           "</tspan></text>"));
  ASSERT_EQ(svg.drawing.texts.size(), 3U);
  const Text& text = svg.drawing.texts[0];
  EXPECT_EQ(text.words, "Two words");
  EXPECT_NEAR(text.height, 7, 1e-12);
  EXPECT_EQ(text.across, Across::centre);
  EXPECT_EQ(text.to_mm({0, 0}), (Vec2{5, 30}));
  EXPECT_EQ(text.to_mm({0, 1}), (Vec2{5, 31}));
  EXPECT_EQ(svg.drawing.texts[1].words, "ab");
  EXPECT_EQ(svg.drawing.texts[2].to_mm({0, 0}), (Vec2{1, 33}));
}

TEST(Svg, what_is_not_done_is_told) {
  const Svg svg(
      page("<defs><clipPath id='c'/><linearGradient id='g'/></defs>"
           "<rect clip-path='url(#c)' fill='url(#g)' filter='url(#f)' mask='url(#m)' "
           "marker-start='url(#k)' "
           "width='1' height='1'/><rect fill='url(#none) red' width='1' height='1'/>"
           "<rect fill='url(#none)' width='1' height='1'/><foreignObject/>"));
  EXPECT_EQ(svg.codes(), "SVG_CLIP SVG_REF");
  EXPECT_EQ(svg.ignored("linearGradient"), 1U);
  EXPECT_EQ(svg.ignored("filter"), 1U);
  EXPECT_EQ(svg.ignored("mask"), 1U);
  EXPECT_EQ(svg.ignored("marker"), 1U);
  EXPECT_EQ(svg.ignored("unpainted rect"), 1U);
  EXPECT_EQ(svg.ignored("foreignObject"), 1U);
  EXPECT_EQ(svg.drawing.paths.size(), 2U);
}

/// 2 x 1 pixels, grey.
constexpr const char* kPng =
    "data:image/"
    "png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAAAAADRSSBWAAAAC0lEQVR42mNg+A8AAQIBAHoFu3wAAAAA\n"
    "SUVORK5CYII=";

TEST(Svg, a_picture_keeps_its_aspect_in_its_place) {
  const Svg svg(
      page(std::string("<image x='5' y='10' width='10' height='10' href='") + kPng + "'/>"));
  ASSERT_EQ(svg.drawing.images.size(), 1U) << svg.message(0);
  const Image& image = svg.drawing.images[0];
  EXPECT_EQ(image.to_mm({0, 0}), (Vec2{5, 22.5}));
  EXPECT_EQ(image.to_mm({1, 1}), (Vec2{15, 27.5}));
}

TEST(Svg, pictures_come_from_the_folder_of_the_drawing_alone) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "kerf_svg_pictures";
  std::filesystem::create_directories(folder / "inside");
  const std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\2\0\0\0\1\x08\0\0\0\0\xd1\x49\x20\x56",
                        33);
  std::ofstream(folder / "p.png", std::ios::binary) << png;
  std::ofstream(folder / "inside" / "q.png", std::ios::binary) << png;
  std::filesystem::remove(folder / "link.png");
  std::filesystem::create_symlink(folder / "p.png", folder / "link.png");
  const auto codes = [&](const std::string& href, const std::string& where) {
    return Svg(page("<image width='2' height='1' href='" + href + "'/>"), {}, where).codes();
  };
  const std::string here = folder.string();
  // It is found, and has a head alone, which is enough for its place.
  EXPECT_EQ(codes("p.png", here), "IMAGE_BAD");
  EXPECT_EQ(codes("./%70.png", here), "IMAGE_BAD");
  EXPECT_EQ(codes("p.png", ""), "SVG_REF");
  const std::vector<std::string> hrefs = {"inside/q.png",
                                          "../kerf_svg_pictures/p.png",
                                          here + "/p.png",
                                          "file://" + here + "/p.png",
                                          std::string("link.png"),
                                          std::string(".."),
                                          std::string("missing.png"),
                                          std::string("http://example.org/p.png")};
  for (const std::string& href : hrefs) EXPECT_EQ(codes(href, here), "SVG_REF") << href;
  std::filesystem::remove_all(folder);
}

// XML

TEST(Svg, what_is_not_well_formed_is_told_where_and_what_stands_before_is_read) {
  const Svg svg(page("<rect width='1' height='1'/>\n<g></path>"));
  EXPECT_EQ(svg.codes(), "SVG_XML");
  EXPECT_EQ(svg.drawing.findings[0].diagnostic.place.line, 3U);
  EXPECT_EQ(svg.drawing.findings[0].diagnostic.place.column, 6U);
  EXPECT_EQ(svg.drawing.paths.size(), 1U);
  EXPECT_EQ(Svg("").codes(), "SVG_XML");
  EXPECT_EQ(Svg("<html/>").codes(), "SVG_XML");
}

TEST(Svg, entities_are_read_and_those_from_outside_are_not) {
  const Svg svg("<!DOCTYPE svg [<!ENTITY w '5'><!ENTITY r \"<rect width='&w;' height='2'/>\">]>" +
                page("&r;"));
  expect_box(svg.extents(), {0, 38}, {5, 40});
  EXPECT_EQ(
      Svg("<!DOCTYPE svg [<!ENTITY x SYSTEM '/etc/hostname'>]>" + page("<text>&x;</text>")).codes(),
      "SVG_ENTITY");
}

TEST(Svg, entities_expand_to_a_mebibyte_and_no_more) {
  const auto bomb = [](const std::string& use) {
    std::string text = "<!DOCTYPE svg [<!ENTITY a0 '1 1 1 1 1 '>";
    for (int i = 1; i < 12; ++i) {
      text += "<!ENTITY a" + std::to_string(i) + " '";
      for (int k = 0; k < 10; ++k) text += "&a" + std::to_string(i - 1) + ";";
      text += "'>";
    }
    return Svg(text + "]>" + page(use)).codes();
  };
  EXPECT_EQ(bomb("<text>&a11;</text>"), "SVG_ENTITY");
  EXPECT_EQ(bomb("<path d='M&a11;'/>"), "SVG_ENTITY");
  EXPECT_EQ(bomb("<path d='M&a5;'/>"), "");  // 0.95 MiB
  EXPECT_EQ(bomb("<path d='M&a5;'/><path d='M&a5;'/>"), "SVG_ENTITY");
}

TEST(Svg, elements_are_256_deep_and_no_deeper) {
  const auto codes = [](std::size_t deep) {
    std::string text;
    for (std::size_t i = 0; i + 1 < deep; ++i) text += "<g>";
    for (std::size_t i = 0; i + 1 < deep; ++i) text += "</g>";
    return Svg(page(text)).codes();
  };
  EXPECT_EQ(codes(256), "");
  EXPECT_EQ(codes(257), "SVG_XML");
  EXPECT_EQ(codes(100000), "SVG_XML");
}

TEST(Svg, inkscapes_circle_of_few_decimals_is_a_circle) {
  const Svg svg(page(
      "<path d='m 23.333,20 c 0,1.841 -1.492,3.333 -3.333,3.333 -1.841,0 -3.333,-1.492 "
      "-3.333,-3.333 0,-1.841 1.492,-3.333 3.333,-3.333 1.841,0 3.333,1.492 3.333,3.333 z'/>"));
  ASSERT_EQ(svg.contour(0).vertices.size(), 2U);
  EXPECT_NEAR(contour::length(svg.contour(0)), 2 * kPi * 3.333, 0.002);
}

}  // namespace
}  // namespace kerf::drawing
