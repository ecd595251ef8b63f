#include "job/edits_file.hpp"

#include <string_view>
#include <utility>

#include "job/internal/edit_operations.hpp"

namespace kerf::job {
namespace {

using features::Edit;
using features::EditScope;
using features::LayerRule;

constexpr double kEditsVersion = 1;
constexpr std::size_t kMostEdits = 20'000;

std::string target_of(JsonMembers& members, const EditTakes& takes) {
  std::string target;
  for (const std::string_view name : {"feature", "pattern", "call"}) {
    const bool is_one = name == "call" ? takes.call : takes.target;
    if (!is_one || !members.has(name)) continue;
    if (!target.empty()) throw Misread{"TWO TARGETS OF ONE EDIT", members.need(name)};
    target = members.word(name);
  }
  if (target.empty() && takes.target) members.refuse("`feature` IS MISSING");
  return target;
}

LayerRule rule_of(JsonMembers& members) {
  const std::string word = members.word("layers");
  if (word == "rebuild") return LayerRule::rebuild;
  if (word == "all") return LayerRule::all;
  if (word == "only") return LayerRule::only;
  throw Misread{"`layers` IS NONE OF `rebuild`, `all` AND `only`", members.need("layers")};
}

EditScope scope_of(JsonMembers& members) {
  const std::string word = members.word("scope");
  if (word == "all") return EditScope::all;
  if (word == "this") return EditScope::this_call;
  throw Misread{"`scope` IS NEITHER `all` NOR `this`", members.need("scope")};
}

Edit edit_at(EditReading& reading, std::size_t value) {
  JsonMembers members(reading.json, value);
  ReadOperation read = read_operation(reading, members);
  const EditTakes& takes = read.takes;
  Edit edit{.operation = std::move(read.operation), .target = target_of(members, takes)};
  if (takes.layer) edit.layer = members.count_if("layer", 1);
  if (takes.island) edit.island = members.count_if("island", 0);
  if (takes.rule && members.has("layers")) edit.layers = rule_of(members);
  if (members.has("scope")) edit.scope = scope_of(members);
  edit.unrolls = members.flag_if("unroll");
  members.expect_all_known("THE OPERATION " + in_quotes(members.word("op")));
  const TextPlace place = reading.json.place(value);
  edit.line = place.line;
  edit.column = place.column;
  return edit;
}

std::vector<Edit> edits_of(const PlacedJson& placed, bool turns) {
  JsonMembers file(placed, 0);
  if (file.number("version") != kEditsVersion) {
    throw Misread{"THIS IS NOT VERSION 1", file.need("version")};
  }
  EditReading reading{placed, turns};
  std::vector<Edit> edits;
  for (const std::size_t value : elements_at(placed, file.need("edits"), "`edits`")) {
    if (edits.size() == kMostEdits) {
      throw Misread{"MORE THAN " + std::to_string(kMostEdits) + " EDITS", value};
    }
    edits.push_back(edit_at(reading, value));
  }
  file.expect_all_known("THE FILE");
  return edits;
}

}  // namespace

tl::expected<std::vector<Edit>, EditsFileFault> read_edits(const std::string& text, bool turns) {
  const auto fault = [](const std::string& sentence, TextPlace place) {
    return tl::make_unexpected(EditsFileFault{sentence, place.line, place.column});
  };
  const auto json = PlacedJson::read(text);
  if (!json) return fault(json.error().sentence, json.error().place);
  try {
    return edits_of(*json, turns);
  } catch (const Misread& wrong) {
    return fault(wrong.sentence, json->place(wrong.value));
  }
}

}  // namespace kerf::job
