#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "face/server/hub/commands.hpp"
#include "face/server/hub/handlers.hpp"
#include "face/server/hub/protocol_page.hpp"
#include "face/server/protocol/state_document.hpp"

namespace kerf::server {
namespace {

std::string objection(const char* command, const char* json) {
  const auto checked =
      check_arguments(Json::parse(json), find_command(command)->arguments, {"id", "do"});
  return checked ? "" : checked.error().message;
}

TEST(Protocol, EveryCommandOfTheTableIsServedAndNoOther) {
  for (const Handlers* const table : {&hub_handlers(), &panel_handlers(), &memory_handlers(),
                                      &view_handlers(), &library_handlers(), &training_handlers()})
    for (const auto& [name, handler] : *table) EXPECT_NE(find_command(name), nullptr) << name;
  std::set<std::string_view> names;
  for (const Command& command : commands()) {
    EXPECT_NE(find_handler(command.name), nullptr) << command.name;
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
    EXPECT_TRUE(command.sentence.ends_with('.')) << command.name;
  }
}

TEST(Protocol, ItsPageNamesEveryCommandAndArgument) {
  const std::string page = protocol_markdown();
  for (const Command& command : commands()) {
    EXPECT_NE(page.find("| `" + std::string(command.name) + "` |"), std::string::npos)
        << command.name;
    for (const Argument& argument : command.arguments)
      EXPECT_NE(page.find("`" + std::string(argument.name) + "`"), std::string::npos)
          << argument.name;
  }
}

TEST(Arguments, NumbersKeepTheirRange) {
  EXPECT_EQ(objection("override", R"({"feed":0})"), "");
  EXPECT_EQ(objection("override", R"({"feed":200,"rapid":100,"spindle":50})"), "");
  for (const char* wrong : {R"({"feed":-1})", R"({"feed":200.001})", R"({"feed":"1"})",
                            R"({"feed":null})", R"({"feed":true})", R"({"feed":[1]})"})
    EXPECT_NE(objection("override", wrong).find("feed must be a number 0 to 200"),
              std::string::npos)
        << wrong;
}

TEST(Arguments, WholeNumbersAreWhole) {
  EXPECT_EQ(objection("start-at", R"({"line":12})"), "");
  EXPECT_EQ(objection("start-at", R"({"line":12.0})"), "");
  for (const char* wrong : {R"({"line":12.5})", R"({"line":0})", R"({"line":4294967296})"})
    EXPECT_NE(objection("start-at", wrong), "") << wrong;
}

TEST(Arguments, WhatIsMissingOrUnknownIsNamed) {
  EXPECT_NE(objection("mdi", R"({"id":1,"do":"mdi"})").find("text is missing"), std::string::npos);
  EXPECT_NE(objection("mdi", R"({"text":"G0","more":1})").find("no argument more"),
            std::string::npos);
  EXPECT_EQ(objection("machines", R"({"id":1,"do":"machines"})"), "");
}

TEST(Arguments, TextsAndListsAreBounded) {
  EXPECT_NE(check_arguments({{"text", std::string(4097, 'x')}}, find_command("mdi")->arguments)
                .has_value(),
            true);
  EXPECT_TRUE(check_arguments({{"text", std::string(4096, 'x')}}, find_command("mdi")->arguments));
  Json many = Json::array();
  for (std::size_t i = 0; i <= machine::kMostEntries; ++i) many.push_back(1);
  EXPECT_FALSE(check_arguments({{"levels", many}}, find_command("block-skip")->arguments));
}

TEST(Arguments, ObjectsInListsAreHeldAgainstTheirOwnArguments) {
  EXPECT_EQ(objection("breakpoints", R"({"list":[{"file":"a.nc","line":3},{"variable":"#1"}]})"),
            "");
  EXPECT_NE(objection("breakpoints", R"({"list":[{"line":"3"}]})").find("list: line must be"),
            std::string::npos);
  EXPECT_NE(objection("breakpoints", R"({"list":[3]})"), "");
  EXPECT_NE(objection("breakpoints", R"({"list":[{"lines":3}]})").find("no argument lines"),
            std::string::npos);
}

TEST(StateDocument, AnEventHasOnlyWhatHasChangedSince) {
  StateDocument document;
  document.update({{"a", 1}, {"b", {{"x", 1}}}});
  const std::uint64_t first = document.revision();
  EXPECT_EQ(Json::parse(document.event_since(0, "m")),
            Json::parse(R"({"event":"state","machine":"m","a":1,"b":{"x":1}})"));
  document.update({{"a", 1}, {"b", {{"x", 1}}}});
  EXPECT_EQ(document.revision(), first);
  document.update({{"a", 1}, {"b", {{"x", 2}}}});
  document.update({{"a", 3}, {"b", {{"x", 2}}}});
  EXPECT_EQ(Json::parse(document.event_since(first, "m")),
            Json::parse(R"({"event":"state","machine":"m","a":3,"b":{"x":2}})"));
  EXPECT_EQ(Json::parse(document.event_since(first + 1, "m")),
            Json::parse(R"({"event":"state","machine":"m","a":3})"));
}

TEST(StateDocument, AValueThatIsNoJsonNumberIsNull) {
  StateDocument document;
  document.update({{"a", std::numeric_limits<double>::quiet_NaN()}});
  EXPECT_TRUE(Json::parse(document.event_since(0, "m"))["a"].is_null());
}

}  // namespace
}  // namespace kerf::server
