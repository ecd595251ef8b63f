#include "machine/definition/tools/tool_comment.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "base/decimal.hpp"
#include "machine/definition/tools/internal/library_builder.hpp"
#include "machine/definition/tools/program_lines.hpp"
#include "machine/definition/tools/tool_tables.hpp"
#include "machine/definition/tools/tool_words.hpp"

namespace kerf::machine {
namespace {

using stock::Measure;
using stock::Tool;
using stock::ToolKind;

constexpr std::size_t kMostTools = 1000;
constexpr std::string_view kMill = "TOOL/MILL,";

// As CAM systems write it: the tip of a drill as a whole, the side of a chamfer to the axis.
void set_taper(Tool& tool, double degrees) {
  const bool is_side = tool.kind == ToolKind::chamfer || tool.kind == ToolKind::engrave;
  const bool is_whole = !is_side || tool.type == "spot" || tool.type == "countersink";
  if (stock::row_of(tool.kind).key(Measure::angle) == nullptr) return;
  tool.measures.set(Measure::angle, is_whole ? degrees : 2 * degrees);
}

void set_corner(Tool& tool, double radius) {
  if (tool.kind == ToolKind::engrave) return tool.measures.set(Measure::tip_radius, radius);
  const bool has_one = stock::row_of(tool.kind).key(Measure::corner_radius) != nullptr;
  if (has_one && radius > 0) tool.measures.set(Measure::corner_radius, radius);
}

// A bull mill whose corner nobody has said is a flat one.
void settle(Tool& tool) {
  if (tool.kind == ToolKind::bull && !tool.said(Measure::corner_radius)) set_type(tool, "flat");
}

std::optional<Tool> shaped(Tool tool) {
  settle(tool);
  if (!stock::objection(tool).empty()) return {};
  return tool;
}

Tool tool_of(int number, std::string_view comment) {
  Tool tool;
  tool.number = number;
  tool.source = stock::ToolSource::comment;
  tool.comment = std::string(comment);
  return tool;
}

std::optional<Tool> described(std::string_view comment, int number, double mm_per_unit) {
  const auto named = number_behind("T", comment);
  const auto diameter = number_behind("D", comment);
  if (!diameter) return {};
  const bool names_itself = named && comment.find('=') != std::string_view::npos;
  if (!names_itself && number == 0) return {};
  const stock::NamedKind kind = kind_in_words(comment);
  const bool is_formal = names_itself && number_behind("CR", comment);
  if (kind.row == nullptr && !is_formal) return {};
  const double own = names_itself ? *named : number;
  if (!(own >= 0 && own <= kLargestToolNumber)) return {};
  Tool tool = tool_of(static_cast<int>(own), comment);
  if (kind.row != nullptr) set_type(tool, kind.name);
  tool.measures.set(Measure::diameter, *diameter * mm_per_unit);
  if (const auto corner = number_behind("CR", comment)) set_corner(tool, *corner * mm_per_unit);
  if (const auto taper = number_behind("TAPER=", comment)) set_taper(tool, *taper);
  return shaped(std::move(tool));
}

std::optional<Tool> listed(std::string_view comment, int number, double mm_per_unit) {
  std::array<double, 4> values{};
  std::string_view rest = comment.substr(kMill.size());
  for (double& value : values) {
    const std::size_t comma = rest.find(',');
    std::string_view word = rest.substr(0, comma);
    while (!word.empty() && word.front() == ' ') word.remove_prefix(1);
    while (!word.empty() && word.back() == ' ') word.remove_suffix(1);
    value = base::read_number(word).value_or(0);
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  Tool tool = tool_of(number, comment);
  const auto [diameter, corner, height, side] = values;
  static_cast<void>(height);
  set_type(tool, side > 0                 ? "taper"
                 : 2 * corner >= diameter ? "ball"
                 : corner > 0             ? "bull"
                                          : "flat");
  tool.measures.set(Measure::diameter, diameter * mm_per_unit);
  set_corner(tool, corner * mm_per_unit);
  if (side > 0) set_taper(tool, side);
  return shaped(std::move(tool));
}

/// Walks through a program and keeps what its comments say.
class CommentReader {
 public:
  explicit CommentReader(const CommentStyle& style) : style_(style) {}

  void take(std::string_view line) {
    const ProgramLine words(line, style_.has_offset_in_t);
    if (words.inches()) inches_ = inches_ ? inches_ : words.inches();
    if (words.tool() && !pending_.empty()) keep(std::move(pending_), *words.tool());
    if (words.tool()) pending_.clear();
    for (const std::string_view comment : words.comments()) take_comment(comment, words.tool());
  }

  std::vector<Tool> result() {
    const double inch = inches_.value_or(false) ? kMmPerInch : 1;
    const double mm_per_unit = inches_ ? inch : style_.mm_per_unit;
    std::vector<Tool> tools;
    for (const Kept& each : kept_) {
      auto tool = tool_in_comment(each.comment, each.number, mm_per_unit);
      if (!tool) continue;
      const bool is_new = std::none_of(tools.begin(), tools.end(), [&](const Tool& other) {
        return other.number == tool->number;
      });
      if (is_new) tools.push_back(std::move(*tool));
    }
    return tools;
  }

 private:
  struct Kept {
    std::string comment;
    int number;
  };

  void take_comment(std::string_view comment, std::optional<int> tool) {
    const bool is_for_next = capitals(comment).starts_with(kMill);
    if (is_for_next && !tool) {
      pending_ = std::string(comment);
    } else if (tool_in_comment(comment, tool.value_or(0), 1) ||
               tool_in_comment(comment, tool.value_or(0), kMmPerInch)) {
      keep(std::string(comment), tool.value_or(0));
    }
  }

  void keep(std::string comment, int number) {
    const bool is_known = std::any_of(kept_.begin(), kept_.end(), [&](const Kept& other) {
      return other.comment == comment && other.number == number;
    });
    if (!is_known && kept_.size() < kMostTools) kept_.push_back({std::move(comment), number});
  }

  CommentStyle style_;
  std::vector<Kept> kept_;
  std::string pending_;
  std::optional<bool> inches_;
};

}  // namespace

std::optional<Tool> tool_in_comment(std::string_view comment, int number, double mm_per_unit) {
  if (capitals(comment).starts_with(kMill)) return listed(comment, number, mm_per_unit);
  return described(comment, number, mm_per_unit);
}

std::vector<Tool> tools_in_comments(const base::SourceFile& program, const CommentStyle& style) {
  CommentReader reader(style);
  each_line(program, [&](std::string_view line) { reader.take(line); });
  return reader.result();
}

}  // namespace kerf::machine
