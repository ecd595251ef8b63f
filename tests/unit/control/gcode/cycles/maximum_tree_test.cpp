#include "control/gcode/cycles/maximum_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "seeded_random.hpp"

namespace kerf::control {
namespace {

TEST(MaximumTree, AnswersAsAWalkAlongTheRowDoes) {
  test::SeededRandom random(test::kSeed);
  for (int i = 0; i < 500; ++i) {
    std::vector<double> row(static_cast<std::size_t>(random.count(0, 40)));
    for (double& value : row) value = random.count(-3, 3);
    const MaximumTree tree(row);
    for (std::size_t first = 0; first <= row.size(); ++first) {
      const auto begin = row.begin() + static_cast<std::ptrdiff_t>(first);
      const double bound = random.count(-4, 4);
      const auto found = std::find_if(begin, row.end(), [&](double v) { return v > bound; });
      ASSERT_EQ(tree.first_above(first, bound), static_cast<std::size_t>(found - row.begin()));
      const double most = begin == row.end() ? -INFINITY : *std::max_element(begin, row.end());
      ASSERT_EQ(tree.maximum(first, row.size()), most);
    }
  }
}

TEST(MaximumTree, OfNothingHasNoMaximum) {
  const MaximumTree tree({});
  EXPECT_EQ(tree.first_above(0, -INFINITY), 0);
  EXPECT_EQ(tree.maximum(0, 0), -INFINITY);
}

}  // namespace
}  // namespace kerf::control
