// What a stepper asks of a FANUC program: conditions, and variables by level.
#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "lang/gcode/condition.hpp"
#include "lang/vm/value.hpp"
#include "machine/dialect/internal/gcode_dialect.hpp"
#include "machine/dialect/refused.hpp"

namespace kerf::machine {
namespace {

bool is_common(std::uint32_t number) {
  return (number >= 100 && number <= 199) || (number >= 500 && number <= 999);
}

std::size_t index_of_common(std::uint32_t number) {
  return number < 500 ? number - 100 : number - 500 + gcode::kVolatileCommons;
}

}  // namespace

base::Outcome<Condition> GcodeDialect::compile_condition(const std::string& text) {
  auto page = gcode::compile_condition(text, library_.names());
  if (!page)
    return refused(base::refuse_for(page.error().number, base::Refusal::condition_wrong,
                                    {page.error().message}));
  Condition condition;
  condition.code = std::move(*page);
  condition.evaluation =
      std::make_unique<vm::Evaluation>(*condition.code, controller_.evaluation_settings(),
                                       [this](double number) { return controller_.peek(number); });
  return condition;
}

std::optional<bool> GcodeDialect::holds(Condition& condition) {
  const auto value = condition.evaluation->value(controller_.running_locals());
  if (!value) return std::nullopt;
  return vm::zero_if_null(*value) != 0;
}

std::optional<double> GcodeDialect::variable(const std::string& name, std::size_t level) {
  const auto number = number_of_variable(name);
  if (!number) return std::nullopt;
  if (is_common(*number)) return memory_.commons[index_of_common(*number)];
  if (*number >= gcode::kLocals) return controller_.peek(*number);
  if (level < controller_.levels()) return controller_.locals_of(level)[*number];
  return level == 0 ? first_locals_[*number] : vm::kNull;
}

bool GcodeDialect::is_local(const std::string& name) const {
  const auto number = number_of_variable(name);
  return number && *number < gcode::kLocals;
}

bool GcodeDialect::is_input(const std::string& name) const {
  const auto number = number_of_variable(name);
  return number && control::SystemVariables::is_input(*number);
}

base::Outcome<void> GcodeDialect::set_variable_at(const std::string& name, double value,
                                                  std::size_t level) {
  const auto number = number_of_variable(name);
  if (!number) return refused(base::Refusal::no_variable_name, {name});
  if (*number == 0 || !is_local(name) || !started_) return set_variable(name, value);
  if (level >= controller_.levels()) return refused(base::Refusal::no_level);
  controller_.locals_of(level)[*number] = value;
  return {};
}

// Commons, then the local variables of each level.
void GcodeDialect::read_variables(std::vector<double>& values) {
  values.assign(memory_.commons.begin(), memory_.commons.end());
  if (controller_.levels() == 0)
    values.insert(values.end(), first_locals_.begin(), first_locals_.end());
  for (std::size_t level = 0; level < controller_.levels(); ++level) {
    const std::span<const double> locals = controller_.locals_of(level);
    values.insert(values.end(), locals.begin(), locals.begin() + gcode::kLocals);
  }
}

void GcodeDialect::put_variable(std::vector<double>& values, const std::string& name, double value,
                                std::size_t level) const {
  const auto number = number_of_variable(name);
  if (!number || !is_listed(name)) return;
  const std::size_t index = is_common(*number)
                                ? index_of_common(*number)
                                : memory_.commons.size() + level * gcode::kLocals + *number;
  if (index < values.size()) values[index] = value;
}

void GcodeDialect::put_back(std::span<const double> values, control::Memory& memory) const {
  std::copy_n(values.begin(), memory.commons.size(), memory.commons.begin());
}

bool GcodeDialect::is_listed(const std::string& name) const {
  const auto number = number_of_variable(name);
  return number && (is_common(*number) || *number < gcode::kLocals);
}

VariableListing GcodeDialect::list_variables(std::span<const double> values, std::size_t level) {
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

}  // namespace kerf::machine
