#include "output/picture/internal/hole_finder.hpp"

#include <gtest/gtest.h>

namespace kerf::output::plot {
namespace {

// Moves a tool as a program would.
class Drill {
 public:
  explicit Drill(HoleFinder& finder) : finder_(finder) {}
  void rapid(double x, double y, double z) { go({x, y, z}, {Trace::travel, 0}); }
  void feed(double x, double y, double z) { go({x, y, z}, {Trace::cut, tool}); }
  void hole(double x, double y) {
    rapid(x, y, 2);
    feed(x, y, -10);
    rapid(x, y, 2);
  }
  std::uint16_t tool = 1;

 private:
  void go(const Point3& to, Pen pen) {
    finder_.move(at_, to, pen);
    at_ = to;
  }
  HoleFinder& finder_;
  Point3 at_{};
};

class HoleFinderTest : public ::testing::Test {
 protected:
  HoleFinder finder;
  Drill drill{finder};
};

TEST_F(HoleFinderTest, DrillingDownAndComingUpIsAHole) {
  drill.hole(30, 40);
  ASSERT_EQ(finder.holes().size(), 1U);
  EXPECT_EQ(finder.holes()[0].x, 30);
  EXPECT_EQ(finder.holes()[0].y, 40);
}

TEST_F(HoleFinderTest, TheSamePlaceIsOneHoleOfItsLastTool) {
  drill.hole(30, 40);
  drill.hole(50, 40);
  drill.tool = 2;
  drill.hole(30.001, 40);
  ASSERT_EQ(finder.holes().size(), 2U);
  EXPECT_EQ(finder.holes()[0].tool, 2);
  EXPECT_EQ(finder.holes()[1].tool, 1);
}

TEST_F(HoleFinderTest, PeckingIsOneHole) {
  drill.rapid(10, 10, 2);
  drill.feed(10, 10, -4);
  drill.rapid(10, 10, -3);  // breaks the chip
  drill.feed(10, 10, -8);
  EXPECT_TRUE(finder.holes().empty());  // still in it
  drill.rapid(10, 10, 2);
  drill.rapid(10, 10, -7);
  drill.feed(10, 10, -12);
  drill.rapid(10, 10, 50);
  EXPECT_EQ(finder.holes().size(), 1U);
}

TEST_F(HoleFinderTest, TappingOutAtFeedIsAHole) {
  drill.rapid(10, 10, 2);
  drill.feed(10, 10, -8);
  drill.feed(10, 10, 2);
  EXPECT_EQ(finder.holes().size(), 1U);
}

TEST_F(HoleFinderTest, FineBoringThatStepsAsideBeforeComingUpIsAHole) {
  drill.rapid(10, 10, 2);
  drill.feed(10, 10, -8);
  drill.rapid(10.2, 10, -8);
  drill.rapid(10.2, 10, 2);
  ASSERT_EQ(finder.holes().size(), 1U);
  EXPECT_EQ(finder.holes()[0].x, 10);
}

TEST_F(HoleFinderTest, PlungingIntoAPocketIsNoHole) {
  drill.rapid(10, 10, 2);
  drill.feed(10, 10, -8);
  drill.feed(20, 10, -8);
  drill.feed(10, 10, -8);
  drill.rapid(10, 10, 2);
  EXPECT_TRUE(finder.holes().empty());
}

TEST_F(HoleFinderTest, APocketOfArcsIsNoHole) {
  drill.rapid(10, 10, 2);
  drill.feed(10, 10, -8);
  finder.sideways_cut();
  drill.rapid(10, 10, 2);
  EXPECT_TRUE(finder.holes().empty());
}

TEST_F(HoleFinderTest, RapidsUpAndDownAreNoHole) {
  drill.rapid(10, 10, 2);
  drill.rapid(10, 10, -8);
  drill.rapid(10, 10, 2);
  EXPECT_TRUE(finder.holes().empty());
}

TEST_F(HoleFinderTest, KeepsABoundedNumber) {
  for (std::size_t i = 0; i <= HoleFinder::kMaxHoles; ++i) {
    EXPECT_FALSE(finder.overflowed());
    drill.hole(static_cast<double>(i), 0);
  }
  EXPECT_EQ(finder.holes().size(), HoleFinder::kMaxHoles);
  EXPECT_TRUE(finder.overflowed());
}

}  // namespace
}  // namespace kerf::output::plot
