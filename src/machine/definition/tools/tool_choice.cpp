#include "machine/definition/tools/tool_choice.hpp"

#include <algorithm>

#include "base/decimal.hpp"
#include "machine/definition/tools/internal/library_builder.hpp"

namespace kerf::machine {
namespace {

using stock::Measure;
using stock::Tool;
using stock::ToolKind;
using stock::ToolSource;

constexpr double kUsualDiameter_mm = 6;
constexpr double kUsualNose_mm = 0.4;
constexpr int kUsualTip = 3;

void set_kind(Tool& tool, ToolKind kind) { set_type(tool, stock::row_of(kind).names.front()); }

bool has_offset(const ToolUse& use) {
  return use.turns ? use.offset_nose_mm > 0 || use.offset_tip > 0 : use.offset_radius_mm > 0;
}

// What the control's own table knows of a tool: a radius, or a nose.
Tool tool_of_offset(const ToolUse& use) {
  Tool tool;
  tool.source = ToolSource::offset;
  set_kind(tool, use.turns ? ToolKind::turning : ToolKind::flat);
  if (!use.turns) {
    tool.measures.set(Measure::diameter, 2 * use.offset_radius_mm);
    return tool;
  }
  tool.measures.set(Measure::nose_radius, use.offset_nose_mm);
  tool.measures.set(Measure::tip, use.offset_tip);
  return tool;
}

Tool usual_tool(const ToolUse& use) {
  Tool tool;
  tool.source = ToolSource::assumed;
  if (use.turns) {
    set_kind(tool, ToolKind::turning);
    tool.measures.set(Measure::nose_radius, kUsualNose_mm);
    tool.measures.set(Measure::tip, kUsualTip);
    return tool;
  }
  set_kind(tool, use.cuts_only_along_axis ? ToolKind::drill : ToolKind::flat);
  tool.measures.set(Measure::diameter, kUsualDiameter_mm);
  return tool;
}

Tool undescribed(const ToolUse& use) {
  Tool tool = has_offset(use) ? tool_of_offset(use) : usual_tool(use);
  return stock::objection(tool).empty() ? tool : usual_tool(use);
}

void take_over(const Tool& other, Tool& tool) {
  const auto length = other.measures.get(Measure::length);
  if (length && !tool.measures.get(Measure::length)) tool.measures.set(Measure::length, *length);
  if (tool.name.empty()) tool.name = other.name;
}

// A nose that the tool's description leaves open is that of its offset.
void fill_nose(const ToolUse& use, Tool& tool) {
  if (!tool.is_insert()) return;
  const stock::KindRow& row = stock::row_of(tool.kind);
  Tool filled = tool;
  if (!tool.said(Measure::nose_radius) && use.offset_nose_mm > 0 && row.key(Measure::nose_radius))
    filled.measures.set(Measure::nose_radius, use.offset_nose_mm);
  if (!tool.said(Measure::tip) && use.offset_tip > 0)
    filled.measures.set(Measure::tip, use.offset_tip);
  if (stock::objection(filled).empty()) tool = std::move(filled);
}

std::string measure_text(Measure measure, double value) {
  return std::string(stock::row_of(measure).name) + " " + base::number_text(value);
}

// What has been taken instead of a description, in a few words.
std::string shape_text(const Tool& tool) {
  std::string text(tool.type_name());
  for (const Measure measure : {Measure::diameter, Measure::nose_radius, Measure::tip}) {
    if (const auto value = tool.said(measure)) text += ", " + measure_text(measure, *value);
  }
  return text;
}

std::vector<std::string> assumptions(const Tool& tool) {
  const std::string name = "T" + std::to_string(tool.number) + ": ";
  std::vector<std::string> list;
  if (tool.source == ToolSource::offset)
    list.push_back(name + shape_text(tool) + ", as its offset says");
  if (tool.source == ToolSource::assumed)
    list.push_back(name + shape_text(tool) + ", for nothing describes it");
  if (tool.type.empty())
    list.push_back(name + "type " + std::string(tool.type_name()) + ", for none is said");
  for (const stock::KindKey& key : stock::row_of(tool.kind).keys) {
    const auto value = tool.value(key.measure);
    if (!tool.said(key.measure) && value && *value != 0)
      list.push_back(name + measure_text(key.measure, *value) + ", as is usual");
  }
  return list;
}

}  // namespace

ToolChoice::ToolChoice(std::vector<Tool> tools) : tools_(std::move(tools)) {
  std::stable_sort(tools_.begin(), tools_.end(),
                   [](const Tool& a, const Tool& b) { return a.source < b.source; });
}

ChosenTool ToolChoice::choose(int number, const ToolUse& use) const {
  const auto is_it = [&](const Tool& tool) { return tool.number == number; };
  const auto has_shape = [&](const Tool& tool) {
    return is_it(tool) && stock::objection(tool).empty();
  };
  const auto found = std::find_if(tools_.begin(), tools_.end(), has_shape);
  Tool tool = found == tools_.end() ? undescribed(use) : *found;
  tool.number = number;
  for (auto other = tools_.begin(); other != found; ++other)
    if (is_it(*other)) take_over(*other, tool);
  if (found != tools_.end()) fill_nose(use, tool);
  std::vector<std::string> assumed = assumptions(tool);
  return {std::move(tool), std::move(assumed)};
}

}  // namespace kerf::machine
