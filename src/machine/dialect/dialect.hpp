#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/findings.hpp"
#include "base/program_name.hpp"
#include "base/result.hpp"
#include "base/source_file.hpp"
#include "control/core/control.hpp"
#include "control/core/memory.hpp"
#include "control/core/surroundings.hpp"
#include "control/plan/motion_maker.hpp"
#include "lang/vm/page_store.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/dialect/pattern_queue.hpp"
#include "machine/dialect/program_variables.hpp"
#include "machine/dialect/signals.hpp"
#include "motion/motion.hpp"

namespace kerf::machine {

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
    /// Motions that were planned, in place of a program; null: there are none.
    std::shared_ptr<const control::MotionMaker> plan{};
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
  virtual void add_library_folder(const std::string& /*folder*/) {}
  /// Name of the loaded program: "O0001", "<NAME>" without its brackets, "O0000" without either.
  [[nodiscard]] virtual std::string program_name() const { return base::kUnnumberedProgram; }
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
  [[nodiscard]] virtual std::optional<base::Diagnostic> start_entry(base::FileId file) {
    load_file(file);
    return start();
  }
  /// What a program leaves behind besides memory and position: the shift of G92.
  [[nodiscard]] virtual base::AxisVector shift() const { return {}; }
  virtual void set_shift(const base::AxisVector& /*shift*/) {}
  /// Offsets in the memory were changed by the operator.
  virtual void offsets_changed() {}

  [[nodiscard]] virtual ProgramVariables& variables() = 0;
  [[nodiscard]] virtual const ProgramVariables& variables() const = 0;
  [[nodiscard]] virtual control::Control& control() = 0;
  [[nodiscard]] virtual const control::Control& control() const = 0;

 protected:
  virtual void load_file(base::FileId file) = 0;

 private:
  const base::SourceSet& sources_;
  base::FileId main_file_ = base::kNoFile;
};

/// Failure (usage): the machine has no control for this dialect, or Kerf does not run it.
[[nodiscard]] base::Outcome<void> check_dialect(const MachineDefinition& machine,
                                                std::string_view dialect);

/// Precondition: check_dialect() of that machine has nothing against it.
[[nodiscard]] std::unique_ptr<Dialect> make_dialect(std::string_view name,
                                                    const Dialect::Around& around);

}  // namespace kerf::machine
