// What the help says of dialects and their machines.
#include "face/cli/dialect_choice.hpp"

#include <gtest/gtest.h>

namespace kerf::cli {
namespace {

TEST(DialectChoice, HelpNamesTheMachinesOfTextsOnce) {
  EXPECT_EQ(
      usual_machines(),
      "mill3, lathe2 for fanuc-lathe, laser3 for laser-basic, laser5 for teach, mill3 for motion");
  EXPECT_EQ(dialect_list(), "fanuc-mill, fanuc-lathe, laser-basic, teach, motion");
}

}  // namespace
}  // namespace kerf::cli
