#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kerf::machine {

/// Whose a variable is.
enum class VariableScope : std::uint8_t {
  local,      ///< of a level of the calls: #1 to #33
  common,     ///< until power-off: #100 to #199
  permanent,  ///< kept in the memory: #500 to #999
  program     ///< of the program as a whole: variables of BASIC
};

struct VariableRow {
  std::string name;   ///< "#100", "COUNT"
  std::string label;  ///< a name that the program gave it by SETVN; mostly empty
  double value = 0;   ///< vm::kNull: vacant
  VariableScope scope = VariableScope::program;
  std::size_t level = 0;  ///< of a local one
  bool changed = false;   ///< since the machine stopped the last time
};

/// Variables in the order of their language: all local ones of a level, of the others those that
/// are not vacant.
struct VariableListing {
  std::vector<VariableRow> rows;
  std::vector<VariableScope> scopes;  ///< that the language has
  std::size_t levels = 0;             ///< of calls that are open
};

}  // namespace kerf::machine
