#include "output/solid/solid_file.hpp"

#include <gtest/gtest.h>

namespace kerf::output {
namespace {

TEST(DeviationColor, GoesFromBlueByGreyToRedAndStaysThere) {
  EXPECT_EQ(deviation_color(-2), deviation_color(-1));
  EXPECT_EQ(deviation_color(2), deviation_color(1));
  const auto grey = deviation_color(0);
  EXPECT_TRUE(grey[0] == grey[1] && grey[1] == grey[2]);
  double last = -1;
  for (double share = -1; share <= 1; share += 0.125) {
    const auto color = deviation_color(share);
    const double redder = 1.0 * color[0] - color[2];
    EXPECT_GT(redder, last == -1 ? -256 : last) << share;
    last = redder;
  }
}

}  // namespace
}  // namespace kerf::output
