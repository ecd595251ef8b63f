#pragma once

#include "control/gcode/gcode_control.hpp"
#include "lang/gcode/code_library.hpp"
#include "machine/dialect/dialect.hpp"
#include "machine/dialect/internal/gcode_variables.hpp"
#include "machine/dialect/program_shelf.hpp"

namespace kerf::machine {

/// FANUC G-code with Custom Macro B.
class GcodeDialect final : public Dialect {
 public:
  /// `codes`: what the codes of its programs mean.
  GcodeDialect(const Around& around, const control::CodeTable& codes);

  void add_library_folder(const std::string& folder) override { shelf_.add_folder(folder); }
  [[nodiscard]] std::string program_name() const override;
  [[nodiscard]] std::optional<base::Diagnostic> start() override;
  [[nodiscard]] std::optional<base::Diagnostic> start_all_the_same() override;
  [[nodiscard]] std::optional<base::Diagnostic> start_entry(base::FileId file) override;
  [[nodiscard]] base::AxisVector shift() const override { return control_.coordinates().shift(); }
  void set_shift(const base::AxisVector& shift) override { control_.set_shift(shift); }
  void offsets_changed() override { control_.offsets_changed(); }
  void reset() override;
  void check(base::Findings& found) override;
  [[nodiscard]] control::GcodeControl& control() override { return control_; }
  [[nodiscard]] const control::Control& control() const override { return control_; }
  [[nodiscard]] ProgramVariables& variables() override { return variables_; }
  [[nodiscard]] const ProgramVariables& variables() const override { return variables_; }

 private:
  void load_file(base::FileId file) override;
  void tell_unread_text();

  base::SourceSet& sources_;
  gcode::CodeLibrary library_;
  ProgramShelf shelf_;
  control::GcodeControl control_;
  GcodeVariables variables_;
};

}  // namespace kerf::machine
