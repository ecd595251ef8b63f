// [[tool]] and [[holder]]: what they say arrives, what is wrong with them has its line.
#include "machine/definition/tools/tool_tables.hpp"

#include <gtest/gtest.h>

#include "machine/definition/tools/tool_text.hpp"

namespace kerf::machine {
namespace {

using stock::Measure;
using stock::Tool;
using stock::ToolKind;

base::Outcome<std::vector<ToolEntry>> read(const std::string& text) {
  return read_tool_tables(toml::parse(text), "t.toml", stock::ToolSource::file);
}

Tool only_tool(const std::string& text) {
  const auto entries = read(text);
  EXPECT_TRUE(entries) << entries.error().message;
  return entries && entries->size() == 1 ? entries->front().tool : Tool{};
}

std::string refusal(const std::string& text) {
  const auto entries = read(text);
  return entries ? "" : entries.error().message;
}

constexpr const char* kWhole = R"(
[[tool]]
number = 5
type = "bull"
name = "rougher"
comment = "for steel"
diameter = 12
length = 101.5
corner_radius = 2
flute_length = 26
flutes = 4
stickout = 45
centre_cutting = true
hand = "left"
material = "carbide"
shank  = [ {height = 60, diameter = 12} ]
holder = [ {height = 25, lower = 30, upper = 40}, {height = 40, diameter = 63} ]
limits = {fz = 0.12, ap = 12, ae = 12, vc = 400, ramp_deg = 5}
)";

TEST(ToolTables, SayAllThatATableSays) {
  const Tool tool = only_tool(kWhole);
  EXPECT_EQ(tool.number, 5);
  EXPECT_EQ(tool.kind, ToolKind::bull);
  EXPECT_EQ(tool.name, "rougher");
  EXPECT_EQ(tool.comment, "for steel");
  EXPECT_EQ(tool.material, "carbide");
  EXPECT_EQ(tool.said(Measure::length), 101.5);
  EXPECT_EQ(tool.said(Measure::corner_radius), 2);
  EXPECT_EQ(tool.said(Measure::flutes), 4);
  EXPECT_EQ(tool.hand, stock::Hand::left);
  EXPECT_EQ(tool.centre_cutting, true);
  EXPECT_EQ(tool.shank, (std::vector<stock::Segment>{{60, 12, 12}}));
  EXPECT_EQ(tool.holder, (std::vector<stock::Segment>{{25, 30, 40}, {40, 63, 63}}));
  EXPECT_EQ(tool.limits.fz, 0.12);
  EXPECT_EQ(tool.limits.ramp_deg, 5);
  EXPECT_EQ(tool.source, stock::ToolSource::file);
  EXPECT_EQ(stock::profile_of(tool).height(), 110);
}

TEST(ToolTables, ShareHoldersByName) {
  const std::string holder =
      "[[holder]]\nname = \"ER32\"\nsegments = [ {height = 50, diameter = 63} ]\n";
  const std::string tool =
      "[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 6\nstickout = 30\n"
      "holder_name = \"ER32\"\n";
  EXPECT_EQ(only_tool(tool + holder).holder, (std::vector<stock::Segment>{{50, 63, 63}}));
  EXPECT_EQ(refusal(tool), "t.toml:6: there is no [[holder]] of the name ER32");
  EXPECT_EQ(refusal(holder + holder), "t.toml:4: there are two holders of the name ER32");
}

TEST(ToolTables, TakeAToolWithoutATypeForFlatOrForAnInsert) {
  const Tool mill = only_tool("[[tool]]\nnumber = 5\ndiameter = 12\ncorner_radius = 1\n");
  EXPECT_TRUE(mill.type.empty());
  EXPECT_EQ(stock::profile_of(mill).radius_at(0.5), 5 + std::sqrt(0.75));
  EXPECT_EQ(only_tool("[[tool]]\nnumber = 5\nnose_radius = 0.4\ntip = 2\n").kind,
            ToolKind::turning);
  EXPECT_NE(stock::objection(only_tool("[[tool]]\nnumber = 5\nlength = 100\n")), "");
}

TEST(ToolTables, SayTheOutlineOfAFormTool) {
  const Tool tool = only_tool(
      "[[tool]]\nnumber = 9\ntype = \"form\"\n"
      "profile = [[4, 0], [4, 3, -0.2], [6, 8], [6, 20]]\ncutting = [0, 2]\n");
  ASSERT_EQ(tool.form.size(), 4U);
  EXPECT_EQ(tool.form[1], (stock::FormPoint{4, 3, -0.2}));
  EXPECT_EQ(stock::profile_of(tool).edge_height(), 8);
}

TEST(ToolTables, SayAnInsertByItsDesignation) {
  const Tool tool =
      only_tool("[[tool]]\nnumber = 1\ntype = \"turning\"\ninsert = \"DCMT11T304\"\nic = 40\n");
  EXPECT_EQ(tool.said(Measure::nose_radius), 0.4);
  EXPECT_EQ(tool.said(Measure::ic), 40);
  EXPECT_EQ(tool.value(Measure::tip), 3);
  EXPECT_EQ(tool.said(Measure::tip), std::nullopt);
}

struct Wrong {
  std::string lines;
  std::string sentence;
};

TEST(ToolTables, TellWhatIsWrongWithItsLine) {
  const std::vector<Wrong> all = {
      {"colour = 1", "3: a tool has no key colour"},
      {"type = \"hammer\"", "3: there is no type hammer of tools; docs/tools.md has them all"},
      {"type = 5", "3: a text is expected"},
      {"diameter = \"ten\"", "3: a number is expected"},
      {"diameter = true", "3: a number is expected"},
      {"diameter = nan", "3: a number is expected"},
      {"diameter = -1", "3: a number from 0 to 10000 is expected"},
      {"flutes = 2.5", "3: a whole number from 1 to 1000 is expected"},
      {"type = \"ball\"", "1: a tool of type ball needs its diameter"},
      {"type = \"bull\"\ndiameter = 6\ncorner_radius = 4",
       "5: corner_radius, 4, is more than half"},
      {"type = \"saw\"\ndiameter = 6\nwidth = 1\nneck_diameter = 6", "6: neck_diameter, 6, is not"},
      {"diameter = 6\nflute_length = 20\nstickout = 9",
       "5: stickout, 9, is less than flute_length"},
      {"diameter = 6\nholder = [ {height = 5} ]", "4: a segment needs its lower"},
      {"diameter = 6\nholder = [ {height = 0, diameter = 1} ]", "4: height is a number above 0"},
      {"diameter = 6\nholder = [ {height = 1, diameter = 1, lower = 2} ]", "4: a segment has"},
      {"diameter = 6\nholder = [ {height = 1, width = 1} ]", "4: a segment has no key width"},
      {"diameter = 6\nshank = 5", "4: a list of segments is expected"},
      {"diameter = 6\nlimits = {fz = 0}", "4: a limit is above 0"},
      {"diameter = 6\nlimits = {speed = 5}", "4: limits has no key speed"},
      {"hand = \"both\"", "3: hand is right or left"},
      {"centre_cutting = 1", "3: true or false is expected"},
      {"type = \"form\"\nprofile = [[1]]", "4: [r, height] or [r, height, bulge] is expected"},
      {"type = \"form\"\nprofile = [[1, 0], [2, 1]]\ncutting = [0, 2]", "5: cutting is two points"},
      {"type = \"form\"\nprofile = [[1, 0], [2, 1]]\ncutting = [-1, 2]", "5: [from, to]"},
      {"type = \"turning\"\ninsert = \"QNMG120408\"",
       "4: insert \"QNMG120408\": there is no shape"},
  };
  for (const Wrong& each : all) {
    const std::string sentence = "t.toml:" + each.sentence;
    EXPECT_EQ(refusal("[[tool]]\nnumber = 1\n" + each.lines + "\n").substr(0, sentence.size()),
              sentence);
  }
}

TEST(ToolTables, ReadTheToolsThatHaveBeenWrittenAsTheyWere) {
  Tool form;
  form.number = 3;
  form.kind = ToolKind::form;
  form.type = "form";
  form.name = "a \"b\" \\ \n \x01 \xC3\x98";
  form.form = {{1, 0, 0}, {2, 0.1 + 0.2, -0.25}, {2.5, 7, 0}};
  form.cutting = stock::FormCutting{0, 1};
  form.centre_cutting = false;
  Tool insert =
      only_tool("[[tool]]\nnumber = 1\ntype = \"turning\"\ninsert = \"DCMT11T304\"\nic = 40\n");
  const std::vector<Tool> tools = {only_tool(kWhole), form, insert};
  const auto entries = read(tools_as_toml(tools));
  ASSERT_TRUE(entries) << entries.error().message;
  ASSERT_EQ(entries->size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ((*entries)[i].tool, tools[i]) << i;
}

TEST(ToolTables, NeedNumbersThatTellToolsApart) {
  EXPECT_EQ(refusal("[[tool]]\ndiameter = 5\n"), "t.toml:1: a tool needs its number");
  EXPECT_EQ(refusal("[[tool]]\nnumber = 0\n"), "t.toml:2: there is no tool 0");
  EXPECT_EQ(refusal("[[tool]]\nnumber = 1.5\n"), "t.toml:2: there is no tool of this number");
  EXPECT_EQ(refusal("[[tool]]\nnumber = 1\n[[tool]]\nnumber = 1\n"),
            "t.toml:3: tool 1 is there twice");
}

}  // namespace
}  // namespace kerf::machine
