#include <gtest/gtest.h>

#include "svg_sheet.hpp"

namespace kerf::drawing {
namespace {

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

TEST(Svg, dashes_are_lengths_on_the_machine) {
  const Svg svg(page(
      "<g stroke='red' stroke-dasharray='4, 2 1'><path d='M0 0h9' transform='scale(2)'/>"
      "<path stroke-dasharray='none' d='M0 0h9'/></g><path stroke-dasharray='1 -1' d='M0 0h9'/>"));
  EXPECT_EQ(svg.drawing.names[svg.drawing.entities[0].dashes], "8 4 2 8 4 2");
  EXPECT_EQ(svg.drawing.names[svg.drawing.entities[1].dashes], "");
  EXPECT_EQ(svg.drawing.names[svg.drawing.entities[2].dashes], "");
}

TEST(Svg, fill_rule_is_the_contours_own) {
  const Svg svg(page("<g fill-rule='evenodd'><path d='M0 0h1'/></g><path d='M0 0h1'/>"));
  EXPECT_EQ(svg.drawing.entities[0].rule, FillRule::even_odd);
  EXPECT_EQ(svg.drawing.entities[1].rule, FillRule::non_zero);
}

}  // namespace
}  // namespace kerf::drawing
