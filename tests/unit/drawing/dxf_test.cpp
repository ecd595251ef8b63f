#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "drawing/dxf/dxf_reader.hpp"
#include "drawn.hpp"

namespace kerf::drawing {
namespace {

constexpr double kPi = std::numbers::pi;

/// "LINE 10 1 20 2" as lines of groups: words in turn a code and its value, the first one a kind.
std::string entity(const std::string& words) {
  std::string text = "  0\n";
  bool is_code = false;
  std::size_t begin = 0;
  while (begin < words.size()) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    text += (is_code ? " " : "") + words.substr(begin, end - begin) + "\n";
    is_code = !is_code;
    begin = end + 1;
  }
  return text;
}

std::string section(const std::string& name, const std::string& content) {
  return "  0\nSECTION\n  2\n" + name + "\n" + content + "  0\nENDSEC\n";
}

const std::string kMm = section("HEADER", "  9\n$ACADVER\n  1\nAC1015\n  9\n$INSUNITS\n 70\n 4\n");
const std::string kEnd = "  0\nEOF\n";

std::string entities(std::initializer_list<const char*> list) {
  std::string content;
  for (const char* words : list) content += entity(words);
  return section("ENTITIES", content);
}

Drawn read(const std::string& text, Reading how = {}) { return Drawn(read_dxf, text, how); }
Drawn read_entities(std::initializer_list<const char*> list, Reading how = {}) {
  return read(kMm + entities(list) + kEnd, how);
}

TEST(Dxf, a_file_that_is_cut_off_says_inside_what_and_draws_what_is_whole) {
  const Drawn drawn =
      read(kMm + "  0\nSECTION\n  2\nENTITIES\n" + entity("LINE 8 CUT 10 0 20 0 11 5 21 0") +
           entity("LWPOLYLINE 5 3F 8 CUT 10 0 20 0 10 9"));
  EXPECT_EQ(drawn.findings(),
            "DXF_TRUNCATED:42 the drawing is cut off: the file ends inside LWPOLYLINE 3F on layer "
            "CUT: the end of section ENTITIES is missing\n");
  ASSERT_EQ(drawn.drawing.paths.size(), 1U);
  EXPECT_DOUBLE_EQ(length(drawn.path(0)), 5);
}

TEST(Dxf, a_missing_end_is_told_where_everything_was_drawn) {
  EXPECT_EQ(
      read(kMm + entities({"LINE 11 1"})).findings(),
      "DXF_TRUNCATED:24 the drawing is cut off: the file ends behind section ENTITIES: EOF is "
      "missing\n");
  EXPECT_EQ(read(kMm + "  0\nSECTION\n  2\nENTITIES\n" + entity("LINE 11 1") + kEnd).codes(),
            "DXF_TRUNCATED");
  EXPECT_EQ(read("").codes(), "DXF_TRUNCATED");
}

TEST(Dxf, a_polyline_that_is_cut_off_is_not_drawn) {
  const Drawn drawn = read(kMm + "  0\nSECTION\n  2\nENTITIES\n" + entity("POLYLINE 66 1") +
                           entity("VERTEX 10 1") + entity("VERTEX 10 2"));
  EXPECT_EQ(drawn.codes(), "DXF_TRUNCATED");
  EXPECT_TRUE(drawn.drawing.paths.empty());
}

TEST(Dxf, a_group_that_is_none_is_told_with_its_line_and_the_next_entity_is_read) {
  const Drawn drawn = read(kMm + "  0\nSECTION\n  2\nENTITIES\n" +
                           "  0\nLINE\n  8\nCUT\n 10\n1,5\n" + "  0\nLINE\n 10\n1\n20x\n2\n" +
                           entity("LINE 8 CUT 10 0 20 0 11 7 21 0") + "  0\nENDSEC\n" + kEnd);
  EXPECT_EQ(drawn.findings(),
            "DXF_GROUP:24 no dxf group: LINE on layer CUT is not drawn: '1,5' of group 10 is no "
            "number\n"
            "DXF_GROUP:29 no dxf group: LINE is not drawn: '20x' is no group code\n");
  ASSERT_EQ(drawn.drawing.paths.size(), 1U);
  EXPECT_DOUBLE_EQ(length(drawn.path(0)), 7);
}

TEST(Dxf, what_no_drawing_takes_harm_of_is_not_told) {
  const std::string objects = section("OBJECTS", "  0\nXRECORD\n 40\nabc\n");
  EXPECT_EQ(read(kMm + entities({"LINE 11 1"}) + objects + kEnd).codes(), "");
  EXPECT_EQ(read(kMm + entities({"LINE 11 1 1040 abc 102 {X 40 abc 102 }"}) + kEnd).codes(), "");
}

TEST(Dxf, numbers_that_are_none_and_such_beyond_all_machines_are_told) {
  EXPECT_EQ(read_entities({"LINE 10 nan"}).codes(), "DRAW_NAN");
  EXPECT_EQ(read_entities({"CIRCLE 40 1e999"}).codes(), "DRAW_NAN");
  EXPECT_EQ(read_entities({"CIRCLE 40 -1.#IND"}).codes(), "DRAW_NAN");
  EXPECT_EQ(read_entities({"LINE 10 1000001"}).codes(), "DRAW_RANGE");
  EXPECT_EQ(read_entities({"ELLIPSE 11 1e300 21 0 40 0.5"}).codes(), "DRAW_RANGE");
  EXPECT_EQ(read_entities({"SPLINE 71 3 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 10 0 20 0 10 1e200 "
                           "20 1e250 10 3 20 1 10 4 20 0"})
                .codes(),
            "DRAW_RANGE");
}

TEST(Dxf, other_formats_are_told) {
  EXPECT_EQ(read("AutoCAD Binary DXF\r\n\x1a").codes(), "DXF_BINARY");
  EXPECT_EQ(read("AC1027 and bytes").codes(), "DXF_DWG");
}

std::string unit_told(const std::string& header, Reading how = {}) {
  const Drawn drawn = read(section("HEADER", header) + entities({"LINE 11 1"}) + kEnd, how);
  return drawn.facts().unit + " " + drawn.facts().unit_from + " " + drawn.codes();
}

TEST(Dxf, a_unit_is_what_the_file_says_or_told_as_assumed) {
  const std::string units = "  9\n$INSUNITS\n 70\n";
  const std::string metric = "  9\n$MEASUREMENT\n 70\n";
  const std::string release_12 = "  9\n$ACADVER\n  1\nAC1009\n";
  EXPECT_EQ(unit_told(units + "5\n"), "cm $INSUNITS ");
  EXPECT_EQ(unit_told(units + "14\n"), "dm $INSUNITS ");
  EXPECT_EQ(unit_told(units + "0\n" + metric + "0\n"), "in $MEASUREMENT DRAW_UNIT");
  EXPECT_EQ(unit_told(metric + "1\n"), "mm $MEASUREMENT DRAW_UNIT");
  EXPECT_EQ(unit_told(units + "0\n"), "mm assumed DRAW_UNIT");
  EXPECT_EQ(unit_told(units + "99\n"), "mm assumed DRAW_UNIT");
  EXPECT_EQ(unit_told(release_12 + metric + "0\n"), "mm assumed DRAW_UNIT");
  Reading feet;
  feet.unit = "ft";
  EXPECT_EQ(unit_told(units + "5\n", feet), "ft --unit ");
  EXPECT_DOUBLE_EQ(length(read_entities({"LINE 11 1"}, feet).path(0)), 304.8);
}

std::string block(const std::string& name, std::initializer_list<const char*> list) {
  std::string text = entity("BLOCK 2 " + name);
  for (const char* words : list) text += entity(words);
  return text + entity("ENDBLK");
}

TEST(Dxf, nested_rows_and_columns_end_by_the_budget_before_they_are_made) {
  std::string blocks = block("B0", {"LINE 11 1"});
  for (int i = 1; i < 32; ++i)
    blocks += entity("BLOCK 2 B" + std::to_string(i)) +
              entity("INSERT 2 B" + std::to_string(i - 1) + " 70 1000 71 1000") + entity("ENDBLK");
  const auto begin = std::chrono::steady_clock::now();
  const Drawn drawn = read(kMm + section("BLOCKS", blocks) + entities({"INSERT 2 B31"}) + kEnd);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(drawn.codes(), "DRAW_LIMIT");
  EXPECT_TRUE(drawn.drawing.entities.empty());
  EXPECT_LT(passed.count(), 1);
}

TEST(Dxf, blocks_behind_entities_are_told_and_not_expanded_by_them) {
  const std::string blocks = section("BLOCKS", block("A", {"INSERT 2 NONE 70 1000 71 1000"}));
  const std::string insert = entities({"INSERT 2 A 70 1000 71 1000"});
  const Drawn drawn = read(kMm + entities({"LINE 11 1"}) + blocks + insert + kEnd);
  EXPECT_EQ(drawn.codes(), "DXF_BLOCK");
  EXPECT_EQ(drawn.ignored(), "BLOCKS 1");
}

TEST(Dxf, what_is_looked_at_and_not_drawn_is_of_the_budget_too) {
  Reading reading;
  reading.max_entities = 1000;
  const std::string blocks = section("BLOCKS", block("A", {"XLINE 10 1"}));
  const std::string insert =
      entities({"INSERT 2 A 70 300", "INSERT 2 A 70 600", "INSERT 2 A 70 101"});
  EXPECT_EQ(read(kMm + blocks + insert + kEnd, reading).codes(), "DRAW_LIMIT");
}

TEST(Dxf, empty_rows_and_columns_are_nothing) {
  const std::string blocks = block("EMPTY", {}) + block("A", {"INSERT 2 EMPTY 70 30000 71 30000"});
  const Drawn drawn =
      read(kMm + section("BLOCKS", blocks) + entities({"INSERT 2 A 70 1000 71 1000"}) + kEnd);
  EXPECT_EQ(drawn.codes(), "");
  EXPECT_TRUE(drawn.drawing.paths.empty());
}

TEST(Dxf, a_block_that_holds_itself_is_told_and_the_rest_of_it_drawn) {
  const std::string blocks =
      block("A", {"LINE 11 1", "INSERT 2 B"}) + block("B", {"LINE 11 2", "INSERT 2 a"});
  const Drawn drawn = read(kMm + section("BLOCKS", blocks) + entities({"INSERT 2 A"}) + kEnd);
  EXPECT_EQ(drawn.codes(), "DXF_BLOCK");
  EXPECT_EQ(drawn.drawing.paths.size(), 2U);
}

TEST(Dxf, blocks_are_followed_32_deep) {
  std::string blocks = block("B0", {"LINE 11 1"});
  for (int i = 1; i < 40; ++i)
    blocks += entity("BLOCK 2 B" + std::to_string(i)) +
              entity("INSERT 2 B" + std::to_string(i - 1)) + entity("ENDBLK");
  const std::string begin = kMm + section("BLOCKS", blocks);
  EXPECT_EQ(read(begin + entities({"INSERT 2 B31"}) + kEnd).drawing.paths.size(), 1U);
  EXPECT_EQ(read(begin + entities({"INSERT 2 B32"}) + kEnd).codes(), "DXF_BLOCK");
}

TEST(Dxf, a_chain_of_blocks_of_any_length_is_weighed) {
  std::string blocks;
  for (int i = 0; i < 20000; ++i)
    blocks += entity("BLOCK 2 B" + std::to_string(i)) +
              entity("INSERT 2 B" + std::to_string(i + 1)) + entity("ENDBLK");
  EXPECT_EQ(read(kMm + section("BLOCKS", blocks) + entities({"INSERT 2 B0"}) + kEnd).codes(),
            "DXF_BLOCK");
}

TEST(Dxf, the_budget_counts_lines_and_arcs_too) {
  Reading reading;
  reading.max_entities = 10;
  std::string many = "LWPOLYLINE";
  for (int i = 0; i < 200; ++i) many += " 10 " + std::to_string(i) + " 20 " + std::to_string(i % 2);
  const Drawn drawn = read(
      kMm + section("ENTITIES", entity(many) + entity("LINE 11 1") + entity("LINE 11 1")) + kEnd,
      reading);
  EXPECT_EQ(drawn.codes(), "DRAW_LIMIT");
}

TEST(Dxf, hidden_layers_are_drawn_where_they_are_named) {
  const std::string layers =
      section("TABLES", entity("LAYER 2 OFF 62 -1 70 0") + entity("LAYER 2 Ice 62 3 70 1"));
  const std::string lines = entities({"LINE 8 off 11 1", "LINE 8 ICE 11 2", "LINE 8 CUT 11 3"});
  EXPECT_EQ(read(kMm + layers + lines + kEnd).ignored(), "layer OFF 1, layer Ice 1");
  Reading reading;
  reading.layers = {"O*", "Ic?"};
  const Drawn drawn = read(kMm + layers + lines + kEnd, reading);
  ASSERT_EQ(drawn.drawing.paths.size(), 2U);
  EXPECT_EQ(drawn.layer_of(0), "OFF");
  EXPECT_EQ(text_of(drawn.entity_of(1).colour), "#00ff00");
  EXPECT_EQ(drawn.ignored(), "");
}

TEST(Dxf, what_is_not_shown_is_counted_with_the_first_line) {
  const Drawn drawn = read_entities({"LINE 67 1 11 1", "LINE 60 1 11 1", "DIMENSION 8 A",
                                     "DIMENSION 8 A", "SPROCKET 8 A", "ATTRIB 70 1 40 2 1 x"});
  EXPECT_EQ(drawn.ignored(), "paper space 1, invisible 2, DIMENSION 2, SPROCKET 1");
  EXPECT_EQ(drawn.facts().ignored[2].line, 31U);
  EXPECT_TRUE(drawn.drawing.entities.empty());
}

std::string layer_read(const std::string& header, const std::string& name) {
  const Drawn drawn = read(section("HEADER", header + "  9\n$INSUNITS\n 70\n4\n") +
                           "  0\nSECTION\n  2\nENTITIES\n  0\nLINE\n  8\n" + name +
                           "\n 11\n1\n  0\nENDSEC\n" + kEnd);
  return std::string(drawn.layer_of(0));
}

TEST(Dxf, names_are_read_by_their_code_page) {
  const auto page = [](const std::string& name) {
    return "  9\n$ACADVER\n  1\nAC1015\n  9\n$DWGCODEPAGE\n  3\n" + name + "\n";
  };
  EXPECT_EQ(layer_read(page("ANSI_1252"), "Gr\xFCn"), "Grün");
  EXPECT_EQ(layer_read(page("ansi_936"), "\xC7\xD0\xB8\xEE"), "切割");
  EXPECT_EQ(layer_read(page("ANSI_950"), "\xA4\xC1\xB3\xCE"), "切割");
  EXPECT_EQ(layer_read(page("ANSI_932"), "\x83\x5C\x90\xD8"), "ソ切");  // a backslash inside
  EXPECT_EQ(layer_read(page("ANSI_1251"), "\xD0\xE5\xE7"), "Рез");
  EXPECT_EQ(layer_read(page("ANSI_1252"), "\\U+5207\\U+5272"), "切割");
  EXPECT_EQ(layer_read(page("ANSI_1252"), "\\U+D83D\\U+DE00\\U+D83D"), "😀\uFFFD");
  EXPECT_EQ(layer_read("  9\n$ACADVER\n  1\nAC1021\n", "切割\xFF"), "切割\uFFFD");
  EXPECT_EQ(layer_read("", "切割"), "切割");
  EXPECT_EQ(layer_read("", "Gr\xFCn"), "Grün");
}

TEST(Dxf, two_bytes_of_a_code_page_are_one_letter_and_not_a_capital_one) {
  const std::string header = section(
      "HEADER",
      "  9\n$ACADVER\n  1\nAC1015\n  9\n$DWGCODEPAGE\n  3\nANSI_936\n  9\n$INSUNITS\n 70\n4\n");
  const std::string blocks = block("\x81\x41", {"LINE 11 1"}) + block("\x81\x61", {"LINE 11 2"});
  const Drawn drawn =
      read(header + section("BLOCKS", blocks) + entities({"INSERT 2 \x81\x61"}) + kEnd);
  EXPECT_EQ(drawn.codes(), "");
  EXPECT_DOUBLE_EQ(length(drawn.path(0)), 2);
}

TEST(Dxf, lines_may_end_in_both_ways_and_have_blanks_and_comments) {
  const std::string text =
      "999\r\nmade by hand\r\n0\r\nSECTION\r\n2\r\nENTITIES\r\n   0  \r\nLINE  "
      "\r\n999\r\nx\r\n\t11\r\n  4  \r\n0\r\nENDSEC\r\n0\r\nEOF\r\n";
  const Drawn drawn = read("\xEF\xBB\xBF" + text);
  EXPECT_EQ(drawn.codes(), "DRAW_UNIT");
  EXPECT_DOUBLE_EQ(length(drawn.path(0)), 4);
  EXPECT_EQ(drawn.entity_of(0).line, 7U);
}

TEST(Dxf, a_spline_through_points_of_a_closed_curve_is_closed_and_smooth) {
  std::string spline = "SPLINE 8 CUT 70 1 71 3";
  for (int i = 0; i < 36; ++i) {
    const double angle = i * kPi / 18;
    spline += " 11 " + std::to_string(10 * std::cos(angle)) + " 21 " +
              std::to_string(10 * std::sin(angle));
  }
  const Drawn drawn = read(kMm + section("ENTITIES", entity(spline)) + kEnd);
  ASSERT_TRUE(drawn.drawing.paths.at(0).is_closed);
  EXPECT_NEAR(length(drawn.path(0)), 20 * kPi, 1e-3);
  EXPECT_NEAR(area(drawn.path(0)), 100 * kPi, 1e-2);
}

TEST(Dxf, a_spline_through_points_begins_in_the_direction_that_is_given) {
  const Drawn drawn = read_entities({"SPLINE 11 0 21 0 11 10 21 0 12 0 22 5 13 0 23 -2"});
  EXPECT_EQ(drawn.codes(), "");
  const contour::Contour path = drawn.path(0);
  const Vec2 begin = tangent_at_start(edge_of(path, 0));
  EXPECT_NEAR(begin.u / begin.v, 0, 1e-9);
  EXPECT_NEAR(extents(path).high.v, 2.5, 0.01);  // cubic with slopes 1 and -1: 10 t (1 - t)
}

TEST(Dxf, splines_that_are_none_are_told) {
  EXPECT_EQ(read_entities({"SPLINE 71 3 40 0 40 1 10 0 20 0 10 1 20 1"}).codes(), "DXF_GROUP");
  EXPECT_EQ(read_entities({"SPLINE 71 1 40 0 40 0 40 1 10 0 20 0 10 1 20 1"}).codes(), "DXF_GROUP");
  EXPECT_EQ(
      read_entities({"SPLINE 71 1 40 0 40 0 40 1 40 1 41 1 41 -1 10 0 20 0 10 1 20 1"}).codes(),
      "DXF_GROUP");
  EXPECT_EQ(read_entities({"SPLINE 71 40"}).codes(), "DXF_GROUP");
  EXPECT_EQ(read_entities({"SPLINE 71 1 40 0 40 0 40 1 40 1 10 0 20 0 10 1 20 1"}).codes(), "");
}

TEST(Dxf, a_hatch_is_its_boundary_without_pattern_and_seeds) {
  const Drawn drawn =
      read_entities({"HATCH 10 0 20 0 2 ANSI31 91 1 92 2 72 0 73 1 93 3 10 0 20 0 10 6 20 0 10 0 "
                     "20 8 97 0 75 0 76 "
                     "1 52 45 98 1 10 99 20 99"});
  ASSERT_EQ(drawn.drawing.paths.size(), 1U);
  EXPECT_DOUBLE_EQ(area(drawn.path(0)), 24);
}

TEST(Dxf, edges_of_a_hatch_that_do_not_meet_are_paths_of_their_own) {
  const Drawn drawn = read_entities(
      {"HATCH 91 1 92 1 93 2 72 1 10 0 20 0 11 5 21 0 72 1 10 9 20 0 11 9 21 5 97 0 75 0"});
  EXPECT_EQ(drawn.drawing.paths.size(), 2U);
  EXPECT_EQ(drawn.facts().entities.at("HATCH"), 1U);
}

TEST(Dxf, whole_turns_are_whole_whatever_the_last_digits_say) {
  const Drawn drawn = read_entities({"ARC 40 2 50 90 51 450", "ARC 40 2 50 0 51 359.99999999",
                                     "ELLIPSE 11 2 21 0 40 1 41 0 42 "
                                     "6.283185",
                                     "ARC 40 2 50 0 51 359", "CIRCLE 40 2"});
  for (const std::size_t i : {0U, 1U, 2U, 4U}) {
    EXPECT_TRUE(drawn.drawing.paths.at(i).is_closed) << i;
    EXPECT_NEAR(length(drawn.path(i)), 4 * kPi, 1e-6) << i;
  }
  EXPECT_FALSE(drawn.drawing.paths.at(3).is_closed);
}

TEST(Dxf, entities_without_what_they_need_are_told) {
  EXPECT_EQ(read_entities({"CIRCLE 8 A 10 1"}).findings(),
            "DXF_GROUP:19 no dxf group: CIRCLE on layer A has no radius (group 40)\n");
  EXPECT_EQ(read_entities({"LWPOLYLINE 90 0", "HATCH 91 0", "TEXT 1 x", "POLYLINE 66 1", "SEQEND"})
                .codes(),
            "DXF_GROUP DXF_GROUP DXF_GROUP DXF_GROUP");
}

TEST(Dxf, colours_of_the_index_are_those_of_the_table) {
  const Drawn drawn = read_entities({"LINE 62 1 11 1", "LINE 62 11 11 1", "LINE 62 12 11 1",
                                     "LINE 62 42 11 1", "LINE 62 94 11 1", "LINE 62 248 11 1",
                                     "LINE 62 250 11 1", "LINE 62 1 420 1193046 11 1"});
  const char* const wanted[] = {"#ff0000", "#ff7f7f", "#a50000", "#a57c00",
                                "#007f00", "#260009", "#333333", "#123456"};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(text_of(drawn.entity_of(i).colour), wanted[i]) << i;
}

TEST(Dxf, a_face_is_its_visible_edges) {
  const Drawn drawn = read_entities({"3DFACE 10 0 20 0 11 6 21 0 12 6 22 8 13 0 23 8 70 5",
                                     "3DFACE 10 0 20 0 11 6 21 0 12 6 22 8"});
  ASSERT_EQ(drawn.drawing.paths.size(), 3U);
  EXPECT_DOUBLE_EQ(length(drawn.path(0)), 8);
  EXPECT_DOUBLE_EQ(length(drawn.path(1)), 8);
  EXPECT_DOUBLE_EQ(length(drawn.path(2)), 24);
}

}  // namespace
}  // namespace kerf::drawing
