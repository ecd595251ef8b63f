#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/interface.hpp"
#include "base/refusal.hpp"
#include "base/result.hpp"
#include "control/core/memory.hpp"
#include "machine/dialect/condition.hpp"
#include "machine/dialect/variable_listing.hpp"

namespace kerf::machine {

/// A variable of a program by its name in the language.
struct Variable {
  std::string name;
  double value = 0;
};

/// The variables of a program as whoever watches it names them, and conditions on them.
class ProgramVariables : public base::Interface {
 public:
  /// A condition of a breakpoint. Failure (usage): it is none in this language.
  [[nodiscard]] virtual base::Outcome<Condition> compile_condition(const std::string& text) = 0;
  /// Whether it holds where the program stands; nothing: it has no value there.
  [[nodiscard]] virtual std::optional<bool> holds(Condition& condition) = 0;
  /// A variable by its name, vm::kNull where it is vacant; nothing: there is none of this name.
  /// `level` of the calls, 0: main.
  [[nodiscard]] virtual std::optional<double> value(const std::string& name, std::size_t level) = 0;
  /// Whether each level of the calls has a variable of this name of its own.
  [[nodiscard]] virtual bool is_local(const std::string& /*name*/) const { return false; }
  /// Whether it is a signal from outside, which can come at any time.
  [[nodiscard]] virtual bool is_input(const std::string& /*name*/) const { return false; }
  /// Before the start local variables are those of the main program. Failure (usage): why not.
  [[nodiscard]] virtual base::Outcome<void> set(const std::string& name, double value) = 0;
  [[nodiscard]] virtual base::Outcome<void> set_at(const std::string& name, double value,
                                                   std::size_t /*level*/) {
    return set(name, value);
  }

  /// All that are not null, in the order of the language.
  [[nodiscard]] virtual std::vector<Variable> all() = 0;
  /// The values of all variables that can be listed, of every level.
  virtual void read(std::vector<double>& values) = 0;
  /// Puts a variable among values that were read; they may have none of this name.
  virtual void put(std::vector<double>& /*values*/, const std::string& /*name*/, double /*value*/,
                   std::size_t /*level*/) const {}
  /// What the memory holds of these variables becomes what was read of them.
  virtual void put_back(std::span<const double> /*values*/, control::Memory& /*memory*/) const {}
  /// Whether list() has a variable of this name unless it is vacant.
  [[nodiscard]] virtual bool is_listed(const std::string& /*name*/) const { return false; }
  /// The variables of a level at the moment whose values were read; `changed` and `levels` left
  /// out.
  [[nodiscard]] virtual VariableListing list(std::span<const double> values, std::size_t level) = 0;
};

/// Of a language without variables: there is nothing to see, and what would be set is refused with
/// the words of the language.
class NoVariables final : public ProgramVariables {
 public:
  /// `variables` refuses to set one, `conditions` a breakpoint with a condition.
  NoVariables(base::Refusal variables, base::Refusal conditions)
      : variables_(variables), conditions_(conditions) {}

  [[nodiscard]] base::Outcome<Condition> compile_condition(const std::string& text) override;
  [[nodiscard]] std::optional<bool> holds(Condition& condition) override;
  [[nodiscard]] std::optional<double> value(const std::string& name, std::size_t level) override;
  [[nodiscard]] base::Outcome<void> set(const std::string& name, double value) override;
  [[nodiscard]] std::vector<Variable> all() override { return {}; }
  void read(std::vector<double>& values) override { values.clear(); }
  [[nodiscard]] VariableListing list(std::span<const double> values, std::size_t level) override;

 private:
  base::Refusal variables_;
  base::Refusal conditions_;
};

}  // namespace kerf::machine
