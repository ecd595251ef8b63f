#pragma once

#include <optional>
#include <string>

#include "base/program_text.hpp"
#include "base/result.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/panel/operation.hpp"
#include "machine/run/paced_run.hpp"

namespace kerf::machine {

/// The program that is loaded, and its language.
class ProgramSlot {
 public:
  using Outcome = base::Outcome<void>;

  /// `own_dialect`: of a program that is loaded without one.
  ProgramSlot(std::string own_dialect, std::string dialect, std::optional<base::ProgramText> text)
      : own_dialect_(std::move(own_dialect)),
        dialect_(std::move(dialect)),
        text_(std::move(text)) {}

  [[nodiscard]] const std::optional<base::ProgramText>& text() const { return text_; }
  [[nodiscard]] const std::string& dialect() const { return dialect_; }
  [[nodiscard]] bool is_pattern() const;
  /// Whether it can be read and has a language of the machine.
  [[nodiscard]] Outcome check(const Load& key, const MachineDefinition& machine) const;
  void put(const Load& key);
  /// A new machine gets it, if there is one.
  [[nodiscard]] Outcome open(PacedRun& machine, Stepper& stepper) const;

 private:
  [[nodiscard]] std::string language_of(const Load& key) const;

  std::string own_dialect_;
  std::string dialect_;
  std::optional<base::ProgramText> text_;
};

}  // namespace kerf::machine
