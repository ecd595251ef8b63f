#pragma once

#include <string_view>
#include <vector>

namespace kerf::server {

/// A program of examples/ that is compiled in. The library has it from the first start on, also
/// where no machine has it loaded.
struct Sample {
  std::string_view file;
  std::string_view text;
};
[[nodiscard]] const std::vector<Sample>& samples();

/// What stands in a server at its first start: a machine of each kind with a program for it.
struct FirstMachine {
  std::string_view name;
  std::string_view kind;     ///< a built-in machine
  std::string_view program;  ///< a sample
};
[[nodiscard]] const std::vector<FirstMachine>& first_machines();

}  // namespace kerf::server
