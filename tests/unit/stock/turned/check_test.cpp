// What turning tools may not meet, pieces, threads, and input that nobody would mean.
#include <gtest/gtest.h>

#include <limits>

#include "stock/turned/turned_job.hpp"

namespace kerf::stock::turned {
namespace {

using std::numbers::pi;

const Contact& back(const Job& job) { return job.last().contacts[index(ToolPart::flank)]; }
const Contact& edge(const Job& job) { return job.last().contacts[index(ToolPart::edge)]; }

TEST(TurnedCheck, SlidingBackAlongATurnedSurfaceIsNoCrash) {
  Job job(50, -80, 0);
  job.with(turning(0.8)).at(54, 2).rapid(40, 2).to(40, -60).rapid(40, 2);
  EXPECT_TRUE(job.met_nothing());
  job.rapid(50, 2).rapid(50, -90);
  EXPECT_TRUE(job.met_nothing());
}

TEST(TurnedCheck, RapidBelowASurfaceIsOne) {
  Job job(50, -80, 0);
  job.with(turning(0)).at(54, 2).rapid(48, 2).rapid(48, -30);
  EXPECT_TRUE(edge(job).is_one());
  EXPECT_NEAR(edge(job).depth_mm, 1, 1e-9);
  // Its main edge leans 5° back from the shoulder.
  const double wedge = 2 * pi * std::tan(pi / 36) / 2 * (24 + 2.0 / 3);
  EXPECT_NEAR(edge(job).volume.value(), pi * (625 - 576) * 30 - wedge, 1e-6);
  job.rapid(48, 2).rapid(48, -30);
  EXPECT_FALSE(edge(job).is_one()) << "a crash is told once";
}

TEST(TurnedCheck, DeeperThanTheEdgeTheBackMeets) {
  Job job(50, -80, 0);
  job.with(turning(0.8, 3, 12.7)).at(54, 2).to(40, 2).to(40, -30);
  EXPECT_TRUE(job.met_nothing());
  Job deep(50, -80, 0);
  // The edge of 12.9 mm does not reach to ρ = 25 from 5.
  deep.with(turning(0.8, 3, 12.7)).at(54, 2).to(10, 2).to(10, -30);
  EXPECT_TRUE(back(deep).is_one());
}

TEST(TurnedCheck, ABackThatIsFedIntoMaterial) {
  Job job(50, -80, 0);
  // Down into the full bar the minor edge cuts, as deep as it rises to its end.
  job.with(turning(0.4, 3, 12.7)).at(54, -40).to(48, -40);
  EXPECT_TRUE(job.met_nothing());
  job.to(40, -40);
  EXPECT_TRUE(back(job).is_one());
  // T2 has its back ahead there.
  Job bore(50, -80, 0);
  bore.with(turning(0.4, 2, 12.7)).at(60, -40).to(30, -40);
  EXPECT_TRUE(back(bore).is_one());
}

TEST(TurnedCheck, BoringBarMeetsAHoleThatIsTooSmall) {
  const Tool tool = test::tool_of("boring-bar", {{M::nose_radius, 0.4},
                                                 {M::ic, 6.35},
                                                 {M::minimum_bore, 16},
                                                 {M::overhang, 40},
                                                 {M::holder_width, 12},
                                                 {M::tip, 2}});
  Job wide(bar(50, -80, 0, 20));
  wide.with(body_of(tool)).at(22, 2).to(22, -30).to(20, -30).rapid(20, 2);
  EXPECT_TRUE(wide.met_nothing());
  EXPECT_NEAR(wide.removed() / (pi * (121 - 100) * 30), 1, 0.01);
  Job narrow(bar(50, -80, 0, 12));
  narrow.with(body_of(tool)).at(14, 2).to(14, -30);
  EXPECT_FALSE(narrow.met_nothing());
}

TEST(TurnedCheck, FacingPastTheCentreLeavesNoPip) {
  Job job(50, -80, 0);
  job.with(turning(0.8)).at(54, -1).to(-1.6, -1);
  EXPECT_NEAR(job.removed() / (pi * 625), 1, 1e-9);
  EXPECT_EQ(job.part().pieces().size(), 1U);
  Job pip(50, -80, 0);
  pip.with(turning(0.8)).at(54, -1).to(0, -1);
  EXPECT_LT(pip.removed(), pi * 625);
  EXPECT_GT(pip.removed(), pi * 625 - 1.6);
}

TEST(TurnedCheck, TheSameContourTwiceLeavesNoSliver) {
  Job job(50, -80, 0);
  job.with(turning(0.8)).at(54, 2);
  for (int i = 0; i < 3; ++i) {
    job.rapid(30, 2).to(30, -10).turn(40, -10, -pi / 2).to(46, -30).to(52, -31).rapid(54, 2);
  }
  EXPECT_EQ(job.part().region().loops.size(), 1U);
  EXPECT_LE(contour::vertex_count(job.part().region()), 12U);
  EXPECT_TRUE(job.met_nothing());
}

TEST(TurnedPieces, OfTwoGroovesToTheAxisAreThree) {
  Job job(50, -80, 0);
  job.with(blade(3)).at(54, -20).to(0, -20).rapid(54, -20).rapid(54, -60).to(-1, -60);
  const auto pieces = job.part().pieces();
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_NEAR(pieces[0].volume_mm3, pi * 625 * 37, 1e-6);
  EXPECT_NEAR(pieces[0].extents.high.z, -20, 1e-9);
  EXPECT_FALSE(pieces[0].held);
  EXPECT_TRUE(pieces[1].held);
  EXPECT_NEAR(pieces[1].extents.low.z, -80, 1e-9);
  EXPECT_NEAR(pieces[2].volume_mm3, pi * 625 * 17, 1e-6);
  EXPECT_FALSE(pieces[2].held);
}

TEST(TurnedPieces, ARingAndACavityHangTogetherAsTheyDo) {
  // A disc of a ring about a core: the ring is parted from it.
  Job job(50, -10, 0);
  Tool tool = test::tool_of("face-grooving", {{M::width, 2}, {M::tip, 3}});
  job.with(body_of(tool)).at(30, 5).to(30, -12);
  const auto pieces = job.part().pieces();
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_TRUE(pieces[0].held && pieces[1].held) << "both reach as far to the chuck";
}

Body threading(double pitch) {
  return body_of(test::tool_of("threading", {{M::profile_angle, 60}, {M::pitch, pitch}}));
}

// The thread of stock.md §8.1.
TEST(TurnedThreads, AreKeptBesideTheRegion) {
  Job job(30, -60, 0);
  job.with(threading(2)).at(34, 2);
  for (const double x : {29.0, 28.0, 27.4}) {
    job.rapid(x, 2).thread(x, -30, 2).rapid(34, -30).rapid(34, 2);
  }
  const auto threads = job.part().threads();
  ASSERT_EQ(threads.size(), 1U);
  EXPECT_EQ(threads[0].axis, 'Z');
  EXPECT_NEAR(threads[0].from, 0, 1e-9);
  EXPECT_NEAR(threads[0].to, -30, 1e-9);
  EXPECT_NEAR(threads[0].major, 30, 1e-9);
  EXPECT_NEAR(threads[0].minor, 27.4, 1e-9);
  EXPECT_EQ(threads[0].starts, 1);
  EXPECT_FALSE(threads[0].is_inside);
  const double area = 1.3 * 1.3 * std::tan(pi / 6);
  EXPECT_NEAR(threads[0].volume_mm3 / (area * 2 * pi * (15 - 1.3 / 3) * 15), 1, 1e-9);
  EXPECT_NEAR(threads[0].volume_mm3, 1339.5, 0.05);
  EXPECT_EQ(job.removed(), 0);
  EXPECT_GT(job.sum().threaded.value(), 0);
  EXPECT_TRUE(job.met_nothing());
}

TEST(TurnedThreads, ReturnsThroughTheRingAreNoCrashButOthersAre) {
  Job job(30, -60, 0);
  job.with(threading(2)).at(34, 2).rapid(27.4, 2).thread(27.4, -30, 2).rapid(27.4, 2);
  EXPECT_TRUE(job.met_nothing());
  job.with(turning(0)).at(34, 2).rapid(28, 2).rapid(28, -20);
  EXPECT_TRUE(edge(job).is_one());
}

TEST(TurnedThreads, OfTwoStartsHaveHalfTheLeadForPitch) {
  Job job(30, -60, 0);
  job.with(threading(2)).at(34, 4);
  for (const double angle : {0.0, 180.0}) {
    for (const double x : {29.0, 27.4}) job.rapid(x, 4).thread(x, -30, 4, angle).rapid(34, 4);
  }
  const auto threads = job.part().threads();
  ASSERT_EQ(threads.size(), 1U);
  EXPECT_EQ(threads[0].starts, 2);
  EXPECT_NEAR(threads[0].pitch, 2, 1e-12);
  EXPECT_NEAR(threads[0].volume_mm3, 1339.5, 0.05);
}

TEST(TurnedThreads, OfAHoleAreInside) {
  const Body body =
      body_of(test::tool_of("threading", {{M::profile_angle, 60}, {M::pitch, 2}, {M::tip, 6}}));
  Job job(bar(60, -40, 0, 27.4));
  job.with(body).at(25, 2).rapid(28.4, 2).thread(28.4, -20, 2).rapid(25, 2);
  job.rapid(30, 2).thread(30, -20, 2).rapid(25, 2);
  const auto threads = job.part().threads();
  ASSERT_EQ(threads.size(), 1U);
  EXPECT_TRUE(threads[0].is_inside);
  EXPECT_NEAR(threads[0].major, 30, 1e-9);
  EXPECT_NEAR(threads[0].minor, 27.4, 1e-9);
  const double area = 1.3 * 1.3 * std::tan(pi / 6);
  EXPECT_NEAR(threads[0].volume_mm3 / (area * 2 * pi * (13.7 + 1.3 / 3) * 10), 1, 1e-9);
}

TEST(TurnedHostile, MovesThatLeadNowhere) {
  Job job(50, -80, 0);
  job.with(turning(0.8)).at(54, 2).to(54, 2).rapid(54, 2);
  EXPECT_EQ(job.removed(), 0);
  job.to(40, 2).to(40, -5);
  const double removed = job.removed();
  job.to(40, -5).rapid(40, -5);
  EXPECT_EQ(job.removed(), removed);
  EXPECT_TRUE(job.met_nothing());
}

TEST(TurnedHostile, ABarThatIsThinnerThanTheTool) {
  Job job(2, -80, 0);
  job.with(blade(3)).at(6, -40).to(0, -40);
  EXPECT_NEAR(job.removed() / (pi * 3), 1, 1e-9);
  Job drilled(2, -80, 0);
  drilled.with(drill(10)).at(0, 5).to(0, -100);
  EXPECT_EQ(drilled.part().left_mm3(), 0);
  EXPECT_TRUE(drilled.part().pieces().empty());
  EXPECT_GT(drilled.part().extents().low.z, drilled.part().extents().high.z);
  drilled.to(0, 5).rapid(0, -100);
  EXPECT_TRUE(drilled.met_nothing());
}

TEST(TurnedHostile, AnInsertLargerThanTheBar) {
  Job job(10, -10, 0);
  job.with(turning(0.8, 3, 200)).at(14, 2).to(14, -12).to(-14, -12);
  EXPECT_EQ(job.part().left_mm3(), 0);
}

TEST(TurnedHostile, ManyTurnsAndFarPlaces) {
  Job job(50, -80, 0);
  job.with(turning(0.8)).at(40, -5).turn(40, -4, 40);
  EXPECT_GT(job.removed(), 0);
  job.to(1e8, 1e8).to(40, 2);
  const double big = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isfinite(job.part().left_mm3()));
  EXPECT_FALSE(job.part().can_cut({.way = StraightWay{{0, big, 0}, {0, 0, 0}}}));
  EXPECT_FALSE(job.part().can_cut({.way = StraightWay{{0, 1, 0}, {0, 0, 0}}}));
  EXPECT_FALSE(job.part().can_cut({.way = TurningWay{{}, {}, {0, 0, 1}}}));
  EXPECT_FALSE(job.part().can_cut({.way = StraightWay{}, .body = 99}));
}

TEST(TurnedProbe, StopsWhereItFirstMeets) {
  TurnedPart part(bar(50, -80, 0));
  const auto stops = [&](Vec3 from, Vec3 to) { return part.first_touch({{from, to}, 2}); };
  EXPECT_NEAR(stops({10, 0, 22}, {10, 0, -18}).value(), 0.5, 1e-9);
  EXPECT_NEAR(stops({47, 0, -40}, {7, 0, -40}).value(), 0.5, 1e-9);
  EXPECT_NEAR(stops({-47, 0, -40}, {-7, 0, -40}).value(), 0.5, 1e-9);  // in front of the axis
  EXPECT_FALSE(stops({40, 0, 20}, {40, 0, -20}));
  EXPECT_EQ(part.left_mm3(), part.stock_mm3());
}

}  // namespace
}  // namespace kerf::stock::turned
