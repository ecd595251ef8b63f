#include "machine/panel/operation_table.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "base/decimal.hpp"
#include "machine/dialect/refused.hpp"

namespace kerf::machine {
namespace {

using Read = base::Outcome<Operation>;
using Need = Argument::Need;

constexpr Range kLines{1, argument::kMostLine};
constexpr std::array<std::string_view, 3> kSteps = {"over", "into", "out"};  // as in Step

template <typename Key>
Read pressed(const Arguments& /*arguments*/) {
  return Key{};
}

std::optional<int> percent(const Arguments& arguments, const char* name) {
  if (!arguments.has(name)) return std::nullopt;
  return static_cast<int>(arguments.integer(name));
}

std::uint32_t line_of(const Arguments& arguments) {
  return static_cast<std::uint32_t>(arguments.integer("line"));
}

std::optional<std::size_t> level_of(const Arguments& arguments) {
  if (!arguments.has("level")) return std::nullopt;
  return static_cast<std::size_t>(arguments.integer("level"));
}

Read read_mode(const Arguments& a) { return SetMode{*mode_named(a.text("mode"))}; }

Read read_switch(const Arguments& a) {
  return TurnSwitch{*switch_named(a.text("switch")), a.flag("on")};
}

Read read_block_skip(const Arguments& a) { return SetBlockSkip{bits_of(a.integers("levels"))}; }

Read read_override(const Arguments& a) {
  return SetDials{percent(a, "feed"), percent(a, "rapid"), percent(a, "spindle")};
}

Read read_jog(const Arguments& a) {
  const double speed = a.number("speed_mm_min");
  if (speed == 0) return refused("jog: a speed of 0 moves nothing");
  if (!a.has("distance_mm")) return Jog{a.text("axis"), speed};
  return JogBy{a.text("axis"), std::copysign(a.number("distance_mm"), speed), std::abs(speed)};
}

Read read_mdi(const Arguments& a) { return EnterBlocks{a.text("text")}; }

Read read_enter(const Arguments& a) { return EnterLine{a.text("text")}; }

Read read_step(const Arguments& a) {
  const std::string how = a.text("how");
  const auto* const found = std::find(kSteps.begin(), kSteps.end(), how);
  if (found == kSteps.end()) return StepBack{};
  return TakeStep{static_cast<Step>(found - kSteps.begin())};
}

Read read_run_to(const Arguments& a) { return RunTo{a.text("file"), line_of(a)}; }

Read read_start_at(const Arguments& a) { return StartAt{line_of(a)}; }

Read read_breakpoints(const Arguments& a) {
  SetBreakpoints all;
  for (const Arguments& entry : a.list("list")) {
    if (entry.has("line") == entry.has("variable"))
      return refused("breakpoints: each has either a line or a variable");
    all.list.push_back(breakpoint_of(entry));
  }
  return all;
}

Read read_variable(const Arguments& a) {
  const double value = a.nullable("value");
  return SetVariable{a.text("name"), std::isnan(value) ? std::nullopt : std::optional(value),
                     level_of(a)};
}

Read read_input(const Arguments& a) {
  return SetInput{"#" + std::to_string(a.integer("input")), a.number("value")};
}

Read read_offset(const Arguments& a) {
  return SetOffset{a.text("offset"), a.text("axis"), a.number("value")};
}

Read read_measured(const Arguments& a) {
  return MeasureOffset{a.integer("number"), a.text("axis"), a.number("reads")};
}

std::vector<OperationRow> make_table() {
  using namespace argument;
  return {
#define ARGUMENTS(...) \
  { __VA_ARGS__ }
#define OPERATION(name, arguments, sentence, read) {name, arguments, sentence, read},
#include "machine/panel/operations.def"
#undef ARGUMENTS
#undef OPERATION
  };
}

// The other way round.

Json word(const char* name) { return {{"do", name}}; }

Json write(const SetMode& key) {
  return {{"do", "mode"}, {"mode", std::string(name_of(key.mode))}};
}
Json write(const CycleStart& /*key*/) { return word("cycle-start"); }
Json write(const FeedHold& /*key*/) { return word("feed-hold"); }
Json write(const Reset& /*key*/) { return word("reset"); }
Json write(const Interrupt& /*key*/) { return word("interrupt"); }
Json write(const TurnSwitch& key) {
  return {{"do", "switch"}, {"switch", std::string(name_of(key.which))}, {"on", key.on}};
}
Json write(const SetBlockSkip& key) {
  return {{"do", "block-skip"}, {"levels", levels_of(key.levels)}};
}
Json write(const SetDials& key) {
  Json json = word("override");
  if (key.feed) json["feed"] = *key.feed;
  if (key.rapid) json["rapid"] = *key.rapid;
  if (key.spindle) json["spindle"] = *key.spindle;
  return json;
}
Json write(const Jog& key) {
  return {{"do", "jog"}, {"axis", key.axis}, {"speed_mm_min", key.speed_per_min}};
}
Json write(const JogBy& key) {
  return {{"do", "jog"},
          {"axis", key.axis},
          {"speed_mm_min", std::copysign(key.speed_per_min, key.distance)},
          {"distance_mm", std::abs(key.distance)}};
}
Json write(const JogStop& /*key*/) { return word("jog-stop"); }
Json write(const Home& /*key*/) { return word("home"); }
Json write(const EnterBlocks& key) { return {{"do", "mdi"}, {"text", key.text}}; }
Json write(const EnterLine& key) { return {{"do", "enter"}, {"text", key.text}}; }
Json write(const TakeStep& key) {
  return {{"do", "step"}, {"how", std::string(kSteps[static_cast<std::size_t>(key.how)])}};
}
Json write(const StepBack& /*key*/) { return {{"do", "step"}, {"how", "back"}}; }
Json write(const RunTo& key) { return {{"do", "run-to"}, {"file", key.file}, {"line", key.line}}; }
Json write(const StartAt& key) { return {{"do", "start-at"}, {"line", key.line}}; }
Json write(const SetBreakpoints& key) {
  Json list = Json::array();
  for (const Breakpoint& each : key.list) list.push_back(entry_of(each));
  return {{"do", "breakpoints"}, {"list", std::move(list)}};
}
Json write(const SetVariable& key) {
  Json json = {{"do", "set-variable"}, {"name", key.name}, {"value", nullptr}};
  if (key.value) json["value"] = *key.value;
  if (key.level) json["level"] = *key.level;
  return json;
}
Json write(const SetInput& key) {
  const auto number = base::read_whole_number(std::string_view(key.name).substr(1));
  return {{"do", "set-input"}, {"input", number.value_or(0)}, {"value", key.value}};
}
Json write(const SetOffset& key) {
  return {{"do", "set-offset"}, {"offset", key.offset}, {"axis", key.axis}, {"value", key.value}};
}
Json write(const MeasureOffset& key) {
  return {
      {"do", "measure-offset"}, {"number", key.number}, {"axis", key.axis}, {"reads", key.reads}};
}
template <typename Key>
Json write(const Key& /*key*/) {
  assert(false);  // it has no row
  return {};
}

}  // namespace

const std::vector<OperationRow>& operation_table() {
  static const std::vector<OperationRow> table = make_table();
  return table;
}

const OperationRow* find_operation(std::string_view name) {
  const auto found = std::find_if(operation_table().begin(), operation_table().end(),
                                  [&](const OperationRow& row) { return row.name == name; });
  return found == operation_table().end() ? nullptr : &*found;
}

Json json_of(const Operation& key) {
  return std::visit([](const auto& each) { return write(each); }, key);
}

Argument breakpoint_list() {
  using namespace argument;
  return {.name = "list",
          .kind = Argument::Kind::list,
          .fields = {name_of("file", "of a program", Need::optional),
                     integer("line", kLines, "with `file`", Need::optional),
                     text("condition", 1000, "stops only where this expression is true",
                          Need::optional),
                     name_of("variable", "stops when this one is written", Need::optional)},
          .note = "all of them; each has `file` and `line`, or `variable`"};
}

Json entry_of(const Breakpoint& breakpoint) {
  Json entry = Json::object();
  if (!breakpoint.variable.empty()) {
    entry["variable"] = breakpoint.variable;
  } else {
    entry = {{"file", breakpoint.file}, {"line", breakpoint.line}};
  }
  if (!breakpoint.condition.empty()) entry["condition"] = breakpoint.condition;
  return entry;
}

Breakpoint breakpoint_of(const Arguments& entry) {
  return {entry.text("file"), line_of(entry), entry.text("condition"), entry.text("variable")};
}

Json levels_of(std::uint32_t bits) {
  Json levels = Json::array();
  for (unsigned level = 1; level <= static_cast<unsigned>(SetBlockSkip::kLevels.most); ++level) {
    if ((bits & (1U << level)) != 0) levels.push_back(level);
  }
  return levels;
}

std::uint32_t bits_of(const std::vector<std::int64_t>& levels) {
  std::uint32_t bits = 0;
  for (const std::int64_t level : levels) bits |= 1U << static_cast<unsigned>(level);
  return bits;
}

}  // namespace kerf::machine
