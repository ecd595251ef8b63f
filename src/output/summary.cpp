#include "output/summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "base/decimal.hpp"
#include "base/program_name.hpp"
#include "lang/vm/value.hpp"
#include "output/diagnostic_text.hpp"
#include "output/internal/json_object.hpp"

namespace kerf::output {
namespace {

using machine::VirtualMachine;
using Status = VirtualMachine::Status;

const char* status_name(Status status) {
  switch (status) {
    case Status::idle: return "idle";
    case Status::running: return "stopped";
    case Status::stopped: return "stopped";
    case Status::end: return "end";
    case Status::alarm: return "alarm";
    case Status::budget: return "budget";
  }
  return "";
}

std::string join(const std::vector<std::string>& items) {
  std::string list = "[";
  for (const std::string& item : items) list += (list.size() > 1 ? "," : "") + item;
  return list + "]";
}

std::string alarm_json(const VirtualMachine& machine) {
  if (!machine.alarm()) return "null";
  const base::Diagnostic& alarm = *machine.alarm();
  JsonObject object;
  object.text("code", alarm.number)
      .text("message", alarm.message)
      .text("file", file_name(alarm, machine.sources()));
  object.number("line", alarm.place.line)
      .number("column", alarm.place.column)
      .text("program", alarm.program);
  return object.done();
}

std::string axes_json(VirtualMachine& machine, const base::AxisVector& values) {
  JsonObject object;
  const control::AxisSetup& axes = machine.definition().axes;
  for (std::size_t i = 0; i < axes.count(); ++i) {
    object.number(std::string(1, axes.axes[i].letter), base::tidy(values.values[i]));
  }
  return object.done();
}

std::string extents_json(VirtualMachine& machine) {
  JsonObject object;
  const control::AxisSetup& axes = machine.definition().axes;
  for (std::size_t i = 0; i < axes.count(); ++i) {
    object.raw(std::string(1, axes.axes[i].letter),
               "[" + base::number_text(base::tidy(machine.statistics().low().values[i])) + "," +
                   base::number_text(base::tidy(machine.statistics().high().values[i])) + "]");
  }
  return object.done();
}

base::AxisVector work_position(VirtualMachine& machine) {
  return machine.position() - machine.control().work_origin();
}

std::string position_json(VirtualMachine& machine) {
  return JsonObject()
      .raw("work", axes_json(machine, work_position(machine)))
      .raw("machine", axes_json(machine, machine.position()))
      .done();
}

std::vector<control::Assumption> assumptions(VirtualMachine& machine) {
  std::vector<control::Assumption> list = machine.control().assumptions().list();
  if (machine.statistics().untimed_line() != 0) {
    list.push_back({machine.statistics().untimed_line(),
                    "feed per revolution without a spindle speed: its time is not counted"});
  }
  return list;
}

std::string assumed_json(VirtualMachine& machine) {
  std::vector<std::string> items;
  for (const control::Assumption& assumption : assumptions(machine)) {
    items.push_back(
        JsonObject().number("line", assumption.line).text("what", assumption.what).done());
  }
  return join(items);
}

std::string variables_json(VirtualMachine& machine) {
  JsonObject object;
  for (const machine::Variable& variable : machine.variables())
    object.number(variable.name, variable.value);
  return object.done();
}

std::string main_file(VirtualMachine& machine) {
  const base::FileId first{0};
  return machine.sources().contains(first) ? machine.sources()[first].name() : std::string();
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long long>(seconds);
  if (whole < 60) return fmt::format("{:.1f} s", seconds);
  return fmt::format("{}:{:02}:{:02} ({:.1f} s)", whole / 3600, whole / 60 % 60, whole % 60,
                     seconds);
}

}  // namespace

std::string file_title(const std::string& path) {
  return path == "-" ? "standard input" : std::filesystem::path(path).filename().string();
}

std::string program_title(VirtualMachine& machine) {
  const std::string name = machine.program_name();
  return name != base::kUnnumberedProgram ? name : file_title(main_file(machine));
}

std::string summary_json(VirtualMachine& machine, const SummaryOfOutputs& outputs) {
  const machine::RunStatistics& run = machine.statistics();
  std::vector<std::string> tools;
  for (const std::uint32_t tool : run.tools()) tools.push_back(std::to_string(tool));
  std::vector<std::string> messages;
  for (const std::string& message : run.messages()) messages.push_back(quoted(message));
  JsonObject object;
  object.text("program", machine.program_name()).text("file", main_file(machine));
  object.text("machine", machine.definition().name)
      .text("dialect", machine.dialect())
      .text("status", status_name(machine.status()));
  object.raw("alarm", alarm_json(machine));
  object.number("blocks", static_cast<double>(machine.control().blocks()))
      .number("motions", static_cast<double>(run.motions()));
  object.number("time_s", base::tidy(machine.time_s()))
      .number("time_feed_s", base::tidy(run.feed_seconds()))
      .number("dwell_s", base::tidy(run.dwell_seconds()));
  object.number("rapid_mm", base::tidy(run.rapid_mm())).number("cut_mm", base::tidy(run.cut_mm()));
  object.raw("extents", extents_json(machine)).raw("position", position_json(machine));
  object.raw("tools", join(tools))
      .raw("messages", join(messages))
      .number("parts", machine.memory().parts);
  if (!outputs.pattern.empty()) object.raw("pattern", outputs.pattern);
  if (!outputs.post.empty()) object.raw("post", outputs.post);
  object.raw("assumed", assumed_json(machine)).raw("variables", variables_json(machine));
  return object.done() + "\n";
}

std::string summary_text(VirtualMachine& machine) {
  const machine::RunStatistics& run = machine.statistics();
  const control::AxisSetup& axes = machine.definition().axes;
  std::string text =
      fmt::format("{} on {} ({}): {}\n", printable(program_title(machine)),
                  machine.definition().name, machine.dialect(), status_name(machine.status()));
  text += fmt::format("  {} blocks, {} motions, {}; without acceleration {}\n",
                      machine.control().blocks(), run.motions(), duration_text(machine.time_s()),
                      duration_text(run.feed_seconds()));
  text += fmt::format("  rapid {:.1f} mm, cut {:.1f} mm", run.rapid_mm(), run.cut_mm());
  for (std::size_t i = 0; i < axes.count() && run.motions() > 0; ++i) {
    text += fmt::format("{} {} {} to {}", i == 0 ? "\n  extents" : ",", axes.axes[i].letter,
                        base::number_text(base::tidy(run.low().values[i])),
                        base::number_text(base::tidy(run.high().values[i])));
  }
  text += "\n";
  for (const std::string& message : run.messages())
    text += "  message: " + printable(message) + "\n";
  for (const control::Assumption& assumption : assumptions(machine)) {
    text += assumption.line > 0
                ? fmt::format("  assumed, line {}: {}\n", assumption.line, assumption.what)
                : fmt::format("  assumed: {}\n", assumption.what);
  }
  return text;
}

}  // namespace kerf::output
