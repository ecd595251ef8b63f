#pragma once

#include <map>

#include "control/records/records_control.hpp"
#include "machine/dialect/dialect.hpp"

namespace kerf::machine {

/// Motion records (docs/motions.md). A program has no variables and calls nothing.
class MotionDialect final : public Dialect, private records::FileNames {
 public:
  explicit MotionDialect(const Around& around);

  [[nodiscard]] std::string program_name() const override { return name_; }
  [[nodiscard]] std::optional<base::Diagnostic> start() override;
  void check(base::Findings& found) override;
  [[nodiscard]] control::RecordsControl& control() override { return control_; }
  [[nodiscard]] const control::Control& control() const override { return control_; }
  [[nodiscard]] ProgramVariables& variables() override { return variables_; }
  [[nodiscard]] const ProgramVariables& variables() const override { return variables_; }

 private:
  /// Files that records may name.
  static constexpr std::size_t kMostFiles = 1000;

  void load_file(base::FileId file) override;
  // records::FileNames
  [[nodiscard]] base::FileId id_of(const std::string& name) override;

  base::SourceSet& sources_;
  std::map<std::string, base::FileId> files_;
  records::RecordsLibrary library_;
  control::RecordsControl control_;
  std::string name_ = base::kUnnumberedProgram;
  NoVariables variables_{base::Refusal::motion_variables, base::Refusal::motion_conditions};
};

}  // namespace kerf::machine
