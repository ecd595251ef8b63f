#include "output/pattern_report.hpp"

#include <fmt/format.h>

#include "base/decimal.hpp"
#include "drive/pattern/axis_name.hpp"
#include "drive/pattern/codec.hpp"
#include "output/internal/json_object.hpp"

namespace kerf::output {
namespace {

std::string place_json(const PatternReport::Deviation& at) {
  if (at.line == 0) return "null";
  JsonObject object;
  object.number("line", at.line).number("X", base::tidy(at.x)).number("Y", base::tidy(at.y));
  return object.done();
}

}  // namespace

std::string counters_json(const drive::ArmCounts& counters) {
  JsonObject object;
  for (std::size_t i = 0; i < drive::kArmAxes; ++i)
    object.number(std::string(drive::kArmAxisNames[i]), static_cast<double>(counters.values[i]));
  return object.done();
}

std::string pattern_json(const PatternReport& report, const machine::PatternSettings& settings) {
  const std::uint64_t records = report.fast + report.triplets;
  JsonObject object;
  object.number("records", static_cast<double>(records))
      .number("fast", static_cast<double>(report.fast))
      .number("triplets", static_cast<double>(report.triplets))
      .number("bytes", static_cast<double>(records * drive::kRecordBytes))
      .number("splits", static_cast<double>(report.splits))
      .number("lifts", static_cast<double>(report.lifts))
      .number("time_s", base::tidy(report.time_s))
      .number("tolerance_mm", settings.tolerance_mm);
  object.number("bound_mm", base::tidy(report.bound.mm))
      .number("bound_pulses_mm", base::tidy(report.bound_pulses_mm))
      .raw("bound_at", place_json(report.bound));
  object.number("measured_mm", base::tidy(report.measured.mm))
      .raw("measured_at", place_json(report.measured));
  object.number("heading_deg", base::tidy(report.heading_deg))
      .raw("counters", counters_json(report.counters));
  return object.done();
}

std::string pattern_text(const PatternReport& report, const machine::PatternSettings& settings) {
  std::string text = fmt::format(
      "  pattern: {} fast records, {} triplets, {:.1f} s; {} corners turned in the air\n",
      report.fast, report.triplets, report.time_s, report.lifts);
  if (report.bound.line == 0) return text;
  const auto place = [](const PatternReport::Deviation& at) {
    return fmt::format("line {}, X{:.2f} Y{:.2f}", at.line, at.x, at.y);
  };
  text +=
      fmt::format("  the wheel leaves the path by at most {:.4f} mm ({}), {:.4f} of it pulses\n",
                  report.bound.mm, place(report.bound), report.bound_pulses_mm);
  text +=
      fmt::format("  measured after every pulse: {:.4f} mm ({}); heading off by {:.3f} degrees\n",
                  report.measured.mm, place(report.measured), report.heading_deg);
  if (report.bound.mm > settings.tolerance_mm) {
    text += fmt::format(
        "  the tolerance of {} mm cannot be promised there: finer steps of the arms would be "
        "needed\n",
        base::number_text(settings.tolerance_mm));
  }
  return text;
}

}  // namespace kerf::output
