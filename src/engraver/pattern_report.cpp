#include "engraver/pattern_report.hpp"

#include <fmt/format.h>

#include "base/decimal.hpp"
#include "drive/pattern/axis_name.hpp"
#include "drive/pattern/codec.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::engraver {
namespace {

std::string place_json(const PatternReport::Deviation& at) {
  if (at.line == 0) return "null";
  output::JsonObject object;
  object.number("line", at.line).number("X", base::tidy(at.x)).number("Y", base::tidy(at.y));
  return object.done();
}

// Of a length, mm, such that it does not look like the limit that it is beyond.
std::string shown_beside(double mm, double limit_mm) {
  constexpr int kUsual = 4;  // decimals
  constexpr int kMost = 9;
  for (int decimals = kUsual;; ++decimals) {
    std::string text = fmt::format("{:.{}f}", mm, decimals);
    const bool differs = text != fmt::format("{:.{}f}", limit_mm, decimals);
    if (mm <= limit_mm || differs || decimals == kMost) return text;
  }
}

}  // namespace

output::JsonObject records_json(std::uint64_t fast, std::uint64_t triplets) {
  const std::uint64_t records = fast + triplets;
  output::JsonObject object;
  object.number("records", static_cast<double>(records))
      .number("fast", static_cast<double>(fast))
      .number("triplets", static_cast<double>(triplets))
      .number("bytes", static_cast<double>(records * drive::kRecordBytes));
  return object;
}

std::string counters_json(const drive::ArmCounts& counters) {
  output::JsonObject object;
  for (std::size_t i = 0; i < drive::kArmAxes; ++i)
    object.number(std::string(drive::kArmAxisNames[i]), static_cast<double>(counters.values[i]));
  return object.done();
}

std::string pattern_json(const PatternReport& report, const machine::PatternSettings& settings) {
  output::JsonObject object = records_json(report.fast, report.triplets);
  object.number("splits", static_cast<double>(report.splits))
      .number("lifts", static_cast<double>(report.lifts))
      .number("dwells", static_cast<double>(report.dwells))
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

std::string pattern_text(const PatternReport& report, const machine::MachineDefinition& machine) {
  const double tolerance_mm = machine.pattern.tolerance_mm;
  std::string text = fmt::format(
      "  pattern: {} fast records, {} triplets, {:.1f} s; {} corners turned in the air\n",
      report.fast, report.triplets, report.time_s, report.lifts);
  if (report.dwells > 0) {
    text += fmt::format("  {} of the program left out: a pattern says no times\n",
                        report.dwells == 1 ? "a dwell" : fmt::format("{} dwells", report.dwells));
  }
  if (report.bound.line == 0) return text;
  const double bound_mm = base::tidy(report.bound.mm);  // what rounding adds breaks no promise
  const auto place = [](const PatternReport::Deviation& at) {
    if (at.line == 0) return std::string();
    return fmt::format(" (line {}, X{:.2f} Y{:.2f})", at.line, at.x, at.y);
  };
  text += fmt::format("  the wheel leaves the path by at most {} mm{}, {:.4f} of it pulses\n",
                      shown_beside(bound_mm, tolerance_mm), place(report.bound),
                      report.bound_pulses_mm);
  text += fmt::format("  measured after every pulse: {:.4f} mm{}; heading off by {:.3f} degrees\n",
                      report.measured.mm, place(report.measured), report.heading_deg);
  if (bound_mm > tolerance_mm) {
    text += fmt::format(
        "  the tolerance of {} mm cannot be promised there: finer steps of {} and {} would be "
        "needed\n",
        base::number_text(tolerance_mm), machine.driven[0].name, machine.driven[1].name);
  }
  return text;
}

}  // namespace kerf::engraver
