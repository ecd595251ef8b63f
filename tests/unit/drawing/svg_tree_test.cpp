#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "svg_sheet.hpp"

namespace kerf::drawing {
namespace {

constexpr double kPi = std::numbers::pi;

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
