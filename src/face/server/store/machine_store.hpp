#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "control/core/memory.hpp"
#include "machine/definition/machine_definition.hpp"

namespace kerf::server {

/// The program that a machine has loaded, as it is kept: one of the library, or a text.
struct LoadedProgram {
  std::string name;
  std::optional<std::string> text{};  ///< nothing: it is in the library
  std::string dialect{};              ///< empty: that of the machine
};

/// A machine as it is kept on disk.
struct StoredMachine {
  std::string name;
  std::string kind;  ///< the built-in machine that it was made from
  std::string toml;  ///< its machine file
  machine::MachineDefinition definition;
  control::Memory memory{0};
  std::optional<LoadedProgram> program{};
};

/// Machines on disk, a folder each: `machine.toml`, `memory.json` (as `kerf run --state` writes it)
/// and `program.json`. Each file is replaced as a whole and is on the disk when a call returns; a
/// crash at any moment leaves the old one or the new one, and of a machine that is made or removed
/// all or nothing. What fails has changed nothing. Failure (output, or input for what cannot be
/// read).
class MachineStore {
 public:
  /// Makes the folder if it is not there, and removes what a server has left that was killed.
  [[nodiscard]] static base::Outcome<MachineStore> open(const std::string& folder);

  /// What there is, in the order of the names; what cannot be read goes into `troubles` as
  /// sentences and stays on the disk as it is.
  [[nodiscard]] std::vector<StoredMachine> read_all(std::vector<std::string>& troubles) const;

  /// Failure (output) also where a machine of the name is on the disk that cannot be read.
  [[nodiscard]] base::Outcome<void> add(const StoredMachine& machine) const;
  [[nodiscard]] base::Outcome<void> remove(const std::string& name) const;
  [[nodiscard]] base::Outcome<void> write_memory(const std::string& name,
                                                 const control::Memory& memory) const;
  [[nodiscard]] base::Outcome<void> write_definition(const std::string& name,
                                                     const std::string& kind,
                                                     const std::string& toml) const;
  [[nodiscard]] base::Outcome<void> write_program(const std::string& name,
                                                  const LoadedProgram& program) const;

 private:
  explicit MachineStore(std::string folder) : folder_(std::move(folder)) {}
  [[nodiscard]] std::string file(const std::string& machine, const char* name) const {
    return folder_ + "/" + machine + "/" + name;
  }
  [[nodiscard]] base::Outcome<StoredMachine> read(const std::string& name) const;
  [[nodiscard]] base::Outcome<void> write_all(const std::string& name,
                                              const StoredMachine& machine) const;
  [[nodiscard]] base::Outcome<void> take_name(const std::string& from, const std::string& to) const;

  std::string folder_;
};

}  // namespace kerf::server
