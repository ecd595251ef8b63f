#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drawing/font/layout.hpp"

namespace kerf::drawing {
namespace {

/// Words drawn with a font.
struct Page {
  Reading reading;
  Drawing drawing;

  Page(const Text& wish, Font& font, const Lettering& lettering = {}) {
    Canvas canvas(reading, drawing);
    canvas.begin_file({}, "test");
    Text text = wish;
    text.entity = canvas.add(Entity{});
    draw_text(text, font, lettering, canvas);
  }
  [[nodiscard]] contour::Box extents() const {
    contour::Box box;
    for (const Path& path : drawing.paths) box.take(contour::extents(contour_of(drawing, path)));
    return box;
  }
};

Text words(const std::string& said, double height = 6) {
  Text text;
  text.words = said;
  text.height = height;
  return text;
}

void expect_box(const contour::Box& box, Vec2 low, Vec2 high) {
  EXPECT_NEAR(box.low.u, low.u, 1e-6);
  EXPECT_NEAR(box.low.v, low.v, 1e-6);
  EXPECT_NEAR(box.high.u, high.u, 1e-6);
  EXPECT_NEAR(box.high.v, high.v, 1e-6);
}

TEST(LineFont, has_all_that_it_promises) {
  const auto font = line_font();
  for (char32_t code = 32; code < 127; ++code)
    EXPECT_NE(font->find(code), nullptr) << static_cast<unsigned>(code);
  for (char32_t code = 0xC0; code <= 0xFF; ++code)
    EXPECT_NE(font->find(code), nullptr) << static_cast<unsigned>(code);
  for (char32_t code = 0x391; code <= 0x3A9; ++code)
    EXPECT_EQ(font->find(code) != nullptr, code != 0x3A2) << static_cast<unsigned>(code);
  for (const char32_t code : {U'°', U'±', U'Ø', U'×', U'µ', U'⌀'})
    EXPECT_NE(font->find(code), nullptr) << static_cast<unsigned>(code);
  EXPECT_EQ(font->find(U'漢'), nullptr);
}

TEST(LineFont, capitals_are_exactly_as_high_as_asked_and_stand_on_the_base_line) {
  const auto font = line_font();
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    const contour::Box box = Page(words({letter}, 5), *font).extents();
    EXPECT_NEAR(box.low.v, 0, 1e-9) << letter;
    EXPECT_NEAR(box.high.v, 5, 1e-9) << letter;
    EXPECT_NEAR(box.low.u, 0, 1e-6) << letter;
  }
}

TEST(LineFont, strokes_stay_lines_and_arcs) {
  // O, 4 wide and 6 high: two straight sides of 2, two halves of radius 2
  const Page page(words("O"), *line_font());
  ASSERT_EQ(page.drawing.paths.size(), 1U);
  const contour::Contour round = contour_of(page.drawing, page.drawing.paths[0]);
  EXPECT_EQ(round.vertices.size(), 4U);
  EXPECT_TRUE(round.is_closed);
  EXPECT_NEAR(contour::length(round), 4 + 4 * std::numbers::pi, 1e-9);
  EXPECT_EQ(page.drawing.error_mm, 0);
}

TEST(Layout, letters_follow_by_their_width_and_a_gap) {
  const auto font = line_font();
  // H is 4 wide, the gap 1.6: H H ends at 4 + 1.6 + 4
  expect_box(Page(words("HH"), *font).extents(), {0, 0}, {9.6, 6});
  EXPECT_NEAR(6 * width_of("HH", *font, {}), 9.6, 1e-9);
  Lettering wide;
  wide.spacing = 2;
  expect_box(Page(words("HH"), *font, wide).extents(), {0, 0}, {15.2, 6});
}

TEST(Layout, words_align_across_and_upright) {
  const auto font = line_font();
  Text text = words("HH");
  text.across = Across::centre;
  text.upright = Upright::middle;
  expect_box(Page(text, *font).extents(), {-4.8, -3}, {4.8, 3});
  text.across = Across::right;
  text.upright = Upright::top;
  expect_box(Page(text, *font).extents(), {-9.6, -6}, {0, 0});
  text.upright = Upright::bottom;  // letters go 2 below the base line
  expect_box(Page(text, *font).extents(), {-9.6, 2}, {0, 8});
}

TEST(Layout, words_fill_a_width_by_their_size_or_by_stretching) {
  const auto font = line_font();
  Text text = words("HH");
  text.width = 19.2;
  text.across = Across::aligned;
  expect_box(Page(text, *font).extents(), {0, 0}, {19.2, 12});
  text.across = Across::fit;
  expect_box(Page(text, *font).extents(), {0, 0}, {19.2, 6});
  text.across = Across::left;
  text.stretch = 0.5;
  expect_box(Page(text, *font).extents(), {0, 0}, {4.8, 6});
}

TEST(Layout, lines_stand_below_each_other_each_aligned_for_itself) {
  const auto font = line_font();
  Text text = words("H\nHH");
  text.across = Across::right;
  const Page page(text, *font);
  expect_box(page.extents(), {-9.6, -10}, {0, 6});  // 5/3 of 6 below
  const contour::Box first = contour::extents(contour_of(page.drawing, page.drawing.paths[0]));
  EXPECT_NEAR(first.low.u, -4, 1e-9);
  text.upright = Upright::middle;  // 16 high in all
  expect_box(Page(text, *font).extents(), {-9.6, -8}, {0, 8});
}

TEST(Layout, words_are_turned_and_moved) {
  Text text = words("H");
  text.to_mm = then(Affine::turned(0.5 * std::numbers::pi), Affine::moved({10, 20}));
  expect_box(Page(text, *line_font()).extents(), {4, 20}, {10, 24});
}

TEST(Layout, a_letter_that_is_missing_is_a_box_and_is_told) {
  const auto font = line_font();
  const Page page(words("H漢\xff"), *font);
  expect_box(page.extents(), {0, 0}, {15.2, 6});
  EXPECT_EQ(page.drawing.paths.size(), 5U);
  ASSERT_EQ(page.drawing.findings.size(), 2U);
  EXPECT_EQ(page.drawing.findings[0].diagnostic.number, "TEXT_GLYPH");
  EXPECT_NE(page.drawing.findings[0].diagnostic.message.find("U+6F22"), std::string::npos);
  EXPECT_NE(page.drawing.findings[1].diagnostic.message.find("U+FFFD"), std::string::npos);
}

/// A record of a .jhf: its number, how many pairs, the pairs.
std::string record(const std::string& pairs) {
  std::string count = std::to_string(pairs.size() / 2);
  count.insert(0, 3 - count.size(), ' ');
  return "12345" + count + pairs + "\n";
}

/// A blank, then letters up to H, which goes from (-5, 9) to (5, -12): 21 high, as Hershey's.
std::string hershey() {
  std::string text = record("JZ");
  for (char letter = '!'; letter < 'H'; ++letter) text += record("I[RFR[");
  return text + record("MWMFM[ RWFW[ RMPWP");
}

TEST(Hershey, letters_are_read_and_as_high_as_asked) {
  const auto font = font_of_bytes(hershey(), "x.jhf");
  ASSERT_TRUE(font);
  const Page page(words("H", 21), **font);
  EXPECT_EQ(page.drawing.paths.size(), 3U);
  expect_box(page.extents(), {0, 0}, {10, 21});
  // '!' is 18 wide with its stroke in the middle; a blank 16
  expect_box(Page(words("!", 21), **font).extents(), {9, 0}, {9, 21});
  expect_box(Page(words(" H", 21), **font).extents(), {16, 0}, {26, 21});
}

TEST(Hershey, records_go_on_over_ends_of_lines) {
  std::string text = hershey();
  text.insert(text.size() - 5, "\r\n");
  const auto font = font_of_bytes(text, "x.JHF");
  ASSERT_TRUE(font);
  EXPECT_EQ(Page(words("H", 21), **font).drawing.paths.size(), 3U);
}

TEST(Hershey, what_is_none_is_told_with_its_line) {
  const auto font = font_of_bytes(record("JZ") + "12345 99RR", "a.jhf");
  ASSERT_FALSE(font);
  EXPECT_EQ(font.error().message.find("a.jhf:2:"), 0U);
  EXPECT_FALSE(font_of_bytes("", "a.jhf"));
  EXPECT_FALSE(font_of_bytes("12345  0", "a.jhf"));
}

TEST(OutlineFont, what_is_none_is_told) {
  for (const std::string& text : {std::string(), std::string("OTTO"), std::string(4000, 'x')}) {
    const auto font = font_of_bytes(text, "a.ttf");
    ASSERT_FALSE(font);
    EXPECT_EQ(font.error().message.find("a.ttf: "), 0U);
  }
  EXPECT_FALSE(open_font("/nowhere/at/all.ttf"));
}

TEST(OutlineFont, letters_are_closed_contours_as_high_as_asked) {
  const auto font = open_font("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf");
  if (!font) GTEST_SKIP() << "fonts-dejavu-core is not there";
  const Page h(words("H", 10), **font);
  ASSERT_EQ(h.drawing.paths.size(), 1U);
  EXPECT_TRUE(h.drawing.paths[0].is_closed);
  EXPECT_NEAR(h.extents().high.v, 10, 1e-9);
  EXPECT_NEAR(h.extents().low.v, 0, 1e-9);
  // O is two contours, one inside the other, the other way round
  const Page o(words("O", 10), **font);
  ASSERT_EQ(o.drawing.paths.size(), 2U);
  const double outer = contour::area(contour_of(o.drawing, o.drawing.paths[0]));
  const double inner = contour::area(contour_of(o.drawing, o.drawing.paths[1]));
  EXPECT_LT(outer * inner, 0);
  EXPECT_LE(o.drawing.error_mm, 0.01);
}

}  // namespace
}  // namespace kerf::drawing
