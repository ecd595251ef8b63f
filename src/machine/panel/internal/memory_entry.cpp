// Variables and offsets that an operator enters.
#include <cmath>

#include "base/decimal.hpp"
#include "lang/vm/value.hpp"
#include "machine/dialect/refused.hpp"
#include "machine/panel/internal/live_core.hpp"

namespace kerf::machine {

using base::Refusal;
namespace {

constexpr double kMostOffset_mm = 999999.999;

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

LiveCore::Outcome LiveCore::set_variable(const std::string& name, std::optional<double> value,
                                         std::optional<std::size_t> level) {
  if (machine_->language().variables().is_input(name)) return set_input(name, value.value_or(0));
  if (!stands()) return refused(Refusal::variables_moving);
  const std::size_t wanted = level.value_or(shown_level());
  if (auto set = enter_variable(name, value, level); !set) return set;
  return show_variable(name, value, wanted);
}

LiveCore::Outcome LiveCore::enter_variable(const std::string& name, std::optional<double> value,
                                           std::optional<std::size_t> level) {
  if (value && !std::isfinite(*value)) return refused("this is no number");
  const std::size_t levels = machine_->control().open_calls().size();
  const std::size_t innermost = levels == 0 ? 0 : levels - 1;
  auto set = machine_->language().variables().set_at(name, value.value_or(vm::kNull),
                                                     level.value_or(innermost));
  if (!set) return set;
  entered_[name] = trail_->motions() + 1;
  stepper_->forget_values();
  ++changes_;
  return {};
}

LiveCore::Outcome LiveCore::show_variable(const std::string& name, std::optional<double> value,
                                          std::optional<std::size_t> level) {
  const auto known = entered_.find(name);
  if (known == entered_.end()) return {};
  trail_->enter(name, value.value_or(vm::kNull), level.value_or(shown_level()), known->second);
  return {};
}

LiveCore::Outcome LiveCore::set_input(const std::string& name, double value) {
  if (!machine_->language().variables().is_input(name)) return refused(Refusal::no_input, {name});
  if (!std::isfinite(value)) return refused("this is no number");
  return machine_->language().variables().set(name, value);
}

LiveCore::Outcome LiveCore::set_offset(const std::string& offset, const std::string& axis,
                                       double value) {
  if (is_active()) return refused(Refusal::offsets_moving);
  if (!(std::fabs(value) <= kMostOffset_mm))
    return refused(Refusal::offset_range, {base::number_text(kMostOffset_mm)});
  if (double* const tool = tool_offset(machine_->memory(), offset)) {
    *tool = value;
  } else {
    base::AxisVector* const work = work_offset(machine_->memory(), offset);
    if (work == nullptr) return refused(Refusal::no_offset, {offset});
    const auto found = find_axis(axis);
    if (!found) return refused(Refusal::no_axis, {axis});
    (*work)[*found] = value;
  }
  ++machine_->memory().revision;
  machine_->language().offsets_changed();
  ++changes_;
  return {};
}

}  // namespace kerf::machine
