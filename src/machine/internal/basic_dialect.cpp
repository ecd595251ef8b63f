#include "machine/internal/basic_dialect.hpp"

#include <algorithm>
#include <cctype>

#include "lang/vm/value.hpp"

namespace kerf::machine {
namespace {

std::string capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

}  // namespace

BasicDialect::BasicDialect(const Around& around)
    : program_(around.sources, around.pages),
      control_(around.definition.parameters, around.definition.axes, around.memory, program_,
               around.surroundings, around.sink) {}

std::optional<base::Diagnostic> BasicDialect::start() {
  if (!program_.loaded()) return base::make_error(base::Code::empty_program, {});
  if (!program_.findings().empty()) return program_.findings().front();
  control_.start();
  for (const auto& [number, value] : first_values_) control_.set_variable(number, value);
  first_values_.clear();
  started_ = true;
  return std::nullopt;
}

void BasicDialect::reset() {
  control_.reset();
  started_ = false;
}

std::vector<base::Diagnostic> BasicDialect::check() {
  if (!program_.loaded()) return {};
  std::vector<base::Diagnostic> found = program_.check();
  for (base::Diagnostic& diagnostic : found) diagnostic.program = program_name();
  return found;
}

base::Outcome<void> BasicDialect::set_variable(const std::string& name, double value) {
  const auto number = program_.find_variable(capitals(name));
  if (!number)
    return tl::unexpected(
        base::Failure{base::Failure::Kind::usage, "the program has no variable of this name"});
  if (started_) {
    control_.set_variable(*number, value);
  } else {
    first_values_[*number] = value;
  }
  return {};
}

std::vector<Variable> BasicDialect::variables() {
  std::vector<Variable> list;
  for (std::uint32_t number = 0; number < program_.variables().size(); ++number) {
    const double value = control_.variable(number);
    if (!vm::is_null(value)) list.push_back({program_.variables()[number], value});
  }
  std::sort(list.begin(), list.end(),
            [](const Variable& a, const Variable& b) { return a.name < b.name; });
  return list;
}

}  // namespace kerf::machine
