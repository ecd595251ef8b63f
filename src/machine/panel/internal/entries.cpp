#include "machine/panel/internal/entries.hpp"

#include <cmath>

#include "base/decimal.hpp"
#include "lang/vm/value.hpp"
#include "machine/dialect/refused.hpp"
#include "machine/panel/internal/hand_moves.hpp"

namespace kerf::machine {

using base::Refusal;
namespace {

// "G54" to "G59", "EXT", "G54.1 P3".
base::AxisVector* work_offset(control::Memory& memory, const std::string& name) {
  if (name == "EXT") return &memory.external;
  constexpr std::string_view kExtended = "G54.1 P";
  if (name.starts_with(kExtended)) {
    const auto number = base::read_number(name.substr(kExtended.size()));
    if (!number || *number != std::floor(*number) || *number < 1 ||
        *number > static_cast<double>(memory.extended.size()))
      return nullptr;
    return &memory.extended[static_cast<std::size_t>(*number) - 1];
  }
  if (name.size() != 3 || name[0] != 'G' || name[1] != '5' || name[2] < '4' || name[2] > '9')
    return nullptr;
  return &memory.work[static_cast<std::size_t>(name[2] - '4')];
}

// "tool.5.length_geometry"
double* tool_offset(control::Memory& memory, const std::string& name) {
  constexpr std::string_view kTool = "tool.";
  const std::size_t point = name.rfind('.');
  if (!name.starts_with(kTool) || point < kTool.size() || point == std::string::npos)
    return nullptr;
  const auto number = base::read_number(name.substr(kTool.size(), point - kTool.size()));
  if (!number || *number != std::floor(*number) || *number < 1 ||
      *number >= static_cast<double>(memory.tools.size()))
    return nullptr;
  control::ToolOffset& tool = memory.tools[static_cast<std::size_t>(*number)];
  const std::string field = name.substr(point + 1);
  if (field == "length_geometry") return &tool.length_geometry;
  if (field == "length_wear") return &tool.length_wear;
  if (field == "radius_geometry") return &tool.radius_geometry;
  if (field == "radius_wear") return &tool.radius_wear;
  return nullptr;
}

}  // namespace

Entries::Outcome Entries::enter(const SetVariable& key, LiveRun& run) {
  if (key.value && !std::isfinite(*key.value)) return refused("this is no number");
  const std::size_t level =
      key.level.value_or(innermost(run.machine().control().open_calls().size()));
  auto set =
      run.machine().language().variables().set_at(key.name, key.value.value_or(vm::kNull), level);
  if (!set) return set;
  entered_[key.name] = run.trail().motions() + 1;
  return {};
}

void Entries::show(const SetVariable& key, LiveRun& run) const {
  const auto known = entered_.find(key.name);
  if (known == entered_.end()) return;
  run.trail().enter(key.name, key.value.value_or(vm::kNull),
                    key.level.value_or(innermost(run.shown_levels())), known->second);
}

Entries::Outcome Entries::enter(const SetInput& key, LiveRun& run) {
  ProgramVariables& variables = run.machine().language().variables();
  if (!variables.is_input(key.name)) return refused(Refusal::no_input, {key.name});
  if (!std::isfinite(key.value)) return refused("this is no number");
  return variables.set(key.name, key.value);
}

Entries::Outcome Entries::enter(const SetOffset& key, LiveRun& run) {
  if (run.is_active()) return refused(Refusal::offsets_moving);
  if (!(std::fabs(key.value) <= SetOffset::kMost))
    return refused(Refusal::offset_range, {base::number_text(SetOffset::kMost)});
  PacedRun& machine = run.machine();
  if (double* const tool = tool_offset(machine.memory(), key.offset)) {
    *tool = key.value;
  } else {
    base::AxisVector* const work = work_offset(machine.memory(), key.offset);
    if (work == nullptr) return refused(Refusal::no_offset, {key.offset});
    const auto found = HandMoves::find_axis(machine.definition(), key.axis);
    if (!found) return refused(Refusal::no_axis, {key.axis});
    (*work)[*found] = key.value;
  }
  ++machine.memory().revision;
  machine.language().offsets_changed();
  return {};
}

}  // namespace kerf::machine
