#include <fmt/format.h>

#include "base/decimal.hpp"
#include "base/source_file.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "machine/panel/live_machine.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::cli {
namespace {

using machine::LiveMachine;

void print_end(const machine::Snapshot& end) {
  fmt::print("status: {}\ntime: {} s\n", machine::name_of(end.status),
             base::number_text(end.time_s));
  if (!end.alarm) return;
  const std::string place =
      end.alarm->line == 0 ? "" : fmt::format("{}:{}: ", end.alarm->file, end.alarm->line);
  fmt::print("alarm: {}\n", output::printable(place + end.alarm->code + " " + end.alarm->message));
}

}  // namespace

ExitStatus replay(const ReplayOptions& options) {
  const auto text = base::read_whole(options.file, LiveMachine::kMostJournalBytes, "a journal");
  if (!text) return fail(text.error());
  const base::WorkLimit limit(options.max_seconds);
  auto machine = LiveMachine::from_journal(*text, options.libraries, {}, limit);
  if (!machine) {
    const ExitStatus status = fail(machine.error());
    return limit.reached() ? ExitStatus::budget : status;
  }
  const auto end = machine->snapshot();
  print_end(*end);
  return end->alarm ? ExitStatus::findings : ExitStatus::well;
}

}  // namespace kerf::cli
