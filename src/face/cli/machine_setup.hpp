#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "face/cli/commands.hpp"
#include "machine/run/stepper.hpp"
#include "machine/run/virtual_machine.hpp"

namespace kerf::cli {

/// What makes a machine ready for a program.
struct MachineSetup {
  std::string machine;  ///< name or file; empty: chosen from the program
  std::string dialect{};
  std::vector<std::string> parameters{};
  std::vector<std::string> machine_keys{};
  std::string decimal_point{};
  std::string tools{};
  std::string offsets{};
  std::string state{};
};

/// A machine with its memory filled, and how it was chosen.
struct ReadyMachine {
  std::unique_ptr<machine::VirtualMachine> machine;
  std::unique_ptr<machine::Stepper> interrupts;  ///< gives the machine its signals; null: none
  std::string why;                               ///< sentence for the summary
  /// LATHE_PROGRAM, where nobody named a machine or dialect.
  std::optional<base::Diagnostic> hint{};
};

[[nodiscard]] base::Outcome<ReadyMachine> set_up(const MachineSetup& setup,
                                                 const base::SourceFile& program);

/// Adds folders of further programs. Failure (input): one of them is no folder, or cannot be read.
[[nodiscard]] base::Outcome<void> add_libraries(const std::vector<std::string>& folders,
                                                machine::VirtualMachine& machine);

/// A machine as `kerf run` makes it from its options, the program loaded.
[[nodiscard]] base::Outcome<ReadyMachine> make_ready(const RunOptions& options);

/// How the command ends when the run ended so.
[[nodiscard]] ExitStatus exit_status_of(machine::VirtualMachine::Status status);

/// "KEY=VALUE" in two; the value may contain '='. Failure (usage) names the option.
struct KeyValue {
  std::string key;
  std::string value;
};
[[nodiscard]] base::Outcome<KeyValue> split_setting(const std::string& text,
                                                    const std::string& option);

}  // namespace kerf::cli
