#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/decimal.hpp"
#include "machine/definition/tools/internal/letters.hpp"
#include "machine/definition/tools/internal/library_builder.hpp"
#include "machine/definition/tools/tool_tables.hpp"
#include "machine/definition/tools/tool_words.hpp"

namespace kerf::machine {
namespace {

using stock::Measure;
using stock::Tool;

/// A line `T1 P1 D10.0 Z+0.511 Q3 ;text`.
struct Line {
  std::map<char, double> values;
  std::string_view comment;
  bool is_wrong = false;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

Line line_of(std::string_view text) {
  Line line;
  const std::size_t mark = std::min(text.find(';'), text.size());
  if (mark < text.size()) line.comment = trimmed(text.substr(mark + 1));
  std::string_view rest = trimmed(text.substr(0, mark));
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
    const auto value = base::read_number(rest.substr(1, end - 1));
    const char letter = folded(rest[0]);
    if (!is_capital(letter) || !value) line.is_wrong = true;
    if (value) line.values[letter] = *value;
    rest = trimmed(rest.substr(end));
  }
  return line;
}

// Directions of LinuxCNC (rs274/glcanon.py, lathe_shapes) as FANUC numbers them: X points the other
// way.
constexpr std::array<int, 10> kTips = {0, 4, 3, 2, 1, 5, 8, 7, 6, 9};

double around(double degrees) {
  const double rest = std::fmod(degrees, 360);
  return rest < 0 ? rest + 360 : rest;
}

/// Front and back angle, from +Z to +X, as they would be of an insert that cuts outside towards -Z.
std::array<double, 2> as_tip_3(int tip, double front, double back) {
  const bool mirrors_z = tip == 4 || tip == 1;
  const bool mirrors_x = tip == 2 || tip == 1;
  const auto turned = [&](double degrees) {
    const double z = mirrors_z ? 180 - degrees : degrees;
    return around(mirrors_x ? -z : z);
  };
  const double a = turned(front);
  const double b = turned(back);
  return {std::max(a, b), std::min(a, b)};
}

void set_edges(Tool& tool, int tip, double front, double back) {
  const auto [main, minor] = as_tip_3(tip, front, back);
  set_where_fit(tool, Measure::tip_angle, main - minor > 180 ? 360 - main + minor : main - minor);
  if (tip >= 1 && tip <= 4) set_where_fit(tool, Measure::kapr, 180 - main);
}

void set_insert(Tool& tool, const std::map<char, double>& values, double scale) {
  const double orientation = values.at('Q');
  if (!(orientation >= 1 && orientation <= 9) || orientation != std::floor(orientation)) return;
  const int tip = kTips[static_cast<std::size_t>(orientation)];
  set_type(tool, "turning");
  tool.measures.set(Measure::tip, tip);
  const auto diameter = values.find('D');
  if (diameter != values.end())
    tool.measures.set(Measure::nose_radius, std::abs(diameter->second) * scale / 2);
  if (values.count('I') > 0 && values.count('J') > 0)
    set_edges(tool, tip, values.at('I'), values.at('J'));
}

void set_mill(Tool& tool, const std::map<char, double>& values, double scale) {
  const stock::NamedKind kind = kind_in_words(tool.name);
  if (kind.row != nullptr) set_type(tool, kind.name);
  if (tool.is_insert()) return;
  const auto diameter = values.find('D');
  if (diameter != values.end()) set_where_fit(tool, Measure::diameter, diameter->second * scale);
  set_where_fit(tool, Measure::corner_radius, number_behind("CR", tool.name));
}

Tool tool_of_line(const Line& line, double scale) {
  Tool tool;
  const double number = line.values.at('T');
  const bool is_number = number >= 1 && number <= kLargestToolNumber;
  if (is_number && number == std::floor(number)) tool.number = static_cast<int>(number);
  tool.name = std::string(line.comment.substr(0, 200));
  if (line.values.count('Q') > 0) set_insert(tool, line.values, scale);
  if (tool.type.empty()) set_mill(tool, line.values, scale);
  const auto length = line.values.find('Z');
  if (length != line.values.end()) set_where_fit(tool, Measure::length, length->second * scale);
  return tool;
}

}  // namespace

base::Outcome<ToolLibrary> read_linuxcnc(const std::string& text, ToolsUnit unit) {
  LibraryBuilder builder;
  const double scale = unit == ToolsUnit::inch ? kMmPerInch : 1;
  std::string_view rest = text;
  while (!rest.empty() && !builder.is_full()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const Line line = line_of(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.values.count('T') == 0) continue;
    Tool tool = tool_of_line(line, scale);
    if (line.is_wrong) builder.remark(tool.number, "its line has words that are none of a tool");
    builder.add(std::move(tool));
  }
  return builder.take();
}

}  // namespace kerf::machine
