#pragma once

#include <array>
#include <map>

#include "control/gcode/gcode_control.hpp"
#include "lang/gcode/code_library.hpp"
#include "machine/dialect/dialect.hpp"
#include "machine/dialect/program_shelf.hpp"

namespace kerf::machine {

/// FANUC G-code with Custom Macro B. Variables are "#100", input bits and the calendar included.
class GcodeDialect final : public Dialect {
 public:
  explicit GcodeDialect(const Around& around);

  void add_library_folder(const std::string& folder) override { shelf_.add_folder(folder); }
  [[nodiscard]] std::string program_name() const override;
  [[nodiscard]] std::optional<base::Diagnostic> start() override;
  [[nodiscard]] std::optional<base::Diagnostic> start_all_the_same() override;
  [[nodiscard]] std::optional<base::Diagnostic> start_entry(base::FileId file) override;
  [[nodiscard]] base::Outcome<Condition> compile_condition(const std::string& text) override;
  [[nodiscard]] std::optional<bool> holds(Condition& condition) override;
  [[nodiscard]] std::optional<double> variable(const std::string& name, std::size_t level) override;
  [[nodiscard]] base::Outcome<void> set_variable_at(const std::string& name, double value,
                                                    std::size_t level) override;
  [[nodiscard]] bool is_local(const std::string& name) const override;
  [[nodiscard]] bool is_input(const std::string& name) const override;
  void read_variables(std::vector<double>& values) override;
  void put_variable(std::vector<double>& values, const std::string& name, double value,
                    std::size_t level) const override;
  void put_back(std::span<const double> values, control::Memory& memory) const override;
  [[nodiscard]] bool is_listed(const std::string& name) const override;
  [[nodiscard]] VariableListing list_variables(std::span<const double> values,
                                               std::size_t level) override;
  [[nodiscard]] base::AxisVector shift() const override {
    return controller_.coordinates().shift();
  }
  void set_shift(const base::AxisVector& shift) override { controller_.set_shift(shift); }
  void offsets_changed() override { controller_.offsets_changed(); }
  void reset() override;
  void check(base::Findings& found) override;
  [[nodiscard]] base::Outcome<void> set_variable(const std::string& name, double value) override;
  [[nodiscard]] std::vector<Variable> variables() override;
  [[nodiscard]] control::GcodeControl& control() override { return controller_; }
  [[nodiscard]] const control::Control& control() const override { return controller_; }

  /// The number behind '#', or nothing.
  [[nodiscard]] static std::optional<std::uint32_t> number_of_variable(const std::string& name);

 private:
  void load_file(base::FileId file) override;
  void tell_unread_text();
  control::Memory& memory_;
  base::SourceSet& sources_;
  Signals& signals_;
  gcode::CodeLibrary library_;
  ProgramShelf shelf_;
  control::GcodeControl controller_;
  std::array<double, gcode::kLocals> first_locals_;  // of the main program, from outside
  bool started_ = false;
};

}  // namespace kerf::machine
