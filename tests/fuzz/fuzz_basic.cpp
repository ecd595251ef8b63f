// Any bytes as a program of laser BASIC: reading, checking and running it must end in a result or
// an alarm with a place, in motions of finite numbers, and with the beam off. The first byte
// chooses the length of the pages and the panel's switches; how the program is cut must not change
// what it does.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "machine/run/batch_run.hpp"

namespace {

using namespace kerf;

constexpr std::uint64_t kMostMotions = 500;
constexpr std::uint64_t kMostSteps = 20000;
constexpr double kMostSeconds = 0.5;   // a slow cut has millions of set-points
constexpr int kMostStatements = 3000;  // each may cost a call, a page and a line of text

void require(bool condition) {
  if (!condition) std::abort();
}

/// Writes down where a run goes.
class Trace : public motion::MotionSink {
 public:
  void take(const motion::Motion& motion) override {
    ++motions;
    if (const base::TipPoint* const to = motion::target_of(motion)) {
      for (const double value : to->values) {
        require(std::isfinite(value));
        sum = sum * 0.5 + value;
      }
    }
    if (const auto* const power = std::get_if<motion::Power>(&motion.action))
      beam = power->beam_percent();
  }
  std::uint64_t motions = 0;
  double sum = 0;
  double beam = 0;
};

struct Story {
  machine::RunStatus status{};
  std::string alarm;
  std::string printed;
  std::uint64_t motions = 0;
  double sum = 0;
  std::vector<std::pair<std::string, double>> variables;

  friend bool operator==(const Story&, const Story&) = default;
};

std::string told(const std::optional<base::Diagnostic>& alarm, std::size_t size) {
  if (!alarm) return {};
  require(!alarm->number.empty() && !alarm->message.empty());
  require(alarm->place.line_start <= size);
  return alarm->number + " " + std::to_string(alarm->place.line) + ":" +
         std::to_string(alarm->place.column) + " " + alarm->message;
}

Story run(machine::BatchRun& machine, Trace& trace, std::size_t size) {
  Story story;
  int left = 20;
  machine.set_input([&]() -> std::optional<std::string> {
    return left-- > 0 ? std::optional(std::to_string(left - 5)) : std::nullopt;
  });
  machine.set_print_output([&](std::string_view text) { story.printed += text; });
  trace = {};
  story.status = machine.run_to_end({kMostSeconds, kMostMotions, kMostSteps});
  story.alarm = told(machine.alarm(), size);
  story.motions = trace.motions;
  story.sum = trace.sum;
  for (const machine::Variable& variable : machine.variables())
    story.variables.emplace_back(variable.name, variable.value);
  using Status = machine::RunStatus;
  if (story.status == Status::end || story.status == Status::alarm) require(trace.beam == 0);
  return story;
}

Story run_cut_by(const std::string& text, std::uint32_t lines, std::uint8_t choice) {
  static const auto definition = [] {
    auto laser = *machine::find_machine("laser3");
    laser.parameters.statement_limit = kMostStatements;
    return laser;
  }();
  machine::Machine::Settings settings{.dialect = "laser-basic"};
  settings.pages.lines_per_page = lines;
  settings.pages.fresh_pages = 2;
  settings.pages.most_pages = 64;
  machine::BatchRun machine(definition, control::Memory(definition.parameters.n_offsets), settings);
  Trace trace;
  machine.add_sink(trace);
  machine.load(base::SourceFile::from_text("-", text));
  for (const base::Diagnostic& mistake : machine.check()) told(mistake, text.size());
  machine.control().set_single_block((choice & 16U) != 0);
  const Story story = run(machine, trace, text.size());
  if ((choice & 32U) == 0) return story;
  machine.reset();
  run(machine, trace, text.size());
  return story;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
  const Story story = run_cut_by(text, 256, data[0]);
  if (story.status == machine::RunStatus::budget) return 0;
  if ((data[0] & 16U) != 0) return 0;
  require(run_cut_by(text, 1U << (data[0] & 7U), data[0]) == story);
  return 0;
}
