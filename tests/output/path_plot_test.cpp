#include "output/picture/path_plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plot_motions.hpp"

namespace kerf::output {
namespace {

using namespace testing;

// A finished picture: no number in it is anything but a number.
void expect_sound(const PathPlot& plot) {
  const std::string svg = plot.svg();
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_TRUE(plot.png().starts_with("\x89PNG\r\n"));
}

// Rows of lines of 0.1 mm over a wavy surface.
void mill_surface(PathPlot& plot, int rows, int columns) {
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < columns; ++i) {
      const double x = 0.1 * (row % 2 == 0 ? i : columns - 1 - i), y = 0.1 * row;
      plot.take(line(x, y, 3 * std::sin(x / 7) * std::cos(y / 9)));
    }
  }
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(PathPlot, AMillionMovesGiveAPictureOfBoundedSize) {
  PathPlot plot(axes("XYZ"), "surface");
  mill_surface(plot, 1000, 1000);
  EXPECT_LT(plot.svg().size(), 2'000'000U);
  EXPECT_LT(plot.png().size(), 2'000'000U);
}

TEST(PathPlot, ATangleGivesAPictureOfBoundedSize) {
  PathPlot plot(axes("XYZ"), "tangle");
  Random random(1);
  for (int i = 0; i < 49'000; ++i) {
    const double x = 200 * random.next(), y = 200 * random.next();
    plot.take(line(x, y, 10 * random.next()));
  }
  EXPECT_LT(plot.svg().size(), 2'100'000U);
}

TEST(PathPlot, ManyHolesGiveAPictureOfBoundedSize) {
  PathPlot plot(axes("XYZ"), "holes");
  for (int i = 0; i < 300; ++i) {
    for (int j = 0; j < 300; ++j) drill(plot, i, j);
  }
  EXPECT_LT(plot.svg().size(), 2'000'000U);
}

TEST(PathPlot, TheSameMotionsGiveTheSameBytes) {
  PathPlot first(axes("XYZ"), "title"), second(axes("XYZ"), "title");
  for (PathPlot* plot : {&first, &second}) {
    plot->take(tool(3));
    drill(*plot, 10, 20);
    mill_surface(*plot, 100, 600);
  }
  EXPECT_EQ(first.svg(), second.svg());
  EXPECT_EQ(first.png(), second.png());
}

TEST(PathPlot, LookingDoesNotChangeThePicture) {
  PathPlot looked(axes("XYZ"), ""), other(axes("XYZ"), "");
  for (int i = 0; i < 60'000; ++i) {
    const auto next = line(0.01 * i, std::sin(0.01 * i), 0);
    looked.take(next);
    other.take(next);
    if (i % 20'000 == 10) (void)looked.svg();
  }
  EXPECT_EQ(looked.svg(), other.svg());
}

TEST(PathPlot, NoMotionAtAllIsAPicture) { expect_sound(PathPlot(axes("XYZ"), "nothing")); }

TEST(PathPlot, OnePointIsAPicture) {
  PathPlot plot(axes("XYZ"), "point");
  plot.take(line(0, 0, 0));
  expect_sound(plot);
}

TEST(PathPlot, OnlyRapidsAreAPicture) {
  PathPlot plot(axes("XYZ"), "rapids");
  plot.take(rapid(10, 20, 30));
  expect_sound(plot);
  EXPECT_NE(plot.svg().find("nothing is cut"), std::string::npos);
}

TEST(PathPlot, OneLineAlongAnyAxisIsAPicture) {
  for (const auto& end : {line(80, 0, 0), line(0, 80, 0), line(0, 0, 80)}) {
    PathPlot plot(axes("XYZ"), "line");
    plot.take(end);
    expect_sound(plot);
  }
}

TEST(PathPlot, PartsOfAnySizeArePictures) {
  for (const double size : {1e-9, 1e-3, 1.0, 1e6, 1e9, 1e30}) {
    PathPlot plot(axes("XYZ"), "size");
    plot.take(rapid(-512.345, -200.5, -100));
    plot.take(line(-512.345 + size, -200.5, -100));
    plot.take(arc(-512.345, -200.5, -100 - size, -512.345 + size / 2, -200.5));
    expect_sound(plot);
  }
}

TEST(PathPlot, CoordinatesThatAreNotFiniteAreIgnored) {
  PathPlot plot(axes("XYZ"), "bad");
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  plot.take(line(nothing, 10, -infinity));
  plot.take(arc(5, 5, nothing, infinity, nothing));
  plot.take(rapid(infinity, 0, 0));
  expect_sound(plot);
}

TEST(PathPlot, ARapidFromFarAwayDoesNotMakeThePartTiny) {
  PathPlot near(axes("XYZ"), ""), far(axes("XYZ"), "");
  for (const auto& [plot, x] : {std::pair(&near, -20.0), std::pair(&far, -20000.0)}) {
    plot->take(rapid(x, 0, 0));
    plot->take(rapid(0, 0, 0));
    plot->take(line(100, 0, 0));
    plot->take(line(100, 50, 0));
  }
  const auto cut = [](const std::string& svg) {
    const std::size_t at = svg.find("stroke=\"#0072b2\"");
    return svg.substr(at, svg.find('>', at) - at);
  };
  EXPECT_EQ(cut(near.svg()), cut(far.svg()));
}

TEST(PathPlot, RapidsAreDashedAndCutsAreSolid) {
  PathPlot plot(axes("XYZ"), "");
  plot.take(rapid(0, 10, 0));
  plot.take(line(10, 10, 0));
  const std::string svg = plot.svg();
  EXPECT_EQ(count(svg, "stroke-dasharray"), 3U);    // two views and the legend
  EXPECT_EQ(count(svg, "stroke=\"#0072b2\""), 3U);  // two views and the legend
}

TEST(PathPlot, EachToolHasItsColourAndItsNumber) {
  PathPlot plot(axes("XYZ"), "");
  for (const std::uint32_t number : {7U, 12U}) {
    plot.take(tool(number));
    plot.take(rapid(number, 0, 0));
    plot.take(line(number, 10, 0));
  }
  const std::string svg = plot.svg();
  EXPECT_NE(svg.find("stroke=\"#0072b2\""), std::string::npos);
  EXPECT_NE(svg.find("stroke=\"#d55e00\""), std::string::npos);
  EXPECT_EQ(count(svg, ">T7<"), 3U);  // two views and the legend
  EXPECT_EQ(count(svg, ">T12<"), 3U);
}

TEST(PathPlot, HolesAreCounted) {
  PathPlot plot(axes("XYZ"), "");
  drill(plot, 10, 10);
  drill(plot, 20, 10);
  drill(plot, 10, 10);
  EXPECT_NE(plot.svg().find(">2 holes<"), std::string::npos);
}

TEST(PathPlot, AMachineWithoutYShowsZToTheRightAndXUpward) {
  PathPlot plot(axes("XZ"), "lathe");
  plot.take(motion(motion::Line{at(40, -30), {}}));
  const std::string svg = plot.svg();
  EXPECT_NE(svg.find(">Z mm<"), std::string::npos);
  EXPECT_NE(svg.find(">X mm<"), std::string::npos);
  EXPECT_EQ(svg.find("Isometric"), std::string::npos);
  expect_sound(plot);
}

TEST(PathPlot, RotaryAxesAreNotDrawn) {
  PathPlot plain(axes("XYZ"), ""), turning(axes("XYZA"), "");
  plain.take(line(10, 10, 0));
  base::TipPoint to = at(10, 10, 0);
  to.values[3] = 90;
  turning.take(motion(motion::Line{to, {}}));
  EXPECT_EQ(plain.svg(), turning.svg());
}

TEST(PathPlot, AMachineWithoutAnyOfTheAxesIsAPicture) {
  PathPlot plot(axes("AC"), "rotary");
  plot.take(line(10, 20, 0));
  expect_sound(plot);
}

TEST(PathPlot, TheTitleCanHoldAnyBytes) {
  PathPlot plot(axes("XYZ"), "a<b>&\"c\"\xff\x01\xC3\xA4");
  EXPECT_NE(plot.svg().find(">a&lt;b&gt;&amp;\"c\"??\xC3\xA4<"), std::string::npos);
  expect_sound(plot);
}

}  // namespace
}  // namespace kerf::output
