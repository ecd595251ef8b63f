#include "face/cli/failure.hpp"

#include <cstdio>

#include "output/writing/diagnostic_text.hpp"

namespace kerf::cli {

ExitStatus fail(const base::Failure& failure) {
  const std::string line = "kerf: " + output::printable(failure.message) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
  return status_of(failure);
}

}  // namespace kerf::cli
