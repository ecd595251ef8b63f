// What a reader is shown of a line of taught points.
#include <gtest/gtest.h>

#include "lang/teach/language.hpp"
#include "tokens_of_line.hpp"

namespace kerf::teach {
namespace {

std::string cut(const std::string& line) { return test::tokens_of_line(language(), line); }

TEST(TeachTokens, AreRecordsNumbersAndNames) {
  EXPECT_EQ(cut("POINT 1,-2.5 3 90 55.6 end ; there"),
            "POINT|command 1|number -2.5|number 3|number 90|number 55.6|number end|label ; "
            "there|comment");
  EXPECT_EQ(cut("laser on 40%;x"), "laser|keyword on|keyword 40%|number ;x|comment");
}

TEST(TeachTokens, WhatIsNoneIsAnError) {
  EXPECT_EQ(cut("GOTO 5"), "GOTO|error 5|error");
  EXPECT_EQ(cut("FEED fast 5"), "FEED|keyword fast|error 5|error");
}

}  // namespace
}  // namespace kerf::teach
