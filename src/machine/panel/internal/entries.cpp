#include "machine/panel/internal/entries.hpp"

#include <cmath>

#include "base/decimal.hpp"
#include "control/core/offset_parts.hpp"
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
struct ToolPart {
  std::string number;
  std::string part;
};
std::optional<ToolPart> tool_part(const std::string& name) {
  constexpr std::string_view kTool = "tool.";
  const std::size_t point = name.rfind('.');
  if (!name.starts_with(kTool) || point < kTool.size()) return std::nullopt;
  return ToolPart{name.substr(kTool.size(), point - kTool.size()), name.substr(point + 1)};
}

// The row 0 is no offset.
template <typename Row>
Row* row_of(std::vector<Row>& rows, const std::string& number) {
  const auto value = base::read_whole_number(number);
  return value && *value >= 1 && *value < rows.size() ? &rows[*value] : nullptr;
}

template <typename Row>
Entries::Outcome set_part(std::vector<Row>& rows, const ToolPart& tool, const SetOffset& key) {
  const auto* const part = control::part_named<Row>(tool.part);
  Row* const row = row_of(rows, tool.number);
  if (part == nullptr || row == nullptr) return refused(Refusal::no_offset, {key.offset});
  if (!part->takes(key.value))
    return refused(Refusal::offset_whole, {tool.part, std::to_string(part->most_whole)});
  part->of(*row) = key.value;
  return {};
}

Entries::Outcome set_tool(PacedRun& machine, const ToolPart& tool, const SetOffset& key) {
  control::Memory& memory = machine.memory();
  return machine.definition().turns() ? set_part(memory.turning, tool, key)
                                      : set_part(memory.tools, tool, key);
}

Entries::Outcome set_work(PacedRun& machine, const SetOffset& key) {
  base::AxisVector* const work = work_offset(machine.memory(), key.offset);
  if (work == nullptr) return refused(Refusal::no_offset, {key.offset});
  const auto found = HandMoves::find_axis(machine.definition(), key.axis);
  if (!found) return refused(Refusal::no_axis, {key.axis});
  (*work)[*found] = key.value;
  return {};
}

std::optional<base::Failure> keeps_from_offsets(const LiveRun& run, double value) {
  if (run.is_active()) return base::refuse(Refusal::offsets_moving);
  if (!(std::fabs(value) <= SetOffset::kMost))
    return base::refuse(Refusal::offset_range, {base::number_text(SetOffset::kMost)});
  return std::nullopt;
}

void tell_change(PacedRun& machine) {
  ++machine.memory().revision;
  machine.language().offsets_changed();
}

// Where the axes stand as positions count, from the zero of the work system and without any tool
// offset.
base::AxisVector standing(LiveRun& run) {
  const PacedRun& machine = run.machine();
  const base::MachinePoint at =
      base::machine_of(run.last().tip, run.machine().control().tool_length());
  return machine.definition().axes.counted(at.numbers() - run.machine().control().work_origin());
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
  if (auto why = keeps_from_offsets(run, key.value)) return tl::unexpected(std::move(*why));
  PacedRun& machine = run.machine();
  const auto tool = tool_part(key.offset);
  auto set = tool ? set_tool(machine, *tool, key) : set_work(machine, key);
  if (set) tell_change(machine);
  return set;
}

Entries::Outcome Entries::enter(const MeasureOffset& key, LiveRun& run) {
  if (auto why = keeps_from_offsets(run, key.reads)) return tl::unexpected(std::move(*why));
  PacedRun& machine = run.machine();
  const std::string number = std::to_string(key.number);
  auto* const row = row_of(machine.memory().turning, number);
  if (row == nullptr || !machine.definition().turns())
    return refused(Refusal::no_offset, {"tool." + number});
  const auto axis = HandMoves::find_axis(machine.definition(), key.axis);
  const std::string letter = key.axis == "X" ? "x" : key.axis == "Y" ? "y" : "z";
  if (!axis || (letter == "z" && key.axis != "Z")) return refused(Refusal::no_axis, {key.axis});
  const double wear = control::part_named<control::TurningOffset>("wear_" + letter)->value(*row);
  control::part_named<control::TurningOffset>("geometry_" + letter)->of(*row) =
      base::tidy(standing(run)[*axis] - key.reads - wear);
  tell_change(machine);
  return {};
}

}  // namespace kerf::machine
