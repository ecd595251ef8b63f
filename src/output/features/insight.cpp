#include "output/features/insight.hpp"

#include <algorithm>
#include <map>

#include "features/tree/words.hpp"
#include "output/features/feature_json.hpp"
#include "output/features/internal/json_values.hpp"
#include "output/reports/summary.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

using features::Recording;

std::string kind_of(const Recording& recording, std::uint32_t number) {
  const auto tool = recording.tools.find(number);
  if (tool == recording.tools.end()) return "";
  const auto diameter = tool->second.value(stock::Measure::diameter);
  const std::string type(tool->second.type_name());
  return diameter ? "Ø" + base::rounded_text(*diameter, 3) + " " + type : type;
}

/// What a tool has cut, and by which lines of the main file.
struct ToolWork {
  double cut_mm = 0;
  LineRange lines{};
};

std::map<std::uint32_t, ToolWork> work_of(const Recording& recording) {
  std::map<std::uint32_t, ToolWork> work;
  for (std::uint32_t row = 0; row < recording.count(); ++row) {
    const features::Move& move = recording.moves[row];
    ToolWork& its = work[recording.state_of(move).tool];
    if (move.kind != features::Move::Kind::rapid) its.cut_mm += recording.length_of(row);
    const base::BlockId& block = recording.block_of(move);
    if (block.file != base::FileId{0} || block.line == 0) continue;
    its.lines.first = its.lines.first == 0 ? block.line : std::min(its.lines.first, block.line);
    its.lines.last = std::max(its.lines.last, block.line);
  }
  return work;
}

std::string tool_json(const InsightFacts& facts, const ToolWork& work, std::uint32_t number) {
  TimeReport::ToolTime time{.tool = number};
  for (const TimeReport::ToolTime& each : facts.tools) {
    if (each.tool == number) time = each;
  }
  return JsonObject()
      .raw("tool", std::to_string(number))
      .text("description", kind_of(*facts.features.recording, number))
      .raw("time_s", rounded(time.rapid_s + time.cut_s + time.dwell_s))
      .raw("cut_mm", rounded(work.cut_mm))
      .raw("cut_s", rounded(time.cut_s))
      .raw("lines", lines_json(work.lines))
      .done();
}

/// In the order of their first use; of what moves without one, T0 comes first.
std::string tools_json(const InsightFacts& facts) {
  const auto work = work_of(*facts.features.recording);
  std::vector<std::string> tools;
  if (facts.features.run.tools.empty() && work.count(0) > 0)
    tools.push_back(tool_json(facts, work.at(0), 0));
  for (const std::uint32_t number : facts.features.run.tools) {
    const auto its = work.find(number);
    tools.push_back(tool_json(facts, its == work.end() ? ToolWork{} : its->second, number));
  }
  return json_array(tools);
}

std::string travel_json(const InsightFacts& facts) {
  std::vector<std::string> axes;
  for (std::size_t i = 0; i < facts.features.run.axes.size(); ++i) {
    const RunFacts::Axis& axis = facts.features.run.axes[i];
    const motion::AxisConfig& limits = facts.axes->axes[i];
    const bool is_limited = limits.travel_min < limits.travel_max;
    const double count = limits.count_per_mm();
    axes.push_back(JsonObject()
                       .text("axis", std::string(1, axis.letter))
                       .raw("from", rounded(axis.low))
                       .raw("to", rounded(axis.high))
                       .raw("limit_from", is_limited ? rounded(limits.travel_min * count) : "null")
                       .raw("limit_to", is_limited ? rounded(limits.travel_max * count) : "null")
                       .done());
  }
  return json_array(axes);
}

std::string counts_json(const features::Tree& tree) {
  std::vector<std::pair<std::string, std::size_t>> counts;
  const auto count = [&](const std::string& word) {
    for (auto& [known, number] : counts) {
      if (known == word) return static_cast<void>(++number);
    }
    counts.emplace_back(word, 1);
  };
  for (const features::Feature& feature : tree.features)
    count(std::string(features::word_of(feature.type)));
  for (std::size_t i = 0; i < tree.holes.size(); ++i) count("hole");
  JsonObject object;
  for (const auto& [word, number] : counts) object.raw(word.c_str(), std::to_string(number));
  return object.done();
}

}  // namespace

std::string run_insight_members(const InsightFacts& facts) {
  const RunFacts& run = facts.features.run;
  JsonObject object;
  object.raw("size", JsonObject()
                         .raw("lines", std::to_string(facts.lines))
                         .raw("bytes", std::to_string(facts.bytes))
                         .done());
  object.raw("time_s", rounded(run.time_s)).raw("tools", tools_json(facts));
  object.raw("travel", travel_json(facts)).text("status", status_name(run.status));
  const std::string text = object.raw("alarm", alarm_json(run.alarm)).done();
  return text.substr(1, text.size() - 2);
}

std::string feature_insight_members(const FeatureFacts& facts) {
  if (facts.tree == nullptr) return "\"features\":null,\"unrecognised\":[]";
  return "\"features\":" + counts_json(*facts.tree) +
         ",\"unrecognised\":" + unrecognised_json(facts);
}

}  // namespace kerf::output
