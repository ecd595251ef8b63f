#include "output/picture/drawing/ruler.hpp"

#include <gtest/gtest.h>

#include "output/picture/drawing/text.hpp"

namespace kerf::output::plot {
namespace {

std::string labels(const std::vector<Tick>& ticks) {
  std::string text;
  for (const Tick& tick : ticks) {
    if (tick.major) text += tick.label + ' ';
  }
  return text;
}

TEST(Ruler, LabelsRoundValues) {
  EXPECT_EQ(labels(ruler(-3, 103, 15)), "0 20 40 60 80 100 ");
  EXPECT_EQ(labels(ruler(0, 1, 0.21)), "0 0.5 1 ");
  EXPECT_EQ(labels(ruler(-0.3, 0.3, 0.1)), "-0.3 -0.2 -0.1 0 0.1 0.2 0.3 ");
  EXPECT_EQ(labels(ruler(-1e6, 1e6, 4e5)), "-1000000 -500000 0 500000 1000000 ");
  EXPECT_EQ(labels(ruler(7.0001, 7.0003, 1e-4)), "7.0001 7.0002 7.0003 ");
}

TEST(Ruler, PutsMinorMarksBetweenTheLabels) {
  const auto ticks = ruler(0, 10, 10);
  ASSERT_EQ(ticks.size(), 6U);
  EXPECT_DOUBLE_EQ(ticks[1].value, 2);
  EXPECT_FALSE(ticks[1].major);
  EXPECT_TRUE(ticks[1].label.empty());
}

TEST(Ruler, IsRoundInWhatItShows) {
  const auto ticks = ruler(0, 20, 10, 2);  // radii shown as diameters
  EXPECT_EQ(labels(ticks), "0 20 40 ");
  EXPECT_DOUBLE_EQ(ticks.back().value, 20);
}

TEST(Ruler, HasBoundedNumbersOfMarks) {
  for (double size = 1e-6; size < 1e10; size *= 7) {
    EXPECT_LE(ruler(-size, size, size / 8).size(), 100U);
  }
}

TEST(Text, SignificantShowsTwoDigits) {
  EXPECT_EQ(significant(0.012195), "0.012");
  EXPECT_EQ(significant(0.5), "0.5");
  EXPECT_EQ(significant(12.46), "12.5");
}

TEST(Text, GroupsLongCounts) {
  EXPECT_EQ(grouped(7), "7");
  EXPECT_EQ(grouped(1234), "1 234");
  EXPECT_EQ(grouped(1000003), "1 000 003");
}

TEST(Text, ReplacesWhatCannotBePrinted) {
  EXPECT_EQ(printable("O0001 (\xE5\xAD\x94)"), "O0001 (\xE5\xAD\x94)");
  EXPECT_EQ(printable("a\tb\x7F"), "a?b?");
  EXPECT_EQ(printable("\xC0\xAF"), "??");            // overlong
  EXPECT_EQ(printable("\xED\xA0\x80"), "???");       // half of a pair
  EXPECT_EQ(printable("\xE5\xAD"), "??");            // cut off
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), "????");  // beyond Unicode
  EXPECT_EQ(printable("\xC2\x85"), "?");             // a control character of two bytes
  EXPECT_EQ(printable(""), "");
}

TEST(Text, ShortensToTheWidthGiven) {
  const std::string title(200, 'x');
  const std::string fit = fitted(title, 24, Weight::bold, 500);
  EXPECT_LE(text_width(fit, 24, Weight::bold), 500);
  EXPECT_TRUE(fit.ends_with("\u2026"));
  EXPECT_EQ(fitted("short", 24, Weight::bold, 500), "short");
  const std::string wide = fitted("\u5B54\u5B54\u5B54\u5B54", 20, Weight::regular, 60);
  EXPECT_EQ(wide, "\u5B54\u5B54\u2026");
}

}  // namespace
}  // namespace kerf::output::plot
