#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/source_file.hpp"
#include "machine/definition/machine_definition.hpp"

namespace kerf::machine {

/// For which kind of machine a program looks to be written.
enum class ProgramKind : std::uint8_t {
  any,          ///< G-code that shows no preference
  mill,         ///< tool changes, tool length, drilling cycles
  lathe,        ///< offsets in T, constant surface speed, U and W, cycles along a shape; no Y
  lathe_c,      ///< likewise, and it turns C as an axis or drives tools
  laser,        ///< G-code whose S is the power of a beam
  laser_basic,  ///< laser BASIC
  teach,        ///< taught points
  motion,       ///< motion records; for which machine, machine_for() tells
  pattern       ///< bytes of the pattern database of the engraving arm
};

/// "lathe", "lathe-c"
[[nodiscard]] std::string_view name_of(ProgramKind kind);

/// Whether a lathe makes it.
[[nodiscard]] constexpr bool is_lathes(ProgramKind kind) {
  return kind == ProgramKind::lathe || kind == ProgramKind::lathe_c;
}

/// What a program looks like, and where that shows.
struct ProgramLook {
  ProgramKind kind = ProgramKind::any;
  std::uint32_t line = 0;  ///< from 1; 0: its name shows it, or nothing does
  std::string word;        ///< what shows it: "T0101"; empty likewise
};

/// By its ending, else by its first lines (registry.hpp), else by the words of the first 64 KiB. A
/// guess: where the signs do not agree it is `any`.
[[nodiscard]] ProgramLook look_of(const base::SourceFile& program);

/// Whether a machine of this definition makes programs of that kind.
[[nodiscard]] bool suits(const MachineDefinition& machine, ProgramKind kind);

/// The built-in machine for it: "laser3".
[[nodiscard]] std::string_view usual_machine(ProgramKind kind);

}  // namespace kerf::machine
