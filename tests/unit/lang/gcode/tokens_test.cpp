// What a reader is shown of a line of G-code.
#include <gtest/gtest.h>

#include "lang/gcode/language.hpp"
#include "tokens_of_line.hpp"

namespace kerf::gcode {
namespace {

std::string cut(const std::string& line) { return test::tokens_of_line(language(), line); }

TEST(GcodeTokens, WordsNeedNoBlanks) {
  EXPECT_EQ(cut("N10G90G01X-10.5Y.5F200M08"),
            "N10|sequence G90|command G01|command X-10.5|dimension Y.5|dimension F200|technology "
            "M08|switching");
}

TEST(GcodeTokens, PiecesOfAWordHaveItsKind) {
  EXPECT_EQ(cut("G 0 0 X(a)1 0."),
            "G|command 0|command 0|command X|dimension (a)|comment 1|dimension 0.|dimension");
}

TEST(GcodeTokens, StatementsHaveOperatorsGluedToVariables) {
  EXPECT_EQ(cut("IF[#33GE#13]GOTO2"),
            "IF|keyword [|operator #33|variable GE|operator #13|variable ]|operator GOTO|keyword "
            "2|target");
  EXPECT_EQ(
      cut("WH[#1LT6]DO1"),
      "WH|keyword [|operator #1|variable LT|operator 6|number ]|operator DO|keyword 1|number");
  EXPECT_EQ(cut("#1=#2MOD3AND#4"),
            "#1|variable =|operator #2|variable MOD|operator 3|number AND|operator #4|variable");
}

TEST(GcodeTokens, FunctionsAreNoAxes) {
  EXPECT_EQ(cut("X[#18*COS[#31]]Y1"),
            "X|dimension [|operator #18|variable *|operator COS|function [|operator #31|variable "
            "]|operator ]|operator Y1|dimension");
  EXPECT_EQ(cut("#1=PO[2,3]"),
            "#1|variable =|operator PO|function [|operator 2|number ,|operator "
            "3|number ]|operator");
}

TEST(GcodeTokens, SlashesSkipABlockOrDivide) {
  EXPECT_EQ(cut("/2 N5 G00 /X1"), "/2|skip N5|sequence G00|command /|skip X1|dimension");
  EXPECT_EQ(cut("#1=#2/2"), "#1|variable =|operator #2|variable /|operator 2|number");
}

TEST(GcodeTokens, CommentsEndWithTheirBracketOrTheLine) {
  EXPECT_EQ(cut("G00 (TO; THE CORNER) X1."), "G00|command (TO; THE CORNER)|comment X1.|dimension");
  EXPECT_EQ(cut("(OPEN; X1"), "(OPEN; X1|comment");
}

TEST(GcodeTokens, ProgramsBeginAnywhereOutsideOfBrackets) {
  EXPECT_EQ(cut("%PART 7"), "%PART 7|program");
  EXPECT_EQ(cut("O 12 N5"), "O|program 12|program N5|sequence");
  EXPECT_EQ(cut("G00O5G01"), "G00|command O5|program G01|command");
  EXPECT_EQ(cut("<PART-1>X1"), "<PART-1>|program X1|dimension");
  EXPECT_EQ(cut("X1;:7"), "X1|dimension ;|operator :7|program");
  EXPECT_EQ(cut("DPRNT[O5]"), "DPRNT|keyword [|operator O5|text ]|operator");
}

TEST(GcodeTokens, ListsHoldTextAndVariables) {
  EXPECT_EQ(cut("DPRNT[X*#101[53]*OK]"),
            "DPRNT|keyword [|operator X*|text #101|variable [|operator 53|number ]|operator "
            "*OK|text ]|operator");
  EXPECT_EQ(cut("SETVN101[ALPHA,B_2]"),
            "SETVN|keyword 101|number [|operator ALPHA|text ,|operator B_2|text ]|operator");
}

TEST(GcodeTokens, VariablesHaveNames) {
  EXPECT_EQ(cut("[#_ABSMT[1]]=[#WIDTH]"),
            "[|operator #_ABSMT|variable [|operator 1|number ]|operator ]|operator =|operator "
            "[|operator #WIDTH|variable ]|operator");
}

TEST(GcodeTokens, GoOnBehindAMistake) {
  EXPECT_EQ(cut("G01 ? X1"), "G01|command ?|error X1|dimension");
  EXPECT_EQ(cut("X1\xC2\xB0Y2"), "X1|dimension \xC2\xB0|error Y2|dimension");
  EXPECT_EQ(cut("5 X1"), "5|error X1|dimension");
  EXPECT_EQ(cut("#1=5 X10"), "#1|variable =|operator 5|number X10|dimension");
  EXPECT_EQ(cut("X1.2.3"), "X1.2|dimension .3|error");
}

}  // namespace
}  // namespace kerf::gcode
