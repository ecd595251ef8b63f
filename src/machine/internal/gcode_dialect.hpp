#pragma once

#include <array>

#include "control/controller.hpp"
#include "lang/gcode/code_library.hpp"
#include "machine/dialect.hpp"
#include "machine/program_shelf.hpp"

namespace kerf::machine {

/// FANUC G-code with Custom Macro B. Variables are "#100", input bits and the calendar included.
class GcodeDialect final : public Dialect {
 public:
  explicit GcodeDialect(const Around& around);

  void load(base::FileId file) override;
  void add_library_folder(const std::string& folder) override { shelf_.add_folder(folder); }
  [[nodiscard]] std::string program_name() const override;
  [[nodiscard]] std::optional<base::Diagnostic> start() override;
  void reset() override;
  [[nodiscard]] std::vector<base::Diagnostic> check() override;
  [[nodiscard]] base::Outcome<void> set_variable(const std::string& name, double value) override;
  [[nodiscard]] std::vector<Variable> variables() override;
  [[nodiscard]] control::Controller& control() override { return controller_; }

 private:
  control::Memory& memory_;
  base::SourceSet& sources_;
  Signals& signals_;
  gcode::CodeLibrary library_;
  ProgramShelf shelf_;
  control::Controller controller_;
  base::FileId main_file_ = base::kNoFile;
  std::array<double, gcode::kLocals> first_locals_;  // of the main program, from outside
  bool started_ = false;
};

}  // namespace kerf::machine
