#include "machine/definition/tools/internal/library_builder.hpp"

#include <algorithm>

#include "machine/definition/tools/tool_tables.hpp"

namespace kerf::machine {

using stock::Measure;
using stock::Tool;

void LibraryBuilder::remark(int number, std::string text) {
  library_.remarks.push_back({number, std::move(text)});
}

// A wrong height makes no other shape of what cuts: without it the tool is what it was.
bool LibraryBuilder::forget_contradiction(Tool& tool, const std::string& objection) {
  const bool is_flutes = objection.starts_with("flute_length");
  if (!is_flutes && !objection.starts_with("stickout")) return false;
  remark(tool.number, objection + ": it is left out");
  if (is_flutes) {
    tool.measures.forget(Measure::flute_length);
    tool.shank.clear();
  } else {
    tool.measures.forget(Measure::stickout);
    tool.holder.clear();
  }
  return true;
}

void LibraryBuilder::add(Tool tool) {
  if (tool.number < 1 || tool.number > kLargestToolNumber)
    return remark(0, "\"" + tool.name.substr(0, 100) + "\" has no number that a program can call");
  const auto place = std::lower_bound(numbers_.begin(), numbers_.end(), tool.number);
  if (place != numbers_.end() && *place == tool.number)
    return remark(tool.number, "it is there more than once; the first one counts");
  std::string wrong = stock::objection(tool);
  while (!wrong.empty() && forget_contradiction(tool, wrong)) wrong = stock::objection(tool);
  if (!wrong.empty()) {
    remark(tool.number, wrong);
    const auto length = tool.measures.get(Measure::length);
    const auto diameter = tool.measures.get(Measure::diameter);
    if (!length && !diameter) return;
  }
  numbers_.insert(place, tool.number);
  library_.tools.push_back(std::move(tool));
}

void set_type(Tool& tool, std::string_view type) {
  const stock::NamedKind named = stock::kind_named(type);
  tool.kind = named.row->kind;
  tool.type = named.name;
}

void set_where_fit(Tool& tool, Measure measure, std::optional<double> value) {
  if (!value || *value == 0 || !stock::row_of(measure).takes(*value)) return;
  const bool has_key = stock::is_common(measure) || measure == Measure::diameter ||
                       stock::row_of(tool.kind).key(measure) != nullptr;
  if (has_key) tool.measures.set(measure, *value);
}

tl::unexpected<base::Failure> unreadable(const std::string& path, const std::string& why) {
  return tl::unexpected(base::Failure{base::Failure::Kind::input, path + ": " + why});
}

}  // namespace kerf::machine
