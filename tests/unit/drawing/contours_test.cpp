#include <gtest/gtest.h>

#include <cmath>

#include "drawing/contours/contours_reader.hpp"
#include "drawing/contours/contours_writer.hpp"
#include "drawing/dxf/dxf_reader.hpp"
#include "drawn.hpp"

namespace kerf::drawing {
namespace {

using Writer = void (*)(const std::vector<ContourLayer>&, const WritePiece&);

std::string written(Writer writer, const std::vector<ContourLayer>& layers) {
  std::string text;
  writer(layers, [&](std::string_view piece) { text += piece; });
  return text;
}

std::vector<ContourLayer> plate() {
  const contour::Contour slot{{{{0.1, 0.2}, 0}, {{40, 0.2}, 1}, {{40, 20}, 0}, {{0.1, 20}, 1}},
                              true};
  const contour::Contour open{{{{-5, 1e-7}, -0.3}, {{1.0 / 3, 7}, 0}}, false};
  return {{"CUT", Colour{0xFF0000}, {slot, open}}, {"切割 \"<&>", Colour{0x0000FF}, {slot}}};
}

Drawn read(const std::string& text, Reading how = {}) { return Drawn(read_contours, text, how); }

TEST(Contours, are_read_as_they_were_written_to_the_last_bit) {
  const std::string json = written(write_contours_json, plate());
  const Drawn drawn = read(json);
  EXPECT_EQ(drawn.findings(), "");
  const std::vector<ContourLayer> layers = plate();
  ASSERT_EQ(drawn.drawing.paths.size(), 3U);
  const contour::Contour* const wanted[] = {&layers[0].contours[0], &layers[0].contours[1],
                                            &layers[1].contours[0]};
  for (std::size_t i = 0; i < 3; ++i) {
    contour::Contour path = drawn.path(i);
    for (contour::Vertex& vertex : path.vertices) vertex.owner = 0;
    EXPECT_EQ(path, *wanted[i]);
    EXPECT_EQ(drawn.layer_of(i), layers[i / 2].name);
    EXPECT_EQ(drawn.entity_of(i).colour, layers[i / 2].colour);
  }
  EXPECT_EQ(drawn.entity_of(1).line, 4U);
}

TEST(Contours, come_back_from_a_dxf) {
  const Drawn drawn(read_dxf, written(write_contours_dxf, plate()));
  EXPECT_EQ(drawn.findings(), "");
  const std::vector<ContourLayer> layers = plate();
  ASSERT_EQ(drawn.drawing.paths.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(length(drawn.path(i)), length(layers[i / 2].contours[i % 2]));
    EXPECT_EQ(drawn.layer_of(i), layers[i / 2].name);
    EXPECT_EQ(drawn.entity_of(i).colour, layers[i / 2].colour);
  }
}

TEST(Contours, of_a_single_point_are_points_of_a_dxf) {
  const std::vector<ContourLayer> holes{{"H", Colour{}, {{{{{3, 4}}}, false}}}};
  const Drawn drawn(read_dxf, written(write_contours_dxf, holes));
  ASSERT_EQ(drawn.drawing.points.size(), 1U);
  EXPECT_EQ(drawn.drawing.points[0].at, (Vec2{3, 4}));
}

TEST(Contours, are_an_svg_on_a_page_that_has_the_zero) {
  const std::string svg = written(write_contours_svg, plate());
  EXPECT_NE(svg.find("<g inkscape:groupmode=\"layer\" inkscape:label=\"切割 &quot;&lt;&amp;>\" "
                     "stroke=\"#0000ff\">"),
            std::string::npos);
  // The half circle left of the slot reaches to -9.8; Y goes down from 20.
  EXPECT_NE(svg.find("viewBox=\"0 0 59.7 20\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("M9.9 19.8L49.8 19.8A9.9 9.9 0 0 0 49.8 0L9.9 0A9.9 9.9 0 0 0 9.9 19.8Z"),
            std::string::npos)
      << svg;
}

TEST(Contours, may_have_their_members_in_any_order_and_others_beside) {
  const Drawn drawn = read(
      R"({"made":{"by":[1,{"layers":2}]},"layers":[{"contours":[{"points":[[0,0],[2,0]],"x":null}],)"
      R"("colour":"#00FF00","name":"A"}],"unit":"in"})");
  EXPECT_EQ(drawn.findings(), "");
  EXPECT_DOUBLE_EQ(length(drawn.path(0)), 50.8);
  EXPECT_EQ(drawn.layer_of(0), "A");
  EXPECT_EQ(text_of(drawn.entity_of(0).colour), "#00ff00");
}

TEST(Contours, another_unit_or_layer_may_be_asked_for) {
  const std::string text =
      R"({"layers":[{"name":"A","contours":[{"points":[[0,0],[2,0]]}]},{"name":"B","contours":[]}]})";
  Reading cm;
  cm.unit = "cm";
  EXPECT_DOUBLE_EQ(length(read(text, cm).path(0)), 20);
  Reading other;
  other.layers = {"B"};
  EXPECT_TRUE(read(text, other).drawing.paths.empty());
}

TEST(Contours, what_is_wrong_is_told_with_line_and_column) {
  const std::string begin = "{\"layers\":[{\"contours\":[\n";
  const auto told = [&](const std::string& text) {
    const Drawn drawn = read(text);
    if (drawn.drawing.findings.size() != 1) return std::string("no finding");
    const base::Diagnostic& finding = drawn.drawing.findings[0].diagnostic;
    return finding.number + " " + std::to_string(finding.place.line) + " " + finding.message;
  };
  EXPECT_EQ(told(begin + "{\"points\":[[1,2],\n[3]]}]}]}"),
            "CONTOURS_FILE 3 no contours: a point has at least x and y");
  EXPECT_EQ(told(begin + "{\"points\":[[1,true]]}]}]}"),
            "CONTOURS_FILE 2 no contours: a number is expected, not true or false");
  EXPECT_EQ(told(begin + "{\"points\":[[1,2,3,4]]}]}]}"),
            "CONTOURS_FILE 2 no contours: a point has x, y and a bulge, and no more");
  EXPECT_EQ(told(begin + "{\"points\":[]}]}]}"),
            "CONTOURS_FILE 2 no contours: a contour has no points");
  EXPECT_EQ(told(begin + "7]}]}"),
            "CONTOURS_FILE 2 no contours: an object is expected, and here is a number");
  EXPECT_EQ(told("[]"), "CONTOURS_FILE 1 no contours: an object is expected");
  EXPECT_EQ(told("{\"layers\":[{\"colour\":\"red\"}]}"),
            "CONTOURS_FILE 1 no contours: a colour is #rrggbb");
  EXPECT_EQ(told("{\"layers\":3}"), "CONTOURS_FILE 1 no contours: 'layers' cannot be a number");
  EXPECT_EQ(
      told("{\"unit\":\"parsec\"}"),
      "CONTOURS_FILE 1 no contours: its unit is 'parsec', and mm, cm, m, in, ft, pt, pc, px and "
      "um are known");
  EXPECT_EQ(told(begin + "{\"points\":[[1,1e999]]}]}]}").substr(0, 15), "CONTOURS_FILE 2");
  EXPECT_EQ(told("").substr(0, 15), "CONTOURS_FILE 1");
}

TEST(Contours, what_is_whole_in_front_of_a_fault_is_drawn) {
  const Drawn drawn = read(R"({"layers":[{"name":"A","contours":[{"points":[[0,0],[2,0]]},{"poi)");
  EXPECT_EQ(drawn.codes(), "CONTOURS_FILE");
  EXPECT_EQ(drawn.drawing.paths.size(), 1U);
}

TEST(Contours, brackets_without_end_are_no_trouble) {
  EXPECT_EQ(read("{\"a\":" + std::string(1'000'000, '[')).codes(), "CONTOURS_FILE");
}

}  // namespace
}  // namespace kerf::drawing
