// Depths of the passes of G76 (docs/dialect/turning.md, pecks and threads), from a table.
#include "control/gcode/cycles/thread_passes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace kerf::control {
namespace {

constexpr double kRounded_mm = 5.001e-4;  // the table has three decimals

struct Row {
  double height;
  double first;
  double least;
  double finish;
  int finish_passes;
  std::vector<double> depths;
};

const std::vector<Row> kTable{
    {1.3,
     0.35,
     0.1,
     0.05,
     2,
     {0.350, 0.495, 0.606, 0.706, 0.806, 0.906, 1.006, 1.106, 1.206, 1.250, 1.300, 1.300}},
    {1.083,
     0.3,
     0.05,
     0.02,
     1,
     {0.300, 0.424, 0.520, 0.600, 0.671, 0.735, 0.794, 0.849, 0.900, 0.950, 1.000, 1.050, 1.063,
      1.083}},
    {0.61, 0.2, 0.06, 0.03, 1, {0.200, 0.283, 0.346, 0.406, 0.466, 0.526, 0.580, 0.610}},
    {2.5,
     0.6,
     0.1,
     0.1,
     2,
     {0.600, 0.849, 1.039, 1.200, 1.342, 1.470, 1.587, 1.697, 1.800, 1.900, 2.000, 2.100, 2.200,
      2.300, 2.400, 2.500, 2.500}},
    {0.9, 0.5, 0.15, 0, 2, {0.500, 0.707, 0.866, 0.900, 0.900, 0.900}},
};

std::vector<double> depths_of(const Row& row) {
  ThreadDepths depths({.height = row.height,
                       .first_depth = row.first,
                       .least_depth = row.least,
                       .finish = row.finish,
                       .finish_passes = row.finish_passes,
                       .run_out = {}});
  std::vector<double> all;
  for (double depth = 0; depths.next(depth);) all.push_back(depth);
  return all;
}

TEST(ThreadDepths, ChipsAreEqualThenAtLeastTheLeastThenTheFinishingPasses) {
  for (const Row& row : kTable) {
    const std::vector<double> depths = depths_of(row);
    ASSERT_EQ(depths.size(), row.depths.size()) << row.height;
    for (std::size_t i = 0; i < depths.size(); ++i)
      EXPECT_NEAR(depths[i], row.depths[i], kRounded_mm) << row.height << ", pass " << i + 1;
  }
}

}  // namespace
}  // namespace kerf::control
