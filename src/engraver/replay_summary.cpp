#include "engraver/replay_summary.hpp"

#include <fmt/format.h>

#include "base/decimal.hpp"
#include "drive/pattern/axis_name.hpp"
#include "drive/pattern/codec.hpp"
#include "engraver/pattern_report.hpp"
#include "output/writing/diagnostic_text.hpp"
#include "output/writing/json_object.hpp"
#include "output/writing/title.hpp"

namespace kerf::engraver {
namespace {

std::string alarm_json(const std::optional<base::Diagnostic>& alarm, const std::string& file) {
  if (!alarm) return "null";
  output::JsonObject object;
  object.text("code", alarm->number).text("message", alarm->message).text("file", file);
  if (alarm->place.line > 0) object.number("line", alarm->place.line);
  if (alarm->offset) object.number("offset", static_cast<double>(*alarm->offset));
  return object.done();
}

const char* status_of(const ReplaySummary& summary) {
  if (summary.alarm) return "alarm";
  return summary.budget_spent ? "budget" : "end";
}

std::string pattern_json(const PatternReplay::Totals& totals) {
  output::JsonObject object = records_json(totals.fast, totals.triplets);
  if (totals.linked > 0) object.number("linked", static_cast<double>(totals.linked));
  object.number("pulses", static_cast<double>(totals.pulses));
  return object.done();
}

std::string extents_json(const PatternReplay& replay) {
  const machine::RunStatistics& run = replay.statistics();
  const auto& axes = replay.machine().definition().axes.axes;
  output::JsonObject object;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    object.raw(std::string(1, axes[i].letter),
               "[" + base::number_text(base::tidy(run.low().values[i])) + "," +
                   base::number_text(base::tidy(run.high().values[i])) + "]");
  }
  return object.done();
}

std::string position_json(const PatternReplay& replay) {
  const base::TipPoint tip = replay.machine().tip_at(replay.counters());
  const auto& axes = replay.machine().definition().axes.axes;
  output::JsonObject object;
  for (std::size_t i = 0; i < axes.size(); ++i)
    object.number(std::string(1, axes[i].letter), base::tidy(tip.values[i]));
  return output::JsonObject().raw("machine", object.done()).done();
}

}  // namespace

std::string replay_json(const PatternReplay& replay, const ReplaySummary& summary) {
  const machine::RunStatistics& run = replay.statistics();
  output::JsonObject object;
  object.text("file", summary.file).text("machine", replay.machine().definition().name);
  object.text("dialect", "pattern").text("status", status_of(summary));
  object.raw("alarm", alarm_json(summary.alarm, summary.file));
  object.number("motions", static_cast<double>(run.motions()))
      .number("time_s", base::tidy(replay.time_s()))
      .number("rapid_mm", base::tidy(run.rapid_mm()))
      .number("cut_mm", base::tidy(run.cut_mm()));
  object.raw("extents", extents_json(replay)).raw("position", position_json(replay));
  object.raw("pattern", pattern_json(replay.totals()))
      .raw("counters", counters_json(replay.counters()));
  return object.done() + "\n";
}

std::string replay_text(const PatternReplay& replay, const ReplaySummary& summary) {
  const machine::RunStatistics& run = replay.statistics();
  const PatternReplay::Totals& totals = replay.totals();
  const auto& axes = replay.machine().definition().axes.axes;
  std::string text =
      fmt::format("{} on {} (pattern): {}\n", output::printable(output::file_title(summary.file)),
                  replay.machine().definition().name, status_of(summary));
  text += fmt::format("  {} records: {} fast, {} triplets{}; {} pulses, {:.1f} s\n",
                      totals.records(), totals.fast, totals.triplets,
                      totals.linked > 0 ? fmt::format(", {} linked", totals.linked) : "",
                      totals.pulses, replay.time_s());
  text += fmt::format("  rapid {:.1f} mm, cut {:.1f} mm", run.rapid_mm(), run.cut_mm());
  for (std::size_t i = 0; i < axes.size() && run.motions() > 0; ++i) {
    text += fmt::format("{} {} {} to {}", i == 0 ? "\n  extents" : ",", axes[i].letter,
                        base::number_text(base::tidy(run.low().values[i])),
                        base::number_text(base::tidy(run.high().values[i])));
  }
  text += "\n  counters";
  for (std::size_t i = 0; i < drive::kArmAxes; ++i) {
    text += fmt::format("{} {} {}", i == 0 ? "" : ",", drive::kArmAxisNames[i],
                        replay.counters().values[i]);
  }
  return text + "\n";
}

}  // namespace kerf::engraver
