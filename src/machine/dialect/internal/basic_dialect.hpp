#pragma once

#include "control/laser/laser_control.hpp"
#include "lang/basic/basic_program.hpp"
#include "machine/dialect/dialect.hpp"
#include "machine/dialect/internal/basic_variables.hpp"

namespace kerf::machine {

/// Laser BASIC. A program is one file and calls no others. An entry in MDI is a program of its own:
/// variables of the one before it are gone.
class BasicDialect final : public Dialect {
 public:
  explicit BasicDialect(const Around& around);

  [[nodiscard]] std::string program_name() const override { return control::LaserControl::kName; }
  [[nodiscard]] std::optional<base::Diagnostic> start() override;
  void reset() override;
  void check(base::Findings& found) override;
  [[nodiscard]] control::Control& control() override { return control_; }
  [[nodiscard]] const control::Control& control() const override { return control_; }
  [[nodiscard]] ProgramVariables& variables() override { return variables_; }
  [[nodiscard]] const ProgramVariables& variables() const override { return variables_; }

 private:
  void load_file(base::FileId file) override { program_.load(file); }

  basic::BasicProgram program_;
  control::LaserControl control_;
  BasicVariables variables_;
};

}  // namespace kerf::machine
