#include "machine/dialect/internal/gcode_variables.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "lang/gcode/condition.hpp"
#include "lang/vm/value.hpp"
#include "machine/dialect/refused.hpp"

namespace kerf::machine {
namespace {

constexpr double kMostVariable = 999999;

std::uint32_t number_of_common(std::size_t index) {
  const auto common = static_cast<std::uint32_t>(index);
  return common < gcode::kVolatileCommons ? 100 + common : 500 + common - gcode::kVolatileCommons;
}

bool is_common(std::uint32_t number) {
  return (number >= 100 && number <= 199) || (number >= 500 && number <= 999);
}

std::size_t index_of_common(std::uint32_t number) {
  return number < 500 ? number - 100 : number - 500 + gcode::kVolatileCommons;
}

}  // namespace

std::optional<std::uint32_t> GcodeVariables::number_of(const std::string& name) {
  if (name.size() < 2 || name[0] != '#') return std::nullopt;
  const auto number = base::read_number(name.substr(1));
  if (!number || *number < 0 || *number > kMostVariable || *number != std::floor(*number))
    return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

GcodeVariables::GcodeVariables(control::Memory& memory, Signals& signals,
                               gcode::CodeLibrary& library, control::GcodeControl& control)
    : memory_(memory), signals_(signals), library_(library), control_(control) {
  first_locals_.fill(vm::kNull);
}

void GcodeVariables::begin() {
  const std::span<double> locals = control_.running_locals();
  for (std::size_t i = 0; i < locals.size(); ++i) {
    if (!vm::is_null(first_locals_[i])) locals[i] = first_locals_[i];
  }
  first_locals_.fill(vm::kNull);
  started_ = true;
}

base::Outcome<Condition> GcodeVariables::compile_condition(const std::string& text) {
  auto page = gcode::compile_condition(text, library_.names());
  if (!page)
    return refused(base::refuse_for(page.error().number, base::Refusal::condition_wrong,
                                    {page.error().message}));
  Condition condition;
  condition.code = std::move(*page);
  condition.evaluation =
      std::make_unique<vm::Evaluation>(*condition.code, control_.evaluation_settings(),
                                       [this](double number) { return control_.peek(number); });
  return condition;
}

std::optional<bool> GcodeVariables::holds(Condition& condition) {
  const auto value = condition.evaluation->value(control_.running_locals());
  if (!value) return std::nullopt;
  return vm::zero_if_null(*value) != 0;
}

std::optional<double> GcodeVariables::value(const std::string& name, std::size_t level) {
  const auto number = number_of(name);
  if (!number) return std::nullopt;
  if (is_common(*number)) return memory_.commons[index_of_common(*number)];
  if (*number >= gcode::kLocals) return control_.peek(*number);
  if (level < control_.levels()) return control_.locals_of(level)[*number];
  return level == 0 ? first_locals_[*number] : vm::kNull;
}

bool GcodeVariables::is_local(const std::string& name) const {
  const auto number = number_of(name);
  return number && *number < gcode::kLocals;
}

bool GcodeVariables::is_input(const std::string& name) const {
  const auto number = number_of(name);
  return number && control::SystemVariables::is_input(*number);
}

base::Outcome<void> GcodeVariables::set_at(const std::string& name, double value,
                                           std::size_t level) {
  const auto number = number_of(name);
  if (!number) return refused(base::Refusal::no_variable_name, {name});
  if (*number == 0 || !is_local(name) || !started_) return set(name, value);
  if (level >= control_.levels()) return refused(base::Refusal::no_level);
  control_.locals_of(level)[*number] = value;
  return {};
}

// Commons, then the local variables of each level.
void GcodeVariables::read(std::vector<double>& values) {
  values.assign(memory_.commons.begin(), memory_.commons.end());
  if (control_.levels() == 0)
    values.insert(values.end(), first_locals_.begin(), first_locals_.end());
  for (std::size_t level = 0; level < control_.levels(); ++level) {
    const std::span<const double> locals = control_.locals_of(level);
    values.insert(values.end(), locals.begin(), locals.begin() + gcode::kLocals);
  }
}

void GcodeVariables::put(std::vector<double>& values, const std::string& name, double value,
                         std::size_t level) const {
  const auto number = number_of(name);
  if (!number || !is_listed(name)) return;
  const std::size_t index = is_common(*number)
                                ? index_of_common(*number)
                                : memory_.commons.size() + level * gcode::kLocals + *number;
  if (index < values.size()) values[index] = value;
}

void GcodeVariables::put_back(std::span<const double> values, control::Memory& memory) const {
  std::copy_n(values.begin(), memory.commons.size(), memory.commons.begin());
}

bool GcodeVariables::is_listed(const std::string& name) const {
  const auto number = number_of(name);
  return number && (is_common(*number) || *number < gcode::kLocals);
}

VariableListing GcodeVariables::list(std::span<const double> values, std::size_t level) {
  VariableListing listing;
  listing.scopes = {VariableScope::local, VariableScope::common, VariableScope::permanent};
  std::map<std::uint32_t, std::string> labels;
  for (const auto& [label, number] : memory_.names) labels.emplace(number, label);
  const auto put = [&](std::uint32_t number, double value, VariableScope scope) {
    const auto label = labels.find(number);
    listing.rows.push_back({"#" + std::to_string(number),
                            label == labels.end() ? "" : label->second, value, scope, level,
                            false});
  };
  const std::span<const double> commons = values.first(memory_.commons.size());
  const std::size_t locals = commons.size() + level * gcode::kLocals;
  const bool open = values.size() >= locals + gcode::kLocals;
  for (std::uint32_t number = 1; number < gcode::kLocals; ++number)
    put(number, open ? values[locals + number] : vm::kNull, VariableScope::local);
  for (std::size_t i = 0; i < commons.size(); ++i) {
    const bool is_volatile = i < gcode::kVolatileCommons;
    const auto number = static_cast<std::uint32_t>(is_volatile ? 100 + i : 400 + i);
    if (vm::is_null(commons[i]) && !labels.contains(number)) continue;
    put(number, commons[i], is_volatile ? VariableScope::common : VariableScope::permanent);
  }
  return listing;
}

base::Outcome<void> GcodeVariables::set(const std::string& name, double value) {
  const auto number = number_of(name);
  if (!number)
    return tl::unexpected(base::Failure{base::Failure::Kind::usage, "'#NUMBER=VALUE' is expected"});
  if (const auto set = signals_.set(*number, value)) return *set;
  if (!started_ && *number > 0 && *number < gcode::kLocals) {
    first_locals_[*number] = value;
    return {};
  }
  return control_.set_variable(*number, value);
}

std::vector<Variable> GcodeVariables::all() {
  std::vector<Variable> list;
  const auto put = [&](std::size_t number, double value) {
    if (!vm::is_null(value)) list.push_back({"#" + std::to_string(number), value});
  };
  const std::span<double> locals = control_.first_level_locals();
  for (std::size_t i = 1; i < locals.size(); ++i) put(i, locals[i]);
  for (std::size_t i = 0; i < memory_.commons.size(); ++i)
    put(number_of_common(i), memory_.commons[i]);
  return list;
}

}  // namespace kerf::machine
