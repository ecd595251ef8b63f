#include "geometry/contour/box_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace kerf::contour {
namespace {

std::vector<std::uint32_t> met_by(const BoxTree& tree, const Box& box) {
  std::vector<std::uint32_t> found;
  tree.search(box, [&](std::uint32_t item) { found.push_back(item); });
  std::sort(found.begin(), found.end());
  return found;
}

TEST(BoxTree, BoxesThatHoldNothingAreMetByNone) {
  std::vector<Box> boxes(40);
  for (std::size_t i = 0; i < boxes.size(); i += 2) {
    const auto at = static_cast<double>(i);
    boxes[i] = {{at, 0}, {at + 1, 1}};
  }
  const BoxTree tree(boxes);
  EXPECT_EQ(met_by(tree, {{4.5, 0}, {8, 1}}), (std::vector<std::uint32_t>{4, 6, 8}));
  EXPECT_EQ(met_by(tree, {{-1e6, -1e6}, {1e6, 1e6}}).size(), 20U);
  EXPECT_TRUE(met_by(tree, Box{}).empty());
}

TEST(BoxTree, OfBoxesThatAllHoldNothingNoneIsMet) {
  const BoxTree tree(std::vector<Box>(20));
  EXPECT_TRUE(met_by(tree, {{-1, -1}, {1, 1}}).empty());
}

}  // namespace
}  // namespace kerf::contour
