#include "machine/dialect/internal/basic_variables.hpp"

#include <algorithm>

#include "base/language.hpp"
#include "lang/vm/value.hpp"
#include "machine/dialect/refused.hpp"

namespace kerf::machine {

void BasicVariables::begin() {
  for (const auto& [number, value] : first_values_) control_.set_variable(number, value);
  first_values_.clear();
  started_ = true;
}

base::Outcome<Condition> BasicVariables::compile_condition(const std::string& text) {
  if (!program_.loaded()) return refused(base::Refusal::no_program);
  auto page = program_.compile_condition(text);
  if (!page)
    return refused(base::refuse_for(page.error().number, base::Refusal::condition_wrong,
                                    {page.error().message}));
  Condition condition;
  condition.code = std::move(*page);
  return condition;
}

// A variable that was never written reads 0.
std::optional<bool> BasicVariables::holds(Condition& condition) {
  condition.evaluation =
      std::make_unique<vm::Evaluation>(*condition.code, control_.evaluation_settings(),
                                       [this](double number) { return control_.peek(number); });
  const auto value = condition.evaluation->value(control_.locals_of(0));
  if (!value) return std::nullopt;
  return vm::zero_if_null(*value) != 0;
}

std::optional<double> BasicVariables::value(const std::string& name, std::size_t /*level*/) {
  const auto number = program_.find_variable(base::capitals(name));
  if (!number) return std::nullopt;
  if (started_) return control_.variable(*number);
  const auto first = first_values_.find(*number);
  return first == first_values_.end() ? vm::kNull : first->second;
}

base::Outcome<void> BasicVariables::set(const std::string& name, double value) {
  const auto number = program_.find_variable(base::capitals(name));
  if (!number) return refused(base::Refusal::no_program_variable);
  if (started_) {
    control_.set_variable(*number, value);
  } else {
    first_values_[*number] = value;
  }
  return {};
}

void BasicVariables::read(std::vector<double>& values) {
  values.clear();
  for (std::uint32_t number = 0; number < program_.variables().size(); ++number)
    values.push_back(control_.variable(number));
}

void BasicVariables::put(std::vector<double>& values, const std::string& name, double value,
                         std::size_t /*level*/) const {
  const auto number = program_.find_variable(base::capitals(name));
  if (number && *number < values.size()) values[*number] = value;
}

VariableListing BasicVariables::list(std::span<const double> values, std::size_t /*level*/) {
  VariableListing listing;
  listing.scopes = {VariableScope::program};
  for (const Variable& variable : with_values(values))
    listing.rows.push_back({variable.name, "", variable.value, VariableScope::program, 0, false});
  return listing;
}

std::vector<Variable> BasicVariables::all() {
  std::vector<double> values;
  read(values);
  return with_values(values);
}

// Those that are not vacant, in the order of their names.
std::vector<Variable> BasicVariables::with_values(std::span<const double> values) const {
  std::vector<Variable> list;
  const std::size_t known = std::min(values.size(), program_.variables().size());
  for (std::size_t number = 0; number < known; ++number) {
    if (!vm::is_null(values[number]))
      list.push_back({program_.variables()[number], values[number]});
  }
  std::sort(list.begin(), list.end(),
            [](const Variable& a, const Variable& b) { return a.name < b.name; });
  return list;
}

}  // namespace kerf::machine
