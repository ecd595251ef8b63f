// Tools in the comments of programs.
#include "machine/definition/tools/tool_comment.hpp"

#include <gtest/gtest.h>

namespace kerf::machine {
namespace {

using stock::Measure;
using stock::Tool;

Tool tool_of(std::string_view comment, int number = 0, double mm_per_unit = 1) {
  const auto tool = tool_in_comment(comment, number, mm_per_unit);
  EXPECT_TRUE(tool) << comment;
  return tool.value_or(Tool{});
}

TEST(ToolComment, OfACamSystemSaysNumberDiameterCornerAndKind) {
  const Tool tool = tool_of("T1 D=10. CR=0.5 - ZMIN=-5. - bullnose end mill");
  EXPECT_EQ(tool.number, 1);
  EXPECT_EQ(tool.type, "bull");
  EXPECT_EQ(tool.said(Measure::diameter), 10);
  EXPECT_EQ(tool.said(Measure::corner_radius), 0.5);
  EXPECT_EQ(tool.said(Measure::flute_length), std::nullopt);
  EXPECT_EQ(tool.source, stock::ToolSource::comment);
}

TEST(ToolComment, OfACamSystemNamesTheTipOfADrillAndTheSideOfAChamfer) {
  EXPECT_EQ(tool_of("T3 D=6.8 CR=0. TAPER=118DEG - ZMIN=-22. - DRILL").said(Measure::angle), 118);
  EXPECT_EQ(tool_of("T4 D=10. CR=0. TAPER=90deg - ZMIN=-2. - spot drill").said(Measure::angle), 90);
  EXPECT_EQ(tool_of("T4 D=10. CR=0. TAPER=45deg - ZMIN=-2. - chamfer mill").said(Measure::angle),
            90);
  EXPECT_EQ(tool_of("T2 D=6. CR=0. - ZMIN=-2. - flat end mill").type, "flat");
  EXPECT_EQ(tool_of("T2 D=6. CR=3. - ZMIN=-2. - ball end mill").type, "ball");
  EXPECT_EQ(tool_of("T2 D=50. CR=0. - ZMIN=-2. - face mill").type, "face");
  EXPECT_EQ(tool_of("T2 D=8. CR=0. - ZMIN=-2. - right hand tap").type, "tap");
  EXPECT_EQ(tool_of("T2 D=8. CR=0. - ZMIN=-2. - right hand tap").value(Measure::pitch), 1.25);
  EXPECT_EQ(tool_of("T2 D=6. CR=0.2 TAPER=5deg - tapered mill").said(Measure::tip_radius), 0.2);
}

TEST(ToolComment, OfAListSaysDiameterCornerAndSide) {
  EXPECT_EQ(tool_of("TOOL/MILL,10.,0.,50.,0.", 3).type, "flat");
  EXPECT_EQ(tool_of("TOOL/MILL,10.,0.,50.,0.", 3).number, 3);
  EXPECT_EQ(tool_of("tool/mill, 10, 2, 50, 0").said(Measure::corner_radius), 2);
  EXPECT_EQ(tool_of("TOOL/MILL,10,5,50,0").type, "ball");
  EXPECT_EQ(tool_of("TOOL/MILL,10,0,50,15").said(Measure::angle), 30);
  EXPECT_EQ(tool_of("TOOL/MILL,10,0,50,0").said(Measure::flute_length), std::nullopt);
}

TEST(ToolComment, InWordsNeedsAKindADiameterAndALineThatCallsTheTool) {
  EXPECT_EQ(tool_of("DRILL D6.8", 5).said(Measure::diameter), 6.8);
  EXPECT_EQ(tool_of("DRILL D6.8", 5).number, 5);
  EXPECT_EQ(tool_of("ball nose \xC3\x98"
                    "8",
                    2)
                .said(Measure::diameter),
            8);
  EXPECT_EQ(tool_of("BALL \xD8"
                    "8",
                    2)
                .type,
            "ball");
  EXPECT_EQ(tool_of("0.5 REAMER D0.5", 2, 25.4).said(Measure::diameter), 12.7);
  EXPECT_FALSE(tool_in_comment("DRILL D6.8", 0, 1));
  EXPECT_FALSE(tool_in_comment("DRILL 6.8", 5, 1));
  EXPECT_FALSE(tool_in_comment("ROUGHING D60", 5, 1));
  EXPECT_FALSE(tool_in_comment("SURFACE D60", 5, 1));
}

TEST(ToolComment, ThatMakesNoToolIsNone) {
  for (const char* comment :
       {"", "T", "D=", "T1 D=-5. CR=0. - flat end mill", "T1 D=1e99 - flat end mill",
        "T1 D=99999 - flat end mill", "TOOL/MILL,", "TOOL/MILL,,,,", "TOOL/MILL,5,9,1,1",
        "T1 D=10. CR=0. - slot mill", "T999999999999 D=10. CR=0. - flat end mill"}) {
    EXPECT_FALSE(tool_in_comment(comment, 7, 1)) << comment;
  }
}

std::vector<Tool> tools_of(const std::string& program, const CommentStyle& style = {}) {
  return tools_in_comments(*base::SourceFile::from_text("p.nc", program), style);
}

TEST(ToolComments, AreFoundInTheHeadAndOnTheLinesOfToolChanges) {
  const auto tools = tools_of(
      "%\nO1\n(T1 D=10. CR=0. - ZMIN=-5. - flat end mill)\nG21 G90\nT1 M06\nG1 X10\n"
      "N20 T2 M6 (DRILL D6.8)\n(TOOL/MILL,12,1,50,0)\nG0 X1\nT3 M6\nT3 M6 (FLAT D99)\nM30\n%");
  ASSERT_EQ(tools.size(), 3U);
  EXPECT_EQ(tools[0].number, 1);
  EXPECT_EQ(tools[1].number, 2);
  EXPECT_EQ(tools[1].type, "drill");
  EXPECT_EQ(tools[2].number, 3);
  EXPECT_EQ(tools[2].said(Measure::corner_radius), 1) << "the first one counts";
}

TEST(ToolComments, AreInTheUnitsOfTheProgramWhereverThoseAreSaid) {
  const std::string head = "(T1 D=0.5 CR=0. - flat end mill)\n";
  EXPECT_EQ(tools_of(head + "G20\n").at(0).said(Measure::diameter), 12.7);
  EXPECT_EQ(tools_of(head + "G21\n").at(0).said(Measure::diameter), 0.5);
  EXPECT_EQ(tools_of(head, {.mm_per_unit = 25.4}).at(0).said(Measure::diameter), 12.7);
  EXPECT_EQ(tools_of(head + "(G20)\n").at(0).said(Measure::diameter), 0.5);
}

TEST(ToolComments, OfALatheKnowTheOffsetInT) {
  const auto tools = tools_of("T0505 (DRILL D10)\n", {.has_offset_in_t = true});
  ASSERT_EQ(tools.size(), 1U);
  EXPECT_EQ(tools[0].number, 5);
}

TEST(ToolComments, AreFoundInLongFilesAndNotInOtherPlaces) {
  std::string program;
  for (int i = 0; i < 40000; ++i) program += "G1 X1.0 (cut)\n";
  program += "T7 M6 (REAMER D8)\n" + std::string(100000, '(') + "\nT#1 (DRILL D4)";
  const auto tools = tools_of(program);
  ASSERT_EQ(tools.size(), 1U);
  EXPECT_EQ(tools[0].number, 7);
}

}  // namespace
}  // namespace kerf::machine
