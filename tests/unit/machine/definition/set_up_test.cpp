#include "machine/definition/set_up.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace kerf::machine {
namespace {

SetUp read(const std::string& text) {
  const auto set_up = read_set_up(text, "jobs/vice.toml");
  EXPECT_TRUE(set_up) << set_up.error().message;
  return set_up.value_or(SetUp{});
}

std::string wrong(const std::string& text) {
  const auto set_up = read_set_up(text, "vice.toml");
  if (set_up) return "it was read";
  EXPECT_EQ(set_up.error().kind, base::Failure::Kind::input);
  return set_up.error().message;
}

TEST(SetUpFile, SaysWhatItsTablesSay) {
  const auto set_up = read(R"(
[stock]
shape = "box:0,0,-20,100,60,0"
zero = "G55"
place = [1, 2, 3, 0, 0, 180]
[[fixture]]
shape = "box:-40,0,-30,0,60,-10"
name = "jaw"
[[fixture]]
shape = "cylinder:Z,120,30,-30,0,20"
[material]
kc11 = 1700
mc = 0.25
[checks]
touch_mm = 0.02
no_check = ["TOOL_LENGTH"]
fail_on = "error"
lengths = "real"
[design]
file = "part.stl"
place = "0,0,1"
tolerance = 0.1
[[tool]]
number = 5
type = "ball"
diameter = 6
)");
  ASSERT_EQ(set_up.tools.size(), 1U);
  EXPECT_EQ(set_up.tools[0].number, 5);
  ASSERT_TRUE(set_up.stock && set_up.zero && set_up.place && set_up.material && set_up.design);
  EXPECT_DOUBLE_EQ(stock::volume(std::get<stock::Workpiece>(set_up.stock->word)), 120000);
  EXPECT_EQ(name_of(*set_up.zero), "G55");
  EXPECT_EQ(*set_up.place, (stock::Placement{{1, 2, 3}, {0, 0, 180}}));
  ASSERT_EQ(set_up.fixtures.size(), 2U);
  EXPECT_EQ(set_up.fixtures[0].title(), "jaw");
  EXPECT_EQ(set_up.fixtures[1].title(), "cylinder:Z,120,30,-30,0,20");
  EXPECT_EQ(set_up.material->kc11, 1700);
  EXPECT_EQ(set_up.touch_mm, 0.02);
  EXPECT_EQ(set_up.left_out, std::vector{base::Code::tool_length});
  EXPECT_EQ(set_up.fail_on, FailOn::error);
  EXPECT_EQ(set_up.has_real_lengths, true);
  EXPECT_EQ(set_up.design->file.path, "jobs/part.stl");
  EXPECT_EQ(set_up.design->place, (stock::Placement{{0, 0, 1}, {}}));
  EXPECT_EQ(set_up.design->tolerance_mm, 0.1);
}

TEST(SetUpFile, FilesLieBesideItAndHaveAUnit) {
  const auto set_up = read(
      "[stock]\nshape = \"raw.stl\"\nunit = \"inch\"\n[[fixture]]\nshape = \"/vices/jaw.stl\"\n");
  const auto& raw = std::get<StockFile>(set_up.stock->word);
  EXPECT_EQ(raw.path, "jobs/raw.stl");
  EXPECT_EQ(raw.unit, MeshUnit::inch);
  EXPECT_EQ(set_up.stock->said, "raw.stl");
  const auto& jaw = std::get<StockFile>(set_up.fixtures[0].word);
  EXPECT_EQ(jaw.path, "/vices/jaw.stl");
  EXPECT_EQ(jaw.unit, MeshUnit::mm);
  EXPECT_EQ(set_up.files(), (std::vector<std::string>{"jobs/raw.stl", "/vices/jaw.stl"}));
}

TEST(SetUpFile, OfNothingIsNothing) {
  const auto set_up = read("# nothing\n");
  EXPECT_FALSE(set_up.stock || set_up.zero || set_up.place || set_up.material || set_up.design);
  EXPECT_TRUE(set_up.fixtures.empty() && set_up.left_out.empty() && set_up.files().empty());
}

TEST(SetUpFile, WhatIsWrongHasItsLineAndColumn) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"[stock]\nshape = \"box:0,0,0\"\n",
       "vice.toml:2:9: shape box:0,0,0: box:X0,Y0,Z0,X1,Y1,Z1 takes six numbers"},
      {"[stock]\n  shap = \"box:0,0,0,1,1,1\"\n",
       "vice.toml:2:3: [stock] has no key shap: shape, zero, place, unit are there"},
      {"[stocks]\n",
       "vice.toml:1:2: there is no table stocks: stock, fixture, material, checks, design and "
       "tool are there"},
      {"[stock]\nshape = 5\n", "vice.toml:2:9: shape is a text"},
      {"[stock]\nzero = \"G60\"\n",
       "vice.toml:2:8: zero G60: G54 to G59, G54.1P1 to G54.1P300, machine or auto is expected"},
      {"[stock]\nplace = [1, 2]\n",
       "vice.toml:2:9: place is [X, Y, Z] or [X, Y, Z, A, B, C], mm and degrees"},
      {"[stock]\nplace = [1, 2, nan]\n",
       "vice.toml:2:16: each of place is a number from -100000 to 100000"},
      {"[stock]\nshape = \"extents\"\nunit = \"inch\"\n",
       "vice.toml:3:8: unit is that of an STL file"},
      {"[fixture]\nshape = \"box:0,0,0,1,1,1\"\n",
       "vice.toml:1:1: [[fixture]] tables are expected"},
      {"[[fixture]]\nname = \"jaw\"\n", "vice.toml:1:1: a fixture needs its shape"},
      {"[material]\ngroup = \"X\"\n",
       "vice.toml:2:9: group X: one of P, M, K, N, S, H is expected, or kc11,mc: N/mm² above 0 and "
       "an exponent from 0 to below 1"},
      {"[material]\nkc11 = 1700\n", "vice.toml:1:1: [material] has group, or kc11 and mc"},
      {"[checks]\ntouch_mm = 5\n", "vice.toml:2:12: touch_mm is a number from 0.001 to 1"},
      {"[checks]\nno_check = [\"TOOL_LENGTH\", \"NONE\"]\n",
       "vice.toml:2:28: no_check NONE: no check of stock has this code"},
      {"[checks]\nfail_on = \"always\"\n",
       "vice.toml:2:11: fail_on always: error, warning or never is expected"},
      {"[design]\ntolerance = 1\n", "vice.toml:1:1: a design needs its file"},
      {"stock = 1\n", "vice.toml:1:9: [stock] must be a table"},
  };
  for (const auto& [text, sentence] : cases) EXPECT_EQ(wrong(text), sentence) << text;
  EXPECT_TRUE(wrong("[stock\n").starts_with("vice.toml:1:7: ")) << wrong("[stock\n");
}

TEST(SetUpFile, WhatCountsMoreIsTakenOneThingAtATime) {
  auto file = read(
      "[stock]\nshape = \"box:0,0,0,1,1,1\"\nzero = \"G56\"\n[[fixture]]\nshape = "
      "\"box:0,0,0,1,1,1\"\n[checks]\nno_check = [\"TOOL_LENGTH\"]\nfail_on = \"never\"\n");
  auto words = read(
      "[stock]\nshape = \"box:0,0,0,2,2,2\"\n[[fixture]]\nshape = \"box:0,0,0,3,3,3\"\n[checks]\n"
      "no_check = [\"CUT_DEPTH\"]\n");
  const auto both = joined(std::move(words), std::move(file));
  EXPECT_EQ(both.stock->said, "box:0,0,0,2,2,2");
  EXPECT_EQ(name_of(*both.zero), "G56");
  ASSERT_EQ(both.fixtures.size(), 2U);
  EXPECT_EQ(both.fixtures[0].said, "box:0,0,0,1,1,1");
  EXPECT_EQ(both.left_out.size(), 2U);
  EXPECT_EQ(both.fail_on, FailOn::never);
}

}  // namespace
}  // namespace kerf::machine
