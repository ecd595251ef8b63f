#pragma once

#include <map>

#include "control/laser/laser_control.hpp"
#include "lang/basic/basic_program.hpp"
#include "machine/dialect/program_variables.hpp"

namespace kerf::machine {

/// Variables of laser BASIC go by their names, in capitals or not; one that was never written reads
/// 0.
class BasicVariables final : public ProgramVariables {
 public:
  /// Both must outlive this.
  BasicVariables(basic::BasicProgram& program, control::LaserControl& control)
      : program_(program), control_(control) {}

  /// The program has started: it has what was set before.
  void begin();
  /// It has ended: what is set is for the next start.
  void end() { started_ = false; }

  [[nodiscard]] base::Outcome<Condition> compile_condition(const std::string& text) override;
  [[nodiscard]] std::optional<bool> holds(Condition& condition) override;
  [[nodiscard]] std::optional<double> value(const std::string& name, std::size_t level) override;
  [[nodiscard]] base::Outcome<void> set(const std::string& name, double value) override;
  [[nodiscard]] std::vector<Variable> all() override;
  void read(std::vector<double>& values) override;
  void put(std::vector<double>& values, const std::string& name, double value,
           std::size_t level) const override;
  [[nodiscard]] VariableListing list(std::span<const double> values, std::size_t level) override;

 private:
  [[nodiscard]] std::vector<Variable> with_values(std::span<const double> values) const;

  basic::BasicProgram& program_;
  control::LaserControl& control_;
  std::map<std::uint32_t, double> first_values_;  // from outside, before the start
  bool started_ = false;
};

}  // namespace kerf::machine
