// Who describes a tool counts in one order; what nobody says is told.
#include "machine/definition/tools/tool_choice.hpp"

#include <gtest/gtest.h>

namespace kerf::machine {
namespace {

using stock::Measure;
using stock::Tool;
using stock::ToolKind;
using stock::ToolSource;

Tool tool_of(ToolSource source, int number, std::string_view type, double diameter) {
  Tool tool;
  tool.number = number;
  tool.source = source;
  tool.kind = stock::kind_named(type).row->kind;
  tool.type = stock::kind_named(type).name;
  if (diameter > 0) tool.measures.set(Measure::diameter, diameter);
  return tool;
}

const ToolChoice kChoice(
    {tool_of(ToolSource::comment, 1, "drill", 3), tool_of(ToolSource::file, 1, "flat", 10),
     tool_of(ToolSource::machine, 1, "flat", 11), tool_of(ToolSource::comment, 2, "drill", 4),
     tool_of(ToolSource::machine, 2, "ball", 5), tool_of(ToolSource::comment, 3, "drill", 6)});

TEST(ToolChoice, TakesTheFirstSourceThatSpeaksOfTheTool) {
  const ToolUse use{.offset_radius_mm = 7};
  EXPECT_EQ(kChoice.choose(1, use).tool.said(Measure::diameter), 10);
  EXPECT_EQ(kChoice.choose(1, use).tool.source, ToolSource::file);
  EXPECT_EQ(kChoice.choose(2, use).tool.type, "ball");
  EXPECT_EQ(kChoice.choose(3, use).tool.source, ToolSource::comment);
  const ChosenTool fourth = kChoice.choose(4, use);
  EXPECT_EQ(fourth.tool.source, ToolSource::offset);
  EXPECT_EQ(fourth.tool.said(Measure::diameter), 14);
  EXPECT_EQ(fourth.assumed, std::vector<std::string>{"T4: flat, diameter 14, as its offset says"});
}

TEST(ToolChoice, AssumesAMillOrADrillOrAnInsertWhereNobodySpeaks) {
  const ToolChoice none;
  const ChosenTool mill = none.choose(0, {});
  EXPECT_EQ(mill.tool.kind, ToolKind::flat);
  EXPECT_EQ(mill.tool.said(Measure::diameter), 6);
  EXPECT_EQ(mill.assumed,
            std::vector<std::string>{"T0: flat, diameter 6, for nothing describes it"});
  EXPECT_EQ(none.choose(7, {.cuts_only_along_axis = true}).tool.kind, ToolKind::drill);
  const ChosenTool insert = none.choose(2, {.turns = true});
  EXPECT_EQ(insert.tool.kind, ToolKind::turning);
  EXPECT_EQ(insert.tool.said(Measure::nose_radius), 0.4);
  EXPECT_EQ(insert.tool.value(Measure::tip_angle), 80);
  EXPECT_EQ(insert.tool.said(Measure::tip), 3);
  EXPECT_EQ(none.choose(2, {.turns = true, .offset_nose_mm = 0.8, .offset_tip = 2})
                .tool.said(Measure::nose_radius),
            0.8);
}

TEST(ToolChoice, KeepsTheLengthOfADescriptionWithoutAShape) {
  Tool length = tool_of(ToolSource::file, 3, "flat", 0);
  length.type = {};
  length.measures.set(Measure::length, 120);
  length.name = "long one";
  const ToolChoice choice({length, tool_of(ToolSource::comment, 3, "drill", 6)});
  const Tool tool = choice.choose(3, {}).tool;
  EXPECT_EQ(tool.kind, ToolKind::drill);
  EXPECT_EQ(tool.said(Measure::length), 120);
  EXPECT_EQ(tool.name, "long one");
  EXPECT_EQ(ToolChoice({length}).choose(3, {}).tool.said(Measure::length), 120);
}

TEST(ToolChoice, TellsWhatIsOnlyUsual) {
  EXPECT_EQ(kChoice.choose(3, {}).assumed, std::vector<std::string>{"T3: angle 118, as is usual"});
  Tool typeless = tool_of(ToolSource::file, 1, "flat", 8);
  typeless.type = {};
  EXPECT_EQ(ToolChoice({typeless}).choose(1, {}).assumed,
            std::vector<std::string>{"T1: type flat, for none is said"});
}

TEST(ToolChoice, GivesAnInsertTheNoseOfItsOffsetWhereItsOwnIsNotSaid) {
  const ToolChoice choice({tool_of(ToolSource::file, 1, "turning", 0)});
  const ToolUse use{.turns = true, .offset_nose_mm = 1.2, .offset_tip = 4};
  EXPECT_EQ(choice.choose(1, use).tool.said(Measure::nose_radius), 1.2);
  EXPECT_EQ(choice.choose(1, use).tool.said(Measure::tip), 4);
}

}  // namespace
}  // namespace kerf::machine
