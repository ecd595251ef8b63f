#include "machine_run.hpp"

#include <cmath>

#include "base/decimal.hpp"
#include "observer.hpp"

namespace kerf::test {
namespace {

using motion::Motion;

motion::AxisSetup three_axes() {
  motion::AxisSetup setup;
  for (const char letter : {'X', 'Y', 'Z'}) {
    motion::AxisConfig axis;
    axis.letter = letter;
    setup.axes.push_back(axis);
  }
  return setup;
}

class Collector : public motion::MotionSink {
 public:
  explicit Collector(std::vector<Motion>& motions) : motions_(motions) {}
  void take(const Motion& motion) override { motions_.push_back(motion); }

 private:
  std::vector<Motion>& motions_;
};

bool near(double a, double b, double tolerance) { return std::fabs(a - b) <= tolerance; }

std::string different_target(const Motion& got, const Motion& wanted, double tolerance) {
  const base::AxisVector* const a = motion::target_of(got);
  const base::AxisVector* const b = motion::target_of(wanted);
  if ((a == nullptr) != (b == nullptr)) return "one of them moves";
  if (a == nullptr) return {};
  for (std::size_t i = 0; i < base::kMaxAxes; ++i) {
    if (!near(a->values[i], b->values[i], tolerance))
      return "axis " + std::to_string(i) + " differs by " +
             base::number_text(a->values[i] - b->values[i]);
  }
  return {};
}

std::string different_feed(const motion::Feed& got, const motion::Feed& wanted, double tolerance) {
  return got.mode == wanted.mode && near(got.value, wanted.value, tolerance) ? "" : "feed differs";
}

std::string different_arc(const motion::Arc& got, const motion::Arc& wanted, double tolerance) {
  if (got.plane != wanted.plane) return "plane differs";
  if (got.direction != wanted.direction) return "direction differs";
  if (got.turns != wanted.turns) return "turns differ";
  for (std::size_t i = 0; i < 2; ++i) {
    if (!near(got.center[i], wanted.center[i], tolerance)) return "centre differs";
  }
  return different_feed(got.feed, wanted.feed, tolerance);
}

std::string different(const Motion& got, const Motion& wanted, double tolerance) {
  if (got.action.index() != wanted.action.index()) return "kind differs";
  if (got.exact_stop != wanted.exact_stop || got.fixed_override != wanted.fixed_override)
    return "exact stop or override differs";
  std::string what = different_target(got, wanted, tolerance);
  if (!what.empty()) return what;
  if (const auto* const arc = std::get_if<motion::Arc>(&got.action))
    return different_arc(*arc, std::get<motion::Arc>(wanted.action), tolerance);
  if (const auto* const line = std::get_if<motion::Line>(&got.action))
    return different_feed(line->feed, std::get<motion::Line>(wanted.action).feed, tolerance);
  if (motion::target_of(got) == nullptr && text_of(got) != text_of(wanted)) return "it differs";
  return {};
}

}  // namespace

RunResult run_program(const std::string& program, const RunSetup& setup) {
  machine::MachineDefinition definition = *machine::find_machine(setup.machine);
  for (const auto& [key, value] : setup.parameters) {
    if (auto set = definition.parameters.set(key, value); !set)
      return {.alarm = set.error().message};
  }
  control::Memory memory(definition.parameters.n_offsets);
  memory.tools[1].radius_geometry = setup.radius_of_d1;
  machine::BatchRun machine(definition, std::move(memory));
  RunResult result;
  Collector collector(result.motions);
  machine.add_sink(collector);
  machine.load(base::SourceFile::from_text("part.nc", program));
  result.status = machine.run_to_end();
  if (machine.alarm()) {
    result.alarm = machine.alarm()->number + " in line " +
                   std::to_string(machine.alarm()->place.line) + ": " + machine.alarm()->message;
  }
  result.cut_mm = machine.statistics().cut_mm();
  result.seconds = machine.statistics().feed_seconds();
  result.low = machine.statistics().low();
  result.high = machine.statistics().high();
  result.position = machine.control().machine_position();
  return result;
}

std::vector<Motion> moves_of(const RunResult& result) {
  std::vector<Motion> moves;
  for (const Motion& motion : result.motions) {
    if (motion::target_of(motion) != nullptr) moves.push_back(motion);
  }
  return moves;
}

std::string text_of(const Motion& motion) {
  static const motion::AxisSetup axes = three_axes();
  Recorder recorder(axes);
  recorder.take(motion);
  return recorder.observed().front().text;
}

std::string text_of(const std::vector<Motion>& motions) {
  std::string text;
  for (const Motion& motion : motions) text += "\n    " + text_of(motion);
  return text;
}

std::string difference(const std::vector<Motion>& got, const std::vector<Motion>& wanted,
                       double tolerance) {
  for (std::size_t i = 0; i < std::min(got.size(), wanted.size()); ++i) {
    const std::string what = different(got[i], wanted[i], tolerance);
    if (!what.empty())
      return "move " + std::to_string(i) + ": " + what + "\n  got    " + text_of(got[i]) +
             "\n  wanted " + text_of(wanted[i]);
  }
  if (got.size() == wanted.size()) return {};
  return std::to_string(got.size()) + " moves, wanted " + std::to_string(wanted.size()) +
         "\n  got:" + text_of(got) + "\n  wanted:" + text_of(wanted);
}

}  // namespace kerf::test
