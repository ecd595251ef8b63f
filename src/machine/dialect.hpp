#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/result.hpp"
#include "base/source_file.hpp"
#include "control/control.hpp"
#include "control/memory.hpp"
#include "control/motion.hpp"
#include "control/surroundings.hpp"
#include "lang/vm/page_store.hpp"
#include "machine/machine_definition.hpp"
#include "machine/signals.hpp"

namespace kerf::machine {

/// A variable of a program by its name in the language.
struct Variable {
  std::string name;
  double value = 0;
};

/// The language side of a machine: where the text of programs goes, and the control that executes
/// them.
class Dialect {
 public:
  /// What a dialect is made from. The references must outlive it.
  struct Around {
    const MachineDefinition& definition;
    control::Memory& memory;
    base::SourceSet& sources;
    Signals& signals;
    control::Surroundings& surroundings;
    control::MotionSink& sink;
    vm::PageSettings pages;
  };

  Dialect() = default;
  virtual ~Dialect() = default;
  Dialect(const Dialect&) = delete;
  Dialect& operator=(const Dialect&) = delete;

  /// The file whose first program is to run.
  virtual void load(base::FileId file) = 0;
  /// A folder of programs that can be called.
  virtual void add_library_folder(const std::string& folder) = 0;
  /// Name of the loaded program: "O0001", "<NAME>" without its brackets, "O0000" without either.
  [[nodiscard]] virtual std::string program_name() const = 0;
  /// Stands at the head of the loaded program. Otherwise the alarm that it raises at once.
  [[nodiscard]] virtual std::optional<base::Diagnostic> start() = 0;
  /// The reset button.
  virtual void reset() { control().reset(); }
  /// Mistakes that show without running the program.
  [[nodiscard]] virtual std::vector<base::Diagnostic> check() = 0;
  /// Before the start local variables are those of the main program. Failure (usage).
  [[nodiscard]] virtual base::Outcome<void> set_variable(const std::string& name, double value) = 0;
  /// All that are not null, in the order of the language.
  [[nodiscard]] virtual std::vector<Variable> variables() = 0;
  [[nodiscard]] virtual control::Control& control() = 0;
};

/// Names of the dialects that Kerf runs, of kDialects.
[[nodiscard]] std::vector<std::string_view> available_dialects();

/// Precondition: the name is available.
[[nodiscard]] std::unique_ptr<Dialect> make_dialect(std::string_view name,
                                                    const Dialect::Around& around);

}  // namespace kerf::machine
