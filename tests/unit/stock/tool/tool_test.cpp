// What is said of tools and what is not, and which of them cannot be.
#include "stock/tool/tool.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tool_maker.hpp"

namespace kerf::stock {
namespace {

using test::Said;
using test::tool_of;
using M = Measure;

TEST(Tool, CutsAtItsCentreWhereItsKindDoes) {
  const auto core = [](std::string_view type, Said said) {
    said.emplace_back(M::diameter, 20);
    return tool_of(type, said).core_mm();
  };
  EXPECT_EQ(core("flat", {}), 0);
  EXPECT_EQ(core("drill", {}), 0);
  EXPECT_EQ(core("face", {}), 6);
  EXPECT_EQ(core("face", {{M::core_diameter, 15}}), 7.5);
  EXPECT_EQ(core("t-slot", {{M::width, 3}, {M::neck_diameter, 8}}), 4);
  EXPECT_EQ(core("boring", {{M::width, 2}}), 8);
  EXPECT_EQ(core("thread-mill", {{M::pitch, 1}}), std::nullopt);
  Tool flat = tool_of("flat", {{M::diameter, 10}});
  flat.centre_cutting = false;
  EXPECT_EQ(flat.core_mm(), std::nullopt) << "nobody has said where it ends";
  flat.measures.set(M::core_diameter, 3);
  EXPECT_EQ(flat.core_mm(), 1.5);
}

TEST(Tool, TellsWhatIsSaidFromWhatIsUsual) {
  const Tool tool = tool_of("drill", {{M::diameter, 10}});
  EXPECT_EQ(tool.said(M::angle), std::nullopt);
  EXPECT_EQ(tool.value(M::angle), 118);
  EXPECT_EQ(tool.said(M::flute_length), std::nullopt);
  EXPECT_EQ(tool.value(M::flute_length), std::nullopt);
}

struct Impossible {
  std::string type;
  Said said;
  std::string sentence;
};

TEST(Tool, IsRefusedWhereItCannotBe) {
  const std::vector<Impossible> all = {
      {"flat", {}, "a tool of type flat needs its diameter"},
      {"flat", {{M::diameter, 0}}, "a tool of type flat needs its diameter"},
      {"saw", {{M::diameter, 9}, {M::width, 1}}, "a tool of type saw needs its neck_diameter"},
      {"ball", {{M::diameter, 9}, {M::angle, 60}}, "a tool of type ball has no angle"},
      {"flat", {{M::diameter, 1e5}}, "diameter is a number from 0 to 10000"},
      {"flat", {{M::diameter, 9}, {M::flutes, 2.5}}, "flutes is a whole number from 1 to 1000"},
      {"bull",
       {{M::diameter, 6}, {M::corner_radius, 4}},
       "corner_radius, 4, is more than half of diameter, 6"},
      {"v",
       {{M::diameter, 6}, {M::tip_diameter, 6}},
       "tip_diameter, 6, is not less than diameter, 6"},
      {"taper",
       {{M::diameter, 6}, {M::tip_diameter, 1}, {M::tip_radius, 1}},
       "a tool has tip_radius or tip_diameter, not both"},
      {"taper",
       {{M::diameter, 6}, {M::angle, 10}, {M::tip_radius, 4}},
       "tip_radius, 4, makes a ball wider than diameter, 6"},
      {"centre-drill",
       {{M::diameter, 6}, {M::pilot_diameter, 2}, {M::pilot_length, 0.5}},
       "pilot_length, 0.5, is shorter than its point of 118°, 0.6009"},
      {"reamer",
       {{M::diameter, 1}, {M::lead, 0.5}},
       "lead, 0.5, is not less than half of diameter, 1"},
      {"tap", {{M::diameter, 3}, {M::pitch, 1.5}}, "pitch, 1.5, leaves no core at diameter 3"},
      {"t-slot",
       {{M::diameter, 6}, {M::width, 1}, {M::neck_diameter, 6}},
       "neck_diameter, 6, is not less than diameter, 6"},
      {"dovetail",
       {{M::diameter, 20}, {M::angle, 45}, {M::height, 9}, {M::neck_diameter, 5}},
       "the flank crosses the neck below height, 9"},
      {"boring",
       {{M::diameter, 20}, {M::width, 11}},
       "width, 11, is more than half of diameter, 20: the ring crosses the axis"},
      {"thread-mill",
       {{M::diameter, 2}, {M::pitch, 3}},
       "pitch, 3, makes teeth that cross the axis at diameter 2"},
      {"ball",
       {{M::diameter, 10}, {M::flute_length, 3}},
       "flute_length, 3, ends where the tool has not its diameter yet: that begins at 5"},
      {"flat",
       {{M::diameter, 10}, {M::flute_length, 30}, {M::stickout, 20}},
       "stickout, 20, is less than flute_length, 30"},
      {"ball",
       {{M::diameter, 50}, {M::stickout, 20}},
       "stickout, 20, is less than the cutting part, 25"},
      {"flat", {{M::diameter, std::nan("")}}, "diameter is a number from 0 to 10000"},
  };
  for (const Impossible& each : all)
    EXPECT_EQ(objection(tool_of(each.type, each.said)), each.sentence);
}

TEST(Tool, NeedsToKnowWhereShankAndHolderBegin) {
  Tool tool = tool_of("flat", {{M::diameter, 10}});
  tool.shank = {{10, 10, 10}};
  EXPECT_EQ(objection(tool), "a shank needs flute_length: where it begins");
  tool.measures.set(M::flute_length, 20);
  EXPECT_EQ(objection(tool), "");
  tool.holder = {{10, 30, 30}};
  EXPECT_EQ(objection(tool), "a holder needs stickout: where it begins");
}

TEST(Tool, OfAFormThatIsNoBodyIsRefused) {
  const auto refusal = [](std::vector<FormPoint> points) {
    Tool tool = tool_of("form", {});
    tool.form = std::move(points);
    return objection(tool);
  };
  EXPECT_EQ(refusal({{1, 0}}), "a form tool needs a profile of two points or more");
  EXPECT_EQ(refusal({{1, 1}, {2, 2}}), "profile begins at height 0, the tip");
  EXPECT_EQ(refusal({{1, 0}, {-1, 2}}), "point 1 of profile is beyond the axis");
  EXPECT_EQ(refusal({{1, 0}, {2, 2}, {3, 1}}), "point 2 of profile is below the one before");
  EXPECT_EQ(refusal({{1, 0, -1}, {1, 4}}),
            "point 0 of profile begins an arc that crosses the axis");
  EXPECT_EQ(refusal({{4, 0, 1}, {9, 0}}),
            "point 0 of profile begins an arc that does not rise throughout");
  EXPECT_EQ(refusal({{4, 0, 3}, {4, 9}}),
            "point 0 of profile begins an arc of more than half a circle");
}

TEST(ToolKinds, AreFoundByEachOfTheirNames) {
  std::size_t names = 0;
  for (std::size_t i = 0; i < kind_rows().size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kind_rows()[i].kind), i);
    for (const std::string_view name : kind_rows()[i].names) {
      EXPECT_EQ(kind_named(name).row, &kind_rows()[i]) << name;
      ++names;
    }
  }
  EXPECT_EQ(names, 29U);
  EXPECT_EQ(kind_named("laser").row, nullptr);
}

}  // namespace
}  // namespace kerf::stock
