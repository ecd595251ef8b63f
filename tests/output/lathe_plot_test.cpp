#include <gtest/gtest.h>

#include <functional>

#include "output/picture/internal/half_section.hpp"
#include "output/picture/path_plot.hpp"
#include "plot_motions.hpp"

namespace kerf::output {
namespace {

using namespace testing;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

motion::Motion thread(double x, double z, double lead) {
  return motion(motion::Thread{.to = at(x, z), .lead = lead});
}

// Turning with a nose, a groove, a thread; x is a radius.
void turn_part(PathPlot& plot) {
  const auto with_offset = [&](motion::Motion move, std::uint32_t offset) {
    move.length.offset = offset;
    plot.take(move);
  };
  plot.take(tool(1));
  with_offset(rapid(30, 2), 1);
  with_offset(line(12, 0), 1);
  with_offset(line(12, -40), 1);
  with_offset(line(30, -40), 1);
  plot.take(tool(3));
  plot.take(rapid(20, -30));
  plot.take(line(8, -30));
  plot.take(rapid(20, -30));
  plot.take(tool(4));
  plot.take(rapid(11, 5));
  plot.take(thread(11, -25, 2));
  plot.take(rapid(20, -25));
}

control::Memory noses() {
  control::Memory memory(8);
  memory.turning[1].geometry.radius = 0.8;
  memory.turning[1].tip = 3;
  return memory;
}

TEST(LathePlot, IsAHalfSectionWithDiametersOnBothSidesOfTheAxis) {
  PathPlot plot(lathe_axes(), "part");
  turn_part(plot);
  const std::string svg = plot.svg();
  EXPECT_TRUE(has(svg, ">X \u2300 mm<")) << svg.substr(0, 400);
  EXPECT_TRUE(has(svg, "Half section"));
  EXPECT_TRUE(has(svg, ">part, as the cuts leave it<"));
  EXPECT_TRUE(has(svg, ">60<"));  // the extent of X, as programmed
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_FALSE(has(svg, "nan"));
  EXPECT_TRUE(plot.png().starts_with("\x89PNG\r\n"));
}

TEST(LathePlot, TheLegendSaysWhatInsertsAreTakenFor) {
  const control::Memory memory = noses();
  PathPlot plot(lathe_axes(), "part", PlotColors::tools, ToolTable{&memory, false});
  turn_part(plot);
  const std::string svg = plot.svg();
  EXPECT_TRUE(has(svg, ">T1: 80\u00b0 insert, R 0.8, tip 3<"));
  EXPECT_TRUE(has(svg, ">T3: blade 3 mm<"));
  EXPECT_TRUE(has(svg, ">T4 thread: 60\u00b0<"));
  EXPECT_TRUE(has(svg, "shapes of inserts are assumed"));
}

TEST(LathePlot, AToolThatLeavesTowardsTheAxisBores) {
  PathPlot plot(lathe_axes(), "bore");
  plot.take(tool(2));
  plot.take(rapid(15, 2));
  plot.take(line(15, -20));
  plot.take(rapid(14, -20));
  EXPECT_TRUE(has(plot.svg(), ">T2: 80\u00b0 boring insert<"));
}

TEST(LathePlot, AToolThatGoesDownSteeplyHasASharperCorner) {
  PathPlot plot(lathe_axes(), "undercut");
  plot.take(rapid(20, 2));
  plot.take(line(20, -10));
  plot.take(line(15, -20));  // 26.6 degrees
  plot.take(line(20, -30));
  EXPECT_TRUE(has(plot.svg(), ": 55\u00b0 insert<"));
}

TEST(LathePlot, AToolOnTheAxisIsADrillOfTheSizeInTheTable) {
  control::Memory memory(8);
  memory.tools[5].radius_geometry = 6;
  PathPlot plot(lathe_axes(), "hole", PlotColors::tools, ToolTable{&memory, false});
  plot.take(tool(5));
  plot.take(rapid(0, 5));
  plot.take(line(0, -30));
  plot.take(rapid(0, 5));
  EXPECT_TRUE(has(plot.svg(), ">T5: drill \u2300 12<"));
}

TEST(LathePlot, TheFaceIsSeenWhereTheSpindleWasAnAxis) {
  PathPlot turned(lathe_axes("XZC"), "turned"), driven(lathe_axes("XZC"), "driven");
  for (PathPlot* plot : {&turned, &driven}) {
    plot->take(tool(7));
    for (const double angle : {0.0, 90.0, 180.0}) {
      const double c = plot == &driven ? angle : 0;
      plot->take(rapid(20, 2, c));
      plot->take(line(20, -10, c));
      plot->take(rapid(20, 2, c));
    }
  }
  EXPECT_FALSE(has(turned.svg(), ">Face"));
  const std::string svg = driven.svg();
  EXPECT_TRUE(has(svg, ">Face, C at 0<"));
  EXPECT_TRUE(has(svg, ">Y mm<"));
  EXPECT_TRUE(has(svg, ">T7: driven<"));
}

TEST(LathePlot, TheSameMotionsGiveTheSameBytes) {
  PathPlot first(lathe_axes(), "part"), second(lathe_axes(), "part");
  turn_part(first);
  turn_part(second);
  EXPECT_EQ(first.svg(), second.svg());
}

TEST(LathePlot, ManyMovesGiveAPictureOfBoundedSize) {
  PathPlot plot(lathe_axes(), "long");
  Random random(7);
  for (int i = 0; i < 200'000; ++i) plot.take(line(50 * random.next(), -100 * random.next()));
  EXPECT_LT(plot.svg().size(), 2'300'000U);
}

TEST(LathePlot, NothingAtAllIsAPicture) {
  const PathPlot nothing(lathe_axes(), "nothing");
  EXPECT_TRUE(nothing.svg().ends_with("</svg>\n"));
  EXPECT_FALSE(has(nothing.svg(), "nan"));
  PathPlot point(lathe_axes("XZC"), "point");
  point.take(line(0, 0, 90));
  EXPECT_FALSE(has(point.svg(), "nan"));
}

}  // namespace
}  // namespace kerf::output
