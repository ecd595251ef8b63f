#include "output/picture/internal/path_recorder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plot_motions.hpp"

namespace kerf::output::plot {
namespace {

using namespace testing;

TEST(PathRecorder, TellsCutsFromTravelling) {
  PathRecorder recorder(axes("XYZ"));
  recorder.take(rapid(-50, 0, 10));
  recorder.take(line(10, 20, -5));
  EXPECT_EQ(recorder.cut_extents().low(), (Point3{-50, 0, -5}));
  EXPECT_EQ(recorder.cut_extents().high(), (Point3{10, 20, 10}));
  recorder.take(rapid(70, 0, 0));
  EXPECT_EQ(recorder.cut_extents().high(), (Point3{10, 20, 10}));
  EXPECT_EQ(recorder.all_extents().high(), (Point3{70, 20, 10}));
}

TEST(PathRecorder, CutExtentsIncludeWhereACutBegins) {
  PathRecorder recorder(axes("XYZ"));
  recorder.take(rapid(5, 5, 0));
  recorder.take(line(20, 5, 0));
  recorder.take(rapid(-30, 5, 0));
  recorder.take(line(0, 5, 0));
  EXPECT_EQ(recorder.cut_extents().low()[kX], -30);
}

TEST(PathRecorder, CutExtentsIncludeTheBulgeOfAnArc) {
  PathRecorder recorder(axes("XYZ"));
  recorder.take(rapid(10, 0, 0));
  recorder.take(arc(-10, 0, 0, 0, 0));
  EXPECT_NEAR(recorder.cut_extents().high()[kY], 10, 1e-12);
}

TEST(PathRecorder, WithTheBeamOffAFeedMoveIsTravelling) {
  PathRecorder recorder(axes("XYZ"));
  recorder.take(power(0));
  recorder.take(line(100, 0));
  EXPECT_TRUE(recorder.cut_extents().empty());
  recorder.take(power(80));
  recorder.take(line(110, 0));
  EXPECT_EQ(recorder.cut_extents().low(), (Point3{100, 0, 0}));
}

TEST(PathRecorder, ThreadsAreCutsAndProbingIsTravelling) {
  PathRecorder recorder(axes("XYZ"));
  recorder.take(motion(motion::Probe{at(10, 0), {}, true}));
  EXPECT_TRUE(recorder.cut_extents().empty());
  recorder.take(motion(motion::Thread{at(20, 0), 1.5}));
  EXPECT_FALSE(recorder.cut_extents().empty());
}

TEST(PathRecorder, StartsWhereTheFirstCutStartsAndEndsWhereTheLastOneEnds) {
  PathRecorder recorder(axes("XYZ"));
  recorder.take(rapid(5, 0));
  EXPECT_EQ(recorder.start(), (Point3{0, 0, 0}));
  EXPECT_EQ(recorder.end(), (Point3{5, 0, 0}));
  recorder.take(line(6, 0));
  recorder.take(rapid(100, 0));
  EXPECT_EQ(recorder.start(), (Point3{5, 0, 0}));
  EXPECT_EQ(recorder.end(), (Point3{6, 0, 0}));
}

TEST(PathRecorder, FindsAxesByTheirLetters) {
  PathRecorder recorder(axes("ZAXY"));
  recorder.take(motion(motion::Line{{{-3, 90, 1, 2}}, {}}));
  EXPECT_EQ(recorder.end(), (Point3{1, 2, -3}));
}

TEST(PathRecorder, ArcsOfALatheLieInItsPlane) {
  PathRecorder recorder(lathe_axes());
  motion::Arc ball;  // a ball end of radius 10
  ball.plane = motion::Plane::zx;
  ball.direction = motion::Direction::counterclockwise;
  ball.to = at(10, -10);
  ball.center = {-10, 0};
  recorder.take(motion(ball));
  EXPECT_FALSE(recorder.has_y());
  EXPECT_EQ(recorder.end(), (Point3{10, 0, -10}));
  EXPECT_NEAR(recorder.cut_extents().high()[kX], 10, 1e-12);
  EXPECT_NEAR(recorder.cut_extents().high()[kZ], 0, 1e-12);
}

TEST(PathRecorder, AnArcInAPlaneTheMachineLacksIsItsChord) {
  PathRecorder recorder(axes("XZ"));
  motion::Arc arc;
  arc.to = at(10, 5);
  recorder.take(motion(arc));
  EXPECT_TRUE(recorder.store().path().arcs.empty());
  EXPECT_EQ(recorder.end(), (Point3{10, 0, 5}));
}

// From where the tool stands through `via` to `to`.
motion::SpaceArc space_arc(const base::TipPoint& via, const base::TipPoint& to) {
  return {.to = to, .via = via, .feed = {}};
}

TEST(PathRecorder, AnArcInSpaceIsDrawnInChordsOfItsCircle) {
  PathRecorder recorder(axes("XYZ"));  // about (30, 0, 8.75) with radius 31.25
  recorder.take(motion(space_arc(at(30, 0, 40), at(60, 0, 0))));
  const Path path = recorder.store().path();
  for (const Path::Vertex& vertex : path.vertices) {
    EXPECT_EQ(vertex.at[kY], 0);
    EXPECT_NEAR(std::hypot(vertex.at[kX] - 30, vertex.at[kZ] - 8.75), 31.25, 1e-9);
  }
  EXPECT_GE(path.vertices.size(), 70U);  // 212.5 degrees
  EXPECT_EQ(recorder.end(), (Point3{60, 0, 0}));
  EXPECT_EQ(recorder.move_count(), 1U);
  EXPECT_NEAR(recorder.cut_extents().high()[kZ], 40, 0.0004 * 31.25);
  EXPECT_NEAR(recorder.cut_extents().low()[kX], -1.25, 0.0004 * 31.25);
}

TEST(PathRecorder, AFullCircleInSpaceComesBack) {
  PathRecorder recorder(axes("XYZ"));
  motion::SpaceArc circle = space_arc(at(30, 0, 40), at(0, 0, 0));
  circle.second_via = at(60, 0, 0);
  circle.full_circle = true;
  recorder.take(motion(circle));
  EXPECT_EQ(recorder.end(), (Point3{0, 0, 0}));
  EXPECT_NEAR(recorder.cut_extents().low()[kZ], 8.75 - 31.25, 0.0004 * 31.25);
  EXPECT_EQ(recorder.move_count(), 1U);
}

TEST(PathRecorder, WithTheBeamOffAnArcInSpaceIsTravelling) {
  PathRecorder recorder(axes("XYZ"));
  recorder.take(power(0));
  recorder.take(motion(space_arc(at(30, 0, 40), at(60, 0, 0))));
  EXPECT_TRUE(recorder.cut_extents().empty());
  EXPECT_NEAR(recorder.all_extents().high()[kZ], 40, 0.0004 * 31.25);
}

TEST(PathRecorder, AnArcInSpaceThatTheMachineLacksAnAxisForIsTwoLines) {
  PathRecorder recorder(axes("XZ"));  // Y is not drawn: the points lie on one line
  recorder.take(motion(space_arc(at(10, 0), at(30, 0))));
  EXPECT_EQ(recorder.store().path().vertices.size(), 3U);
  EXPECT_EQ(recorder.end(), (Point3{30, 0, 0}));
}

TEST(PathRecorder, RemembersEachToolOnceAndWhereItFirstCuts) {
  PathRecorder recorder(axes("XYZ"));
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
  PathRecorder recorder(axes("XYZ"));
  for (std::uint32_t i = 1; i <= 10'000; ++i) {
    recorder.take(tool(i));
    recorder.take(line(i, 0));
  }
  EXPECT_EQ(recorder.tools().size(), PathRecorder::kMaxTools);
}

}  // namespace
}  // namespace kerf::output::plot
