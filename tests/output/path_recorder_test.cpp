#include "output/internal/plot/path_recorder.hpp"

#include <gtest/gtest.h>

#include "plot_motions.hpp"

namespace kerf::output::plot {
namespace {

using namespace testing;

TEST(PathRecorder, TellsCutsFromTravelling) {
  PathRecorder recorder(axes("XYZ"), 1);
  recorder.take(rapid(-50, 0, 10));
  recorder.take(line(10, 20, -5));
  EXPECT_EQ(recorder.cut_extents().low(), (Point3{-50, 0, -5}));
  EXPECT_EQ(recorder.cut_extents().high(), (Point3{10, 20, 10}));
  recorder.take(rapid(70, 0, 0));
  EXPECT_EQ(recorder.cut_extents().high(), (Point3{10, 20, 10}));
  EXPECT_EQ(recorder.all_extents().high(), (Point3{70, 20, 10}));
}

TEST(PathRecorder, CutExtentsIncludeWhereACutBegins) {
  PathRecorder recorder(axes("XYZ"), 1);
  recorder.take(rapid(5, 5, 0));
  recorder.take(line(20, 5, 0));
  recorder.take(rapid(-30, 5, 0));
  recorder.take(line(0, 5, 0));
  EXPECT_EQ(recorder.cut_extents().low()[kX], -30);
}

TEST(PathRecorder, CutExtentsIncludeTheBulgeOfAnArc) {
  PathRecorder recorder(axes("XYZ"), 1);
  recorder.take(rapid(10, 0, 0));
  recorder.take(arc(-10, 0, 0, 0, 0));
  EXPECT_NEAR(recorder.cut_extents().high()[kY], 10, 1e-12);
}

TEST(PathRecorder, WithTheBeamOffAFeedMoveIsTravelling) {
  PathRecorder recorder(axes("XYZ"), 1);
  recorder.take(power(0));
  recorder.take(line(100, 0));
  EXPECT_TRUE(recorder.cut_extents().empty());
  recorder.take(power(80));
  recorder.take(line(110, 0));
  EXPECT_EQ(recorder.cut_extents().low(), (Point3{100, 0, 0}));
}

TEST(PathRecorder, ThreadsAreCutsAndProbingIsTravelling) {
  PathRecorder recorder(axes("XYZ"), 1);
  recorder.take(motion(control::Probe{at(10, 0), {}, true}));
  EXPECT_TRUE(recorder.cut_extents().empty());
  recorder.take(motion(control::Thread{at(20, 0), 1.5}));
  EXPECT_FALSE(recorder.cut_extents().empty());
}

TEST(PathRecorder, StartsWhereTheFirstCutStartsAndEndsWhereTheLastOneEnds) {
  PathRecorder recorder(axes("XYZ"), 1);
  recorder.take(rapid(5, 0));
  EXPECT_EQ(recorder.start(), (Point3{0, 0, 0}));
  EXPECT_EQ(recorder.end(), (Point3{5, 0, 0}));
  recorder.take(line(6, 0));
  recorder.take(rapid(100, 0));
  EXPECT_EQ(recorder.start(), (Point3{5, 0, 0}));
  EXPECT_EQ(recorder.end(), (Point3{6, 0, 0}));
}

TEST(PathRecorder, FindsAxesByTheirLetters) {
  PathRecorder recorder(axes("ZAXY"), 1);
  recorder.take(motion(control::Line{{{-3, 90, 1, 2}}, {}}));
  EXPECT_EQ(recorder.end(), (Point3{1, 2, -3}));
}

TEST(PathRecorder, HalvesDiametersAlsoInArcs) {
  PathRecorder recorder(axes("XZ"), 0.5);
  control::Arc ball;  // a ball end of radius 10
  ball.plane = control::Plane::zx;
  ball.direction = control::Direction::counterclockwise;
  ball.to = at(20, -10);
  ball.center = {-10, 0};
  recorder.take(motion(ball));
  EXPECT_FALSE(recorder.has_y());
  EXPECT_EQ(recorder.end(), (Point3{10, 0, -10}));
  EXPECT_NEAR(recorder.cut_extents().high()[kX], 10, 1e-12);
  EXPECT_NEAR(recorder.cut_extents().high()[kZ], 0, 1e-12);
}

TEST(PathRecorder, AnArcInAPlaneTheMachineLacksIsItsChord) {
  PathRecorder recorder(axes("XZ"), 1);
  control::Arc arc;
  arc.to = at(10, 5);
  recorder.take(motion(arc));
  EXPECT_TRUE(recorder.store().path().arcs.empty());
  EXPECT_EQ(recorder.end(), (Point3{10, 0, 5}));
}

TEST(PathRecorder, RemembersEachToolOnceAndWhereItFirstCuts) {
  PathRecorder recorder(axes("XYZ"), 1);
  for (const std::uint32_t number : {4U, 9U, 4U}) {
    recorder.take(tool(number));
    recorder.take(line(number, recorder.end()[kY] + 1));
  }
  ASSERT_EQ(recorder.tools().size(), 3U);  // and none at first
  EXPECT_FALSE(recorder.tools()[0].cuts);
  EXPECT_EQ(recorder.tools()[1].number, 4U);
  EXPECT_EQ(recorder.tools()[1].first_cut, (Point3{0, 0, 0}));
  EXPECT_EQ(recorder.tools()[2].first_cut, (Point3{4, 1, 0}));
}

TEST(PathRecorder, TheNumberOfToolsIsBounded) {
  PathRecorder recorder(axes("XYZ"), 1);
  for (std::uint32_t i = 1; i <= 10'000; ++i) {
    recorder.take(tool(i));
    recorder.take(line(i, 0));
  }
  EXPECT_EQ(recorder.tools().size(), PathRecorder::kMaxTools);
}

}  // namespace
}  // namespace kerf::output::plot
