#include "output/reports/summary.hpp"

#include <fmt/format.h>

#include "base/decimal.hpp"
#include "output/writing/diagnostic_text.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {

std::string status_name(RunFacts::Status status) {
  using Status = RunFacts::Status;
  switch (status) {
    case Status::idle: return "idle";
    case Status::stopped: return "stopped";
    case Status::end: return "end";
    case Status::alarm: return "alarm";
    case Status::budget: return "budget";
  }
  return "";
}

namespace {

std::string chosen_json(const RunFacts::Chosen& chosen) {
  return JsonObject().text("dialect", chosen.dialect).text("machine", chosen.machine).done();
}

std::string axes_json(const RunFacts& run, double RunFacts::Axis::*value) {
  JsonObject object;
  for (const RunFacts::Axis& axis : run.axes)
    object.number(std::string(1, axis.letter), base::tidy(axis.*value));
  return object.done();
}

std::string extents_json(const RunFacts& run) {
  JsonObject object;
  for (const RunFacts::Axis& axis : run.axes) {
    object.raw(std::string(1, axis.letter), "[" + base::number_text(base::tidy(axis.low)) + "," +
                                                base::number_text(base::tidy(axis.high)) + "]");
  }
  return object.done();
}

std::string position_json(const RunFacts& run) {
  return JsonObject()
      .raw("work", axes_json(run, &RunFacts::Axis::work))
      .raw("machine", axes_json(run, &RunFacts::Axis::machine))
      .done();
}

std::string assumed_json(const RunFacts& run) {
  std::vector<std::string> items;
  for (const control::Assumption& assumption : run.assumed) {
    items.push_back(
        JsonObject().number("line", assumption.line).text("what", assumption.what).done());
  }
  return json_array(items);
}

std::string spindle_json(const RunFacts::Turning::Spindle& spindle) {
  return JsonObject()
      .number("max_rpm_used", base::tidy(spindle.most_rpm))
      .raw("css", spindle.css ? "true" : "false")
      .raw("clamped", spindle.clamped ? "true" : "false")
      .done();
}

// The main one is the object itself.
std::string spindles_json(const RunFacts::Turning& turning) {
  std::string text = spindle_json(turning.spindles.front());
  for (std::size_t i = 1; i < turning.spindles.size(); ++i) {
    text.pop_back();
    text += "," + quoted(turning.spindles[i].name) + ":" + spindle_json(turning.spindles[i]) + "}";
  }
  return text;
}

std::string threads_json(const RunFacts::Turning& turning) {
  std::vector<std::string> items;
  for (const auto& thread : turning.threads)
    items.push_back(JsonObject()
                        .number("lead", thread.lead)
                        .number("passes", static_cast<double>(thread.passes))
                        .number("depth", thread.depth)
                        .done());
  return json_array(items);
}

std::string cycles_json(const RunFacts::Turning& turning) {
  std::vector<std::string> items;
  for (const control::CycleCount& cycle : turning.cycles)
    items.push_back(JsonObject()
                        .text("code", cycle.code)
                        .number("line", cycle.line)
                        .number("passes", static_cast<double>(cycle.passes))
                        .done());
  return json_array(items);
}

std::string variables_json(const RunFacts& run) {
  JsonObject object;
  for (const auto& [name, value] : run.variables) object.number(name, value);
  return object.done();
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long long>(seconds);
  if (whole < 60) return fmt::format("{:.1f} s", seconds);
  return fmt::format("{}:{:02}:{:02} ({:.1f} s)", whole / 3600, whole / 60 % 60, whole % 60,
                     seconds);
}

}  // namespace

std::string alarm_json(const std::optional<RunFacts::Alarm>& alarm) {
  if (!alarm) return "null";
  JsonObject object;
  object.text("code", alarm->number).text("message", alarm->message).text("file", alarm->file);
  object.number("line", alarm->line)
      .number("column", alarm->column)
      .text("program", alarm->program);
  return object.done();
}

JsonObject head_of_report(const RunFacts& run) {
  JsonObject object;
  object.text("program", run.program).text("file", run.file);
  object.text("machine", run.machine).text("dialect", run.dialect);
  if (!run.chosen.dialect.empty()) object.raw("chosen", chosen_json(run.chosen));
  object.text("status", status_name(run.status));
  object.raw("alarm", alarm_json(run.alarm));
  return object;
}

std::string summary_json(const RunFacts& run, const SummaryOfOutputs& outputs) {
  std::vector<std::string> tools;
  for (const std::uint32_t tool : run.tools) tools.push_back(std::to_string(tool));
  std::vector<std::string> messages;
  for (const std::string& message : run.messages) messages.push_back(quoted(message));
  JsonObject object = head_of_report(run);
  object.number("blocks", static_cast<double>(run.blocks))
      .number("motions", static_cast<double>(run.motions));
  object.number("time_s", base::tidy(run.time_s))
      .number("time_feed_s", base::tidy(run.feed_s))
      .number("dwell_s", base::tidy(run.dwell_s));
  object.number("rapid_mm", base::tidy(run.rapid_mm)).number("cut_mm", base::tidy(run.cut_mm));
  object.raw("extents", extents_json(run)).raw("position", position_json(run));
  object.raw("tools", json_array(tools))
      .raw("messages", json_array(messages))
      .number("parts", run.parts);
  if (run.turning) {
    object.raw("spindle", spindles_json(*run.turning));
    object.raw("threads", threads_json(*run.turning)).raw("cycles", cycles_json(*run.turning));
  }
  if (!outputs.pattern.empty()) object.raw("pattern", outputs.pattern);
  if (!outputs.energy.empty()) object.raw("energy", outputs.energy);
  if (!outputs.post.empty()) object.raw("post", outputs.post);
  if (outputs.stock) {
    object.raw("findings", outputs.stock->findings).raw("counts", outputs.stock->counts);
    object.raw("not_checked", outputs.stock->not_checked);
  }
  object.raw("assumed", assumed_json(run)).raw("variables", variables_json(run));
  return object.done() + "\n";
}

std::string summary_text(const RunFacts& run) {
  std::string text = fmt::format("{} on {} ({}): {}\n", printable(run.title), run.machine,
                                 run.dialect, status_name(run.status));
  text += fmt::format("  {} blocks, {} motions, {}; without acceleration {}\n", run.blocks,
                      run.motions, duration_text(run.time_s), duration_text(run.feed_s));
  text += fmt::format("  rapid {:.1f} mm, cut {:.1f} mm", run.rapid_mm, run.cut_mm);
  const char* before = "\n  extents";
  for (const RunFacts::Axis& axis : run.axes) {
    if (run.motions == 0) break;
    text +=
        fmt::format("{} {} {} to {}", before, axis.letter, base::number_text(base::tidy(axis.low)),
                    base::number_text(base::tidy(axis.high)));
    before = ",";
  }
  text += "\n";
  for (const std::string& message : run.messages) text += "  message: " + printable(message) + "\n";
  for (const control::Assumption& assumption : run.assumed) {
    text += assumption.line > 0
                ? fmt::format("  assumed, line {}: {}\n", assumption.line, assumption.what)
                : fmt::format("  assumed: {}\n", assumption.what);
  }
  return text;
}

}  // namespace kerf::output
