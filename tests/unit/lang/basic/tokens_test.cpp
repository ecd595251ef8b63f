// What a reader is shown of a line of laser BASIC.
#include <gtest/gtest.h>

#include "lang/basic/language.hpp"
#include "tokens_of_line.hpp"

namespace kerf::basic {
namespace {

std::string cut(const std::string& line) { return test::tokens_of_line(language(), line); }

TEST(BasicTokens, AreStatementsFunctionsVariablesAndTexts) {
  EXPECT_EQ(cut("if i=0 then move(COS(a),0); print \"x"),
            "if|keyword i|variable =|operator 0|number then|keyword move|command (|operator "
            "COS|function (|operator a|variable )|operator ,|operator 0|number )|operator "
            ";|operator print|keyword \"x|text");
}

TEST(BasicTokens, CommandsAreAllThatMoveOrBurn) {
  EXPECT_EQ(cut("wait(1); burn(2)"),
            "wait|command (|operator 1|number )|operator ;|operator burn|command (|operator "
            "2|number )|operator");
  EXPECT_EQ(cut("PULSE(1,2); air(0)"),
            "PULSE|command (|operator 1|number ,|operator 2|number )|operator ;|operator "
            "air|command (|operator 0|number )|operator");
}

TEST(BasicTokens, LabelsStandAtTheHeadAndTargetsBehindJumps) {
  EXPECT_EQ(cut("koch: gosub koch ' again"),
            "koch|label :|operator gosub|keyword koch|target ' again|comment");
  EXPECT_EQ(cut("100 if a then 100 else 200"),
            "100|label if|keyword a|variable then|keyword 100|target else|keyword 200|target");
  EXPECT_EQ(cut("a=1 : rem no"), "a|variable =|operator 1|number :|operator rem no|comment");
}

TEST(BasicTokens, WhatIsNoneIsAnError) {
  EXPECT_EQ(cut("a = 1x"), "a|variable =|operator 1x|error");
}

}  // namespace
}  // namespace kerf::basic
