#include "machine/definition/tools/tool_text.hpp"

#include <nlohmann/json.hpp>

#include "base/decimal.hpp"
#include "machine/definition/tools/internal/tool_limits.hpp"

namespace kerf::machine {
namespace {

using stock::Segment;
using stock::Tool;

// The escapes of JSON are those of TOML too; only DEL stands in JSON as it is, and not in TOML.
std::string quoted(std::string text) {
  for (char& c : text)
    if (c == '\x7f') c = '?';
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append_line(std::string& out, std::string_view key, const std::string& value) {
  out += std::string(key) + " = " + value + "\n";
}

void append_text(std::string& out, std::string_view key, std::string_view text) {
  if (!text.empty()) append_line(out, key, quoted(std::string(text)));
}

std::string segment_text(const Segment& segment) {
  const std::string height = "{height = " + base::number_text(segment.height);
  if (segment.lower == segment.upper)
    return height + ", diameter = " + base::number_text(segment.lower) + "}";
  return height + ", lower = " + base::number_text(segment.lower) +
         ", upper = " + base::number_text(segment.upper) + "}";
}

void append_stack(std::string& out, std::string_view key, const std::vector<Segment>& stack) {
  if (stack.empty()) return;
  std::string list;
  for (const Segment& each : stack) list += (list.empty() ? "" : ", ") + segment_text(each);
  append_line(out, key, "[" + list + "]");
}

void append_form(std::string& out, const Tool& tool) {
  if (tool.form.empty()) return;
  std::string list;
  for (const stock::FormPoint& point : tool.form) {
    list += (list.empty() ? "[" : ", [") + base::number_text(point.r) + ", " +
            base::number_text(point.z);
    list += point.bulge == 0 ? "]" : ", " + base::number_text(point.bulge) + "]";
  }
  append_line(out, "profile", "[" + list + "]");
  if (tool.cutting)
    append_line(
        out, "cutting",
        "[" + std::to_string(tool.cutting->from) + ", " + std::to_string(tool.cutting->to) + "]");
}

void append_limits(std::string& out, const stock::ToolLimits& limits) {
  std::string list;
  for (const LimitKey& key : kLimitKeys) {
    if (const auto& value = limits.*(key.of))
      list +=
          (list.empty() ? "" : ", ") + std::string(key.name) + " = " + base::number_text(*value);
  }
  if (!list.empty()) append_line(out, "limits", "{" + list + "}");
}

}  // namespace

void append_tool(std::string& out, const Tool& tool) {
  out += "[[tool]]\n";
  append_line(out, "number", std::to_string(tool.number));
  append_text(out, "type", tool.type);
  append_text(out, "name", tool.name);
  append_text(out, "comment", tool.comment);
  append_text(out, "material", tool.material);
  append_text(out, "insert", tool.insert);
  for (const stock::MeasureRow& row : stock::measure_rows()) {
    if (const auto value = tool.measures.get(row.measure))
      append_line(out, row.name, base::number_text(*value));
  }
  if (tool.centre_cutting)
    append_line(out, "centre_cutting", *tool.centre_cutting ? "true" : "false");
  if (tool.hand == stock::Hand::left) append_line(out, "hand", "\"left\"");
  if (tool.driven)
    append_line(out, "driven", *tool.driven == stock::Driven::face ? "\"face\"" : "\"side\"");
  append_form(out, tool);
  append_stack(out, "shank", tool.shank);
  append_stack(out, "holder", tool.holder);
  append_limits(out, tool.limits);
}

std::string tools_as_toml(const std::vector<Tool>& tools) {
  std::string out;
  for (const Tool& tool : tools) {
    if (!out.empty()) out += "\n";
    append_tool(out, tool);
  }
  return out;
}

}  // namespace kerf::machine
