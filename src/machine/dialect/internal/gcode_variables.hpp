#pragma once

#include <array>
#include <map>

#include "control/gcode/gcode_control.hpp"
#include "lang/gcode/code_library.hpp"
#include "machine/dialect/program_variables.hpp"
#include "machine/dialect/signals.hpp"

namespace kerf::machine {

/// Variables of G-code are "#100", input bits and the calendar included.
class GcodeVariables final : public ProgramVariables {
 public:
  /// All must outlive this.
  GcodeVariables(control::Memory& memory, Signals& signals, gcode::CodeLibrary& library,
                 control::GcodeControl& control);

  /// A program has started: its main level has what was set before.
  void begin();
  /// An entry has: what was set is not for it.
  void begin_entry() { started_ = true; }
  void end() { started_ = false; }

  /// The number behind '#', or nothing.
  [[nodiscard]] static std::optional<std::uint32_t> number_of(const std::string& name);

  [[nodiscard]] base::Outcome<Condition> compile_condition(const std::string& text) override;
  [[nodiscard]] std::optional<bool> holds(Condition& condition) override;
  [[nodiscard]] std::optional<double> value(const std::string& name, std::size_t level) override;
  [[nodiscard]] bool is_local(const std::string& name) const override;
  [[nodiscard]] bool is_input(const std::string& name) const override;
  [[nodiscard]] base::Outcome<void> set(const std::string& name, double value) override;
  [[nodiscard]] base::Outcome<void> set_at(const std::string& name, double value,
                                           std::size_t level) override;
  [[nodiscard]] std::vector<Variable> all() override;
  void read(std::vector<double>& values) override;
  void put(std::vector<double>& values, const std::string& name, double value,
           std::size_t level) const override;
  void put_back(std::span<const double> values, control::Memory& memory) const override;
  [[nodiscard]] bool is_listed(const std::string& name) const override;
  [[nodiscard]] VariableListing list(std::span<const double> values, std::size_t level) override;

 private:
  control::Memory& memory_;
  Signals& signals_;
  gcode::CodeLibrary& library_;
  control::GcodeControl& control_;
  std::array<double, gcode::kLocals> first_locals_;  // of the main program, from outside
  bool started_ = false;
};

}  // namespace kerf::machine
