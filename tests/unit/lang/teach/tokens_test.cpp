// What a reader is shown of a line of taught points.
#include <gtest/gtest.h>

#include "lang/teach/language.hpp"

namespace kerf::teach {
namespace {

std::string cut(const std::string& line) {
  std::string text;
  for (const base::Token& token : base::tokens_of(language(), line)) {
    if (token.kind == base::TokenKind::blank) continue;
    if (!text.empty()) text += ' ';
    text += line.substr(token.begin, token.length) + "|";
    text += base::name_of(token.kind);
  }
  return text;
}

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
