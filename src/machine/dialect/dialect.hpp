#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/findings.hpp"
#include "base/result.hpp"
#include "base/source_file.hpp"
#include "control/core/control.hpp"
#include "control/core/memory.hpp"
#include "control/core/surroundings.hpp"
#include "lang/vm/page_store.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/dialect/condition.hpp"
#include "machine/dialect/pattern_queue.hpp"
#include "machine/dialect/signals.hpp"
#include "machine/dialect/variable_listing.hpp"
#include "motion/motion.hpp"

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
    motion::MotionSink& sink;
    vm::PageSettings pages;
    PatternQueue& records;  ///< of a pattern
  };

  explicit Dialect(const base::SourceSet& sources) : sources_(sources) {}
  virtual ~Dialect() = default;
  Dialect(const Dialect&) = delete;
  Dialect& operator=(const Dialect&) = delete;

  /// The file whose first program is to run.
  void load(base::FileId file) {
    main_file_ = file;
    load_file(file);
  }
  /// Whether a file goes by this name, or by what its name ends in behind a slash.
  [[nodiscard]] bool is_file(const std::string& name, base::FileId file) const;
  /// The one that was loaded.
  [[nodiscard]] base::FileId main_file() const { return main_file_; }
  /// A folder of programs that can be called.
  virtual void add_library_folder(const std::string& folder) = 0;
  /// Name of the loaded program: "O0001", "<NAME>" without its brackets, "O0000" without either.
  [[nodiscard]] virtual std::string program_name() const = 0;
  /// Stands at the head of the loaded program. Otherwise the alarm that it raises at once.
  [[nodiscard]] virtual std::optional<base::Diagnostic> start() = 0;
  /// The same in spite of mistakes in the structure of the file, if there is a head to stand at.
  [[nodiscard]] virtual std::optional<base::Diagnostic> start_all_the_same() { return start(); }
  /// The reset button.
  virtual void reset() { control().reset(); }
  /// Mistakes that show without running the program. Ends early when `found` is over().
  virtual void check(base::Findings& found) = 0;
  /// Stands at the head of an entry in MDI, whose end is the end of its text; programs that it
  /// calls are those that are loaded. Otherwise the alarm that it raises at once.
  [[nodiscard]] virtual std::optional<base::Diagnostic> start_entry(base::FileId file) = 0;
  /// What a program leaves behind besides memory and position: the shift of G92.
  [[nodiscard]] virtual base::AxisVector shift() const { return {}; }
  virtual void set_shift(const base::AxisVector& /*shift*/) {}
  /// Offsets in the memory were changed by the operator.
  virtual void offsets_changed() {}

  /// A condition of a breakpoint. Failure (usage): it is none in this language.
  [[nodiscard]] virtual base::Outcome<Condition> compile_condition(const std::string& text) = 0;
  /// Whether it holds where the program stands; nothing: it has no value there.
  [[nodiscard]] virtual std::optional<bool> holds(Condition& condition) = 0;
  /// A variable by its name, vm::kNull where it is vacant; nothing: there is none of this name.
  /// `level` of the calls, 0: main.
  [[nodiscard]] virtual std::optional<double> variable(const std::string& name,
                                                       std::size_t level) = 0;
  /// Whether each level of the calls has a variable of this name of its own.
  [[nodiscard]] virtual bool is_local(const std::string& /*name*/) const { return false; }
  /// Whether it is a signal from outside, which can come at any time.
  [[nodiscard]] virtual bool is_input(const std::string& /*name*/) const { return false; }
  /// Failure (usage): why not.
  [[nodiscard]] virtual base::Outcome<void> set_variable_at(const std::string& name, double value,
                                                            std::size_t level) = 0;
  /// The values of all variables that can be listed, of every level.
  virtual void read_variables(std::vector<double>& values) = 0;
  /// Puts a variable among values that were read; they may have none of this name.
  virtual void put_variable(std::vector<double>& /*values*/, const std::string& /*name*/,
                            double /*value*/, std::size_t /*level*/) const {}
  /// What the memory holds of these variables becomes what was read of them.
  virtual void put_back(std::span<const double> /*values*/, control::Memory& /*memory*/) const {}
  /// Whether list_variables() has a variable of this name unless it is vacant.
  [[nodiscard]] virtual bool is_listed(const std::string& /*name*/) const { return false; }
  /// The variables of a level at the moment whose values were read; `changed` and `levels` left
  /// out.
  [[nodiscard]] virtual VariableListing list_variables(std::span<const double> values,
                                                       std::size_t level) = 0;

  /// Before the start local variables are those of the main program. Failure (usage).
  [[nodiscard]] virtual base::Outcome<void> set_variable(const std::string& name, double value) = 0;
  /// All that are not null, in the order of the language.
  [[nodiscard]] virtual std::vector<Variable> variables() = 0;
  [[nodiscard]] virtual control::Control& control() = 0;
  [[nodiscard]] virtual const control::Control& control() const = 0;

 protected:
  virtual void load_file(base::FileId file) = 0;

 private:
  const base::SourceSet& sources_;
  base::FileId main_file_ = base::kNoFile;
};

/// Names of the dialects that Kerf runs, of kDialects.
[[nodiscard]] std::vector<std::string_view> available_dialects();

/// Failure (usage): the machine has no control for this dialect, or Kerf does not run it.
[[nodiscard]] base::Outcome<void> check_dialect(const MachineDefinition& machine,
                                                std::string_view dialect);

/// Precondition: check_dialect() of that machine has nothing against it.
[[nodiscard]] std::unique_ptr<Dialect> make_dialect(std::string_view name,
                                                    const Dialect::Around& around);

}  // namespace kerf::machine
