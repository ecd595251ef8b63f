// Arcs of several turns in plain G-code, which says one turn a block.
#include <gtest/gtest.h>

#include <string>

#include "output/programs/post.hpp"
#include "space_arc_cases.hpp"
#include "temporary_folder.hpp"

namespace kerf::test {
namespace {

using motion::Arc;
using motion::Direction;

// What stands between the head and the end.
std::string posted(const Arc& arc) {
  machine::MachineDefinition machine;
  machine.axes = five_axes();
  const TemporaryFolder folder;
  auto file = base::OutputFile::create(folder / "out");
  output::Post post(machine, "part", **file);
  post.take({.action = motion::Rapid{{{10, 0, 0}}, true}});
  post.take({.action = arc});
  post.finish();
  EXPECT_TRUE((*file)->commit());
  const std::string text = folder.read("out");
  const std::string head = "G0 X10. Y0.\n";
  const std::size_t begin = text.find(head) + head.size();
  return text.substr(begin, text.rfind("M30") - begin);
}

TEST(TurnsInPlainGCode, AreFullCirclesBeforeTheRest) {
  EXPECT_EQ(posted({.to = {{0, 10, 0}}, .feed = {300}, .turns = 2}),
            "G3 X10. Y0. I-10. J0. F300.\nG3 X10. Y0. I-10. J0.\nG3 X0. Y10. I-10. J0.\n");
}

TEST(TurnsInPlainGCode, OfAWholeCircleAreOneMoreCircle) {
  EXPECT_EQ(
      posted({.to = {{10, 0, 0}}, .feed = {300}, .turns = 1, .direction = Direction::clockwise}),
      "G2 X10. Y0. I-10. J0. F300.\nG2 X10. Y0. I-10. J0.\n");
}

TEST(TurnsInPlainGCode, OfAHelixRiseByTheirShareOfTheWay) {
  EXPECT_EQ(
      posted({.to = {{0, 10, 9}}, .feed = {300}, .turns = 2}),
      "G3 Z4. X10. Y0. I-10. J0. F300.\nG3 Z8. X10. Y0. I-10. J0.\nG3 X0. Y10. Z9. I-10. J0.\n");
}

TEST(TurnsInPlainGCode, OfInverseTimeHaveTheFeedOfTheWholeWay) {
  const motion::Feed half_a_minute{2, motion::FeedMode::inverse_time};
  EXPECT_EQ(posted({.to = {{10, 0, 0}}, .feed = half_a_minute, .turns = 1}),
            "G3 X10. Y0. I-10. J0. F251.3274\nG3 X10. Y0. I-10. J0.\n");
}

}  // namespace
}  // namespace kerf::test
