#pragma once

#include <map>

#include "control/laser/laser_control.hpp"
#include "lang/basic/basic_program.hpp"
#include "machine/dialect/dialect.hpp"

namespace kerf::machine {

/// Laser BASIC. A program is one file and calls no others; its variables go by their names, in
/// capitals or not.
class BasicDialect final : public Dialect {
 public:
  explicit BasicDialect(const Around& around);

  void add_library_folder(const std::string& /*folder*/) override {}
  [[nodiscard]] std::string program_name() const override { return control::LaserControl::kName; }
  [[nodiscard]] std::optional<base::Diagnostic> start() override;
  [[nodiscard]] std::optional<base::Diagnostic> start_entry(base::FileId file) override;
  [[nodiscard]] base::Outcome<Condition> compile_condition(const std::string& text) override;
  [[nodiscard]] std::optional<bool> holds(Condition& condition) override;
  [[nodiscard]] std::optional<double> variable(const std::string& name, std::size_t level) override;
  [[nodiscard]] base::Outcome<void> set_variable_at(const std::string& name, double value,
                                                    std::size_t level) override;
  void read_variables(std::vector<double>& values) override;
  void put_variable(std::vector<double>& values, const std::string& name, double value,
                    std::size_t level) const override;
  [[nodiscard]] VariableListing list_variables(std::span<const double> values,
                                               std::size_t level) override;
  void reset() override;
  void check(base::Findings& found) override;
  [[nodiscard]] base::Outcome<void> set_variable(const std::string& name, double value) override;
  [[nodiscard]] std::vector<Variable> variables() override;
  [[nodiscard]] control::Control& control() override { return control_; }
  [[nodiscard]] const control::Control& control() const override { return control_; }

 private:
  void load_file(base::FileId file) override { program_.load(file); }
  [[nodiscard]] std::vector<Variable> with_values(std::span<const double> values) const;
  basic::BasicProgram program_;
  control::LaserControl control_;
  std::map<std::uint32_t, double> first_values_;  // from outside, before the start
  bool started_ = false;
};

}  // namespace kerf::machine
